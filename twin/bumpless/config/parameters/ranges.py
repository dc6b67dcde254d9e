"""The one table of what each number may be: files, the vehicle's answers and the screen use it."""

from dataclasses import dataclass

MODES = ("forward", "reverse", "hover")
ACTUATORS = -1  # as a count: one number per actuator


@dataclass(frozen=True)
class Range:
    """Bounds of one number, both included, or of each number of a row (`count`)."""

    path: str  # "forward.q_diagonal"
    unit: str
    min: float
    max: float
    label: str
    count: int = 0  # 0: one number; 6: one per wrench component; ACTUATORS: one per actuator
    live: bool = False  # may change during a mission


# fmt: off
_MODE = (
    Range("q_diagonal", "1/N² or 1/(N·m)²", 0.0, 1e6, "Q, weight of the wrench error", 6, True),
    Range("r_diagonal", "1", 1e-6, 1e6, "R, weight of the commands", ACTUATORS, True),
    Range("lambda", "1", 1e-9, 1e3, "λ, price of commands", 0, True),
    Range("ramp_cycles", "cycles", 0, 1000, "N_sw, ramp into this mode", 0, True),
    Range("kp", "N or N·m per unit error", 0.0, 1e4, "K_P", 6),
    Range("ki", "N or N·m per unit error and second", 0.0, 1e4, "K_I", 6),
    Range("kd", "N or N·m per unit error rate", 0.0, 1e4, "K_D", 6),
    Range("integral_limit", "N or N·m", 0.0, 1e4, "Bound of the integral action", 6),
    Range("demand_limit", "N or N·m", 0.0, 1e5, "Bound of the demand", 6),
    Range("increment_share", "1", 0.001, 1.0, "Share of the rate limits in use"),
)
_FLAT = (
    Range("supervisor.range_rh_lower_m", "m", 0.01, 1000.0, "d_RH^L, reverse to hover", live=True),
    Range("supervisor.range_rh_upper_m", "m", 0.01, 1000.0, "d_RH^U, hover to reverse", live=True),
    Range("supervisor.range_fr_lower_m", "m", 0.01, 1000.0, "d_FR^L, forward to reverse", live=True),
    Range("supervisor.range_fr_upper_m", "m", 0.01, 1000.0, "d_FR^U, reverse to forward", live=True),
    Range("supervisor.range_hf_upper_m", "m", 0.01, 1000.0, "d_HF^U, hover to forward", live=True),
    Range("supervisor.dwell_cycles", "cycles", 0, 10000, "N_dwell, shortest stay in a mode", live=True),
    Range("supervisor.detection_hits", "frames", 1, 62, "M, detections needed", live=True),
    Range("supervisor.detection_window", "frames", 1, 62, "N, out of this many", live=True),
    Range("supervisor.detection_hold_cycles", "frames", 0, 10000, "Detection held for", live=True),
    Range("bumpless.align_channels", "1", 0.0, 1.0, "Channels whose integrators are aligned", 6),
    Range("bumpless.align_bleed_s", "s", 0.0, 1000.0, "Decay of the aligned offset; 0 keeps it"),
    Range("bumpless.ramp_increment_share", "1", 0.001, 1.0, "Share of the rate limits as a ramp begins"),
    Range("bumpless.ramp_increment_price", "1", 0.0, 1e6, "Price of increments as a ramp begins"),
    Range("allocation.sqp_iterations", "1", 1, 50, "SQP iterations per cycle"),
    Range("allocation.kkt_tolerance", "1", 1e-12, 1.0, "KKT residual that counts as solved"),
    Range("allocation.fault_evidence", "1", 3.0, 1000.0, "Log-likelihood ratio that makes a fault"),
    Range("allocation.effectiveness_blend_s", "s", 0.0, 60.0, "Blend of an estimated loss"),
    Range("allocation.anti_windup_per_s", "1/s", 0.0, 100.0, "Residual fed back into the integrals"),
    Range("allocation.increment_price", "1", 0.0, 1e6, "Price of increments"),
    Range("allocation.shaft_smoothing", "1", 0.0, 1.0, "Thrust share eased through zero"),
    Range("allocation.priority", "1", 0.0, 1e6, "Factors on Q after a known fault", 6),
    Range("allocation.fault_kp", "1", 0.0, 100.0, "Factors on K_P after a known fault", 6),
    Range("allocation.fault_ki", "1", 0.0, 100.0, "Factors on K_I after a known fault", 6),
    Range("allocation.fault_kd", "1", 0.0, 100.0, "Factors on K_D after a known fault", 6),
    Range("allocation.slack_price", "1/N² or 1/(N·m)²", 0.0, 1e9, "P, price of slack; 0 allows none", 6),
    Range("guidance.look_ahead_m", "m", 0.1, 200.0, "Δ, look-ahead distance"),
    Range("guidance.adaptation_gain", "1/s", 0.0, 10.0, "γ, adaptation to drift"),
    Range("guidance.depth_rate_mps", "m/s", 0.001, 2.0, "Fastest change of the depth reference"),
    Range("guidance.pitch_look_ahead_m", "m", 0.0, 200.0, "Look-ahead of depth by pitch; 0: by heave"),
    Range("guidance.pitch_adaptation_gain", "1/s", 0.0, 10.0, "Adaptation of the trim pitch"),
    Range("guidance.pitch_max_deg", "deg", 0.0, 45.0, "Largest pitch demanded for depth"),
    Range("guidance.speed_min_mps", "m/s", 0.0, 3.0, "Slowest surge reference"),
    Range("guidance.acceleration_mps2", "m/s²", 0.0, 5.0, "Fastest change of the speed reference"),
    Range("guidance.reverse_speed_slope_per_s", "1/s", 0.0, 5.0, "Approach speed per metre of range"),
    Range("guidance.reverse_speed_offset_mps", "m/s", 0.0, 2.0, "Approach speed at the target"),
    Range("guidance.reverse_speed_max_mps", "m/s", 0.0, 3.0, "Fastest approach"),
    Range("guidance.hover_speed_gain_per_s", "1/s", 0.0, 5.0, "Hover speed per metre of offset"),
    Range("guidance.hover_speed_max_mps", "m/s", 0.0, 2.0, "Fastest correction in hover"),
    Range("guidance.hover_cross_gain", "1", 0.0, 1.0, "Share of the cross-track law kept in hover"),
    Range("guidance.schedule_speed_mps", "m/s", 0.0, 5.0, "Speed from which scheduled gains are full"),
    Range("guidance.schedule_min", "1", 0.0, 1.0, "Least share of a scheduled gain"),
    Range("guidance.scheduled_channels", "1", 0.0, 1.0, "Channels whose gains follow speed", 6),
    Range("guidance.flow_filter_s", "s", 0.0, 100.0, "Lag on the estimated flow"),
    Range("guidance.flow_drift", "1", 0.0, 1.0, "Share of sway and heave in the flow"),
    Range("guidance.flow_rates", "1", 0.0, 1.0, "Share of turning rates in the flow"),
    Range("guidance.heading_rate_degps", "°/s", 0.0, 180.0, "Fastest change of the heading reference"),
    Range("guidance.crab_gain", "1", 0.0, 1.0, "Share of the drift made good by heading"),
    Range("guidance.error_filter_s", "s", 0.0, 100.0, "Lag on the errors before the PID", 6),
    Range("guidance.rate_filter_s", "s", 0.0, 100.0, "Lag on the error rates before the PID", 6),
)
# fmt: on

RANGES: tuple[Range, ...] = (
    *(
        Range(f"{mode}.{r.path}", r.unit, r.min, r.max, r.label, r.count, r.live)
        for mode in MODES
        for r in _MODE
    ),
    *_FLAT,
)
