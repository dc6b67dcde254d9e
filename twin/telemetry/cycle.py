"""One LOG row -> the messages of one control cycle."""

import math
from collections.abc import Sequence
from struct import Struct
from typing import cast

import numpy as np
from google.protobuf.message import Message

from twin.contract import bumpless_pb2 as pb
from twin.records import LOG
from twin.telemetry.context import ActuatorContext, Context

_DEG = 180.0 / math.pi
_VALUES = {name: LOG[name].itemsize // 8 for name in LOG.names or ()}
_UNPACK = Struct("=" + "".join(("q" if LOG[n].base.kind == "i" else "d") * _VALUES[n] for n in _VALUES))


def _slices() -> dict[str, slice]:
    places, at = {}, 0
    for name, count in _VALUES.items():
        places[name] = slice(at, at + count)
        at += count
    return places


_AT = _slices()
_FIRST = {name: place.start for name, place in _AT.items()}


class _Row:
    """The numbers of a row as plain Python ones, unpacked once: much faster than field by field."""

    __slots__ = ("_numbers",)

    def __init__(self, row: np.void) -> None:
        self._numbers = _UNPACK.unpack(row.tobytes())

    def one(self, name: str) -> float:
        return self._numbers[_FIRST[name]]

    def all(self, name: str) -> Sequence[float]:
        return self._numbers[_AT[name]]


def messages(
    row: np.void, context: Context, time_ns: int | None = None, cycle: int | None = None
) -> list[tuple[str, Message]]:
    """What one control cycle says, as (topic, message) in a fixed order.

    `row` is one element of a LOG array (SI, radians); topics are keys after the vehicle's name, such as
    "tlm/navigation" or "truth/state". `time_ns` is the UNIX time of the cycle; without it the time is
    the context's start plus mission time, so that a simulation's log depends on nothing but the row.
    `cycle` counts since the node started; without it the row's own count is told.
    """
    r = _Row(row)
    if time_ns is None:
        time_ns = context.start_time_ns + round(r.one("time") * 1e9)
    stamp = pb.Stamp(
        time_ns=time_ns,
        mission_time_s=r.one("time"),
        cycle=int(r.one("cycle")) if cycle is None else cycle,
    )
    return [
        ("tlm/navigation", _navigation(r, stamp)),
        ("tlm/guidance", _guidance(r, stamp)),
        ("tlm/supervisor", _supervisor(r, stamp, context)),
        ("tlm/control", _control(r, stamp)),
        ("tlm/actuators", actuators := _actuators(r, stamp, context)),
        ("tlm/allocation", _allocation(r, stamp, context, actuators)),
        ("tlm/target", _target(r, stamp)),
        ("truth/state", _truth(r, stamp, len(context.actuators))),
    ]


def _vector(v: Sequence[float], scale: float = 1.0) -> pb.Vector3:
    return pb.Vector3(x=v[0] * scale, y=v[1] * scale, z=v[2] * scale)


def _attitude(v: Sequence[float]) -> pb.Attitude:
    return pb.Attitude(roll_deg=v[0] * _DEG, pitch_deg=v[1] * _DEG, yaw_deg=v[2] * _DEG)


def _wrench(v: Sequence[float]) -> pb.Wrench:
    return pb.Wrench(x_n=v[0], y_n=v[1], z_n=v[2], k_nm=v[3], m_nm=v[4], n_nm=v[5])


def _navigation(r: _Row, stamp: pb.Stamp) -> pb.Navigation:
    eta, nu = r.all("eta_hat"), r.all("nu_hat")
    return pb.Navigation(
        stamp=stamp,
        position_ned_m=_vector(eta),
        attitude=_attitude(eta[3:]),
        velocity_body_mps=_vector(nu),
        velocity_through_water_body_mps=_vector(r.all("nu_r_hat")),
        angular_rate_body_degps=_vector(nu[3:], _DEG),
        depth_m=r.one("depth"),
        speed_over_ground_mps=math.hypot(nu[0], nu[1], nu[2]),
        current_estimate_ned_mps=_vector(r.all("current_hat")),
    )


def _guidance(r: _Row, stamp: pb.Stamp) -> pb.Guidance:
    u, v, z, *attitude = r.all("reference")
    return pb.Guidance(
        stamp=stamp,
        surge_speed_reference_mps=u,
        sway_speed_reference_mps=v,
        depth_reference_m=z,
        attitude_reference=_attitude(attitude),
        cross_track_error_m=r.one("cross_track"),
        along_track_error_m=r.one("along_track"),
        leg=max(0, int(r.one("leg"))),
        leg_count=int(r.one("leg_count")),
    )


def _mode(value: float) -> pb.Mode:
    """records.FORWARD, REVERSE, HOVER count from 0, the contract from 1."""
    return cast("pb.Mode", int(value) + 1)


def _supervisor(r: _Row, stamp: pb.Stamp, context: Context) -> pb.Supervisor:
    thresholds = context.supervisor
    return pb.Supervisor(
        stamp=stamp,
        mode=_mode(r.one("mode")),
        previous_mode=_mode(r.one("previous_mode")),
        range_m=r.one("range"),
        detection_raw=bool(r.one("detected_raw")),
        detection=bool(r.one("detected")),
        kappa=r.one("kappa"),
        time_in_mode_s=r.one("time_in_mode"),
        dwell_remaining_s=r.one("dwell_remaining"),
        range_rh_lower_m=thresholds.range_rh_lower_m,
        range_rh_upper_m=thresholds.range_rh_upper_m,
        range_fr_lower_m=thresholds.range_fr_lower_m,
        range_fr_upper_m=thresholds.range_fr_upper_m,
        range_hf_upper_m=thresholds.range_hf_upper_m,
        phase=cast("pb.MissionPhase", int(r.one("phase"))),
    )


def _control(r: _Row, stamp: pb.Stamp) -> pb.Control:
    demanded, achieved = r.all("tau_d"), r.all("tau_c")
    return pb.Control(
        stamp=stamp,
        demanded=_wrench(demanded),
        demanded_raw=_wrench(r.all("tau_plus")),
        achieved=_wrench(achieved),
        residual=_wrench([d - a for d, a in zip(demanded, achieved, strict=True)]),
        frozen=_wrench(r.all("tau_minus")),
    )


def _actuators(r: _Row, stamp: pb.Stamp, context: Context) -> pb.Actuators:
    columns = zip(
        context.actuators,
        r.all("u"),
        r.all("u_feedback"),
        r.all("u_lower"),
        r.all("u_upper"),
        r.all("du_max"),
        strict=False,
    )
    return pb.Actuators(stamp=stamp, actuators=[_actuator(*column) for column in columns])


def _actuator(
    a: ActuatorContext, u: float, feedback: float, lower: float, upper: float, du_max: float
) -> pb.Actuator:
    command, low, high, near = u * a.scale, lower * a.scale, upper * a.scale, a.tolerance
    saturated = command <= a.lower + near or command >= a.upper - near
    bounded = high > low and (command <= low + near or command >= high - near)
    return pb.Actuator(
        name=a.name,
        unit=a.unit,
        command=command,
        feedback=feedback * a.scale,
        lower=low,
        upper=high,
        amplitude_lower=a.lower,
        amplitude_upper=a.upper,
        saturated=saturated,
        rate_limited=bounded and not saturated,
        increment_bound=du_max * a.scale,
    )


def _allocation(r: _Row, stamp: pb.Stamp, context: Context, actuators: pb.Actuators) -> pb.Allocation:
    return pb.Allocation(
        stamp=stamp,
        status=cast("pb.SolveStatus", int(r.one("status"))),
        sqp_iterations=int(r.one("iterations")),
        kkt_residual=r.one("kkt"),
        residual_norm=r.one("residual_norm"),
        cost=r.one("cost"),
        solve_time_us=r.one("solve_time") * 1e6,
        saturated_count=sum(a.saturated for a in actuators.actuators),
        solver=context.solver,
        slack_norm=math.hypot(*r.all("slack")),
    )


def _target(r: _Row, stamp: pb.Stamp) -> pb.Target:
    distance, bearing, elevation = r.all("target_measured")
    estimate = r.all("target")
    return pb.Target(
        stamp=stamp,
        detected=bool(r.one("detected_raw")),
        measured_range_m=distance,
        bearing_deg=bearing * _DEG,
        elevation_deg=elevation * _DEG,
        position_ned_m=_vector(estimate),
        heading_deg=estimate[3] * _DEG,
        observation_point_ned_m=_vector(r.all("observation_point")),
    )


def _truth(r: _Row, stamp: pb.Stamp, n_u: int) -> pb.TruthState:
    eta, nu = r.all("eta"), r.all("nu")
    return pb.TruthState(
        stamp=stamp,
        position_ned_m=_vector(eta),
        attitude=_attitude(eta[3:]),
        velocity_body_mps=_vector(nu),
        angular_rate_body_degps=_vector(nu[3:], _DEG),
        actuator_wrench=_wrench(r.all("tau")),
        current_ned_mps=_vector(r.all("current")),
        effectiveness=r.all("effectiveness")[:n_u],
    )
