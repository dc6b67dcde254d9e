"""How references are made, and how gains follow speed."""

from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, Row, Switch, model
from bumpless.config.names import ERRORS

PathLaw = Literal["alos", "aalos_fossen2024"]


@model
class GuidanceParameters:
    """How references are made, and how gains follow speed.

    Source: Gao et al. 2026, eqs. (41)-(44); the speed laws are ours.
    """

    law: Annotated[
        PathLaw,
        Choice("Path law", record="law", help="ALOS of eq. (41), or AALOS of Fossen and Aguiar 2024."),
    ] = "alos"
    look_ahead_m: Annotated[float, Number("Δ, look-ahead distance", "m", 0.1, 200.0, record="look_ahead")] = (
        5.0
    )
    adaptation_gain: Annotated[float, Number("γ, adaptation to drift", "1/s", 0.0, 10.0, record="gamma")] = (
        0.002
    )
    depth_rate_mps: Annotated[
        float, Number("Fastest change of the depth reference", "m/s", 0.001, 2.0, record="depth_rate")
    ] = 0.02
    pitch_look_ahead_m: Annotated[
        float,
        Number("Look-ahead of depth by pitch; 0: by heave", "m", 0.0, 200.0, record="pitch_look_ahead",
               help="A vehicle without heave needs it."),
    ] = 0.0  # fmt: skip
    pitch_adaptation_gain: Annotated[
        float, Number("Adaptation of the trim pitch", "1/s", 0.0, 10.0, record="pitch_gamma")
    ] = 0.01
    pitch_max_deg: Annotated[
        float, Number("Largest pitch demanded for depth", "deg", 0.0, 45.0, record="pitch_max")
    ] = 20.0
    speed_min_mps: Annotated[
        float,
        Number("Slowest surge reference", "m/s", 0.0, 3.0, record="speed_min",
               help="Below it the fins do not steer."),
    ] = 0.0  # fmt: skip
    acceleration_mps2: Annotated[
        float, Number("Fastest change of the speed reference", "m/s²", 0.0, 5.0, record="acceleration")
    ] = 0.05
    reverse_speed_slope_per_s: Annotated[
        float,
        Number("Approach speed per metre of range", "1/s", 0.0, 5.0, record="reverse_slope",
               help="u_d = slope · range + offset, at most the maximum."),
    ] = 0.08  # fmt: skip
    reverse_speed_offset_mps: Annotated[
        float, Number("Approach speed at the target", "m/s", 0.0, 2.0, record="reverse_offset")
    ] = 0.08
    reverse_speed_max_mps: Annotated[
        float, Number("Fastest approach", "m/s", 0.0, 3.0, record="reverse_max")
    ] = 0.4
    hover_speed_gain_per_s: Annotated[
        float, Number("Hover speed per metre of offset", "1/s", 0.0, 5.0, record="hover_gain")
    ] = 0.1
    hover_speed_max_mps: Annotated[
        float, Number("Fastest correction in hover", "m/s", 0.0, 2.0, record="hover_max")
    ] = 0.1
    hover_cross_gain: Annotated[
        float,
        Number("Share of the cross-track law kept in hover", "", 0.0, 1.0, record="hover_cross_gain",
               help="Scaled by the inflow."),
    ] = 0.5  # fmt: skip
    schedule_speed_mps: Annotated[
        float,
        Number("Speed from which scheduled gains are full", "m/s", 0.0, 5.0, record="schedule_speed",
               help="Through the water."),
    ] = 0.3  # fmt: skip
    schedule_min: Annotated[
        float, Number("Least share of a scheduled gain", "", 0.0, 1.0, record="schedule_min")
    ] = 0.2
    scheduled_channels: Annotated[
        tuple[float, ...],
        Row("Channels whose gains follow speed", "", 0.0, 1.0, names=ERRORS, record="scheduled",
            help="1 where they do."),
    ] = (0.0, 0.0, 0.0, 0.0, 1.0, 1.0)  # fmt: skip
    schedule_limits: Annotated[
        bool,
        Switch("Limits follow speed as well", record="schedule_limits",
               help="Integral and demand limits of scheduled channels."),
    ] = False  # fmt: skip
    flow_filter_s: Annotated[
        float,
        Number("Lag on the estimated flow", "s", 0.0, 100.0, record="flow_filter",
               help="On the velocity through water that schedule and allocator see."),
    ] = 0.0  # fmt: skip
    flow_drift: Annotated[
        float,
        Number("Share of sway and heave in the flow", "", 0.0, 1.0, record="flow_drift",
               help="Fins steady the hull unless the allocator undoes it."),
    ] = 1.0  # fmt: skip
    flow_rates: Annotated[
        float,
        Number("Share of turning rates in the flow", "", 0.0, 1.0, record="flow_rates",
               help="Fins damp turning unless the allocator undoes it."),
    ] = 1.0  # fmt: skip
    heading_rate_degps: Annotated[
        float,
        Number("Fastest change of the heading reference", "deg/s", 0.0, 180.0, record="heading_rate",
               help="0: no limit."),
    ] = 0.0  # fmt: skip
    crab_gain: Annotated[
        float,
        Number("Share of the drift made good by heading", "", 0.0, 1.0, record="crab_gain",
               help="Of the estimated drift, at once."),
    ] = 0.0  # fmt: skip
    error_filter_s: Annotated[
        tuple[float, ...],
        Row("Lag on the errors before the PID", "s", 0.0, 100.0, names=ERRORS, record="error_filter"),
    ] = (0.0,) * 6
    rate_filter_s: Annotated[
        tuple[float, ...],
        Row("Lag on the error rates before the PID", "s", 0.0, 100.0, names=ERRORS, record="rate_filter"),
    ] = (0.0,) * 6
