"""Parameters, mission and sensors as the records that compiled code reads: degrees become radians here."""

from math import radians
from statistics import NormalDist

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.allocation.record import MDCA, PID_DIRECT, SPEED_LINEAR, THRUST_LINEAR, WLS
from bumpless.control.guidance.record import AALOS, ALOS
from bumpless.control.plan import PLAN
from bumpless.control.switching import KEEP, RESCALE, RESET
from bumpless.physics.sensors import SENSORS

ALLOCATORS = {"mdca": MDCA, "wls": WLS, "pid_direct": PID_DIRECT}
INTEGRALS = {"keep": KEEP, "rescale": RESCALE, "reset": RESET}
DIRECT_MAPS = {"thrust": THRUST_LINEAR, "shaft_speed": SPEED_LINEAR}
LAWS = {"alos": ALOS, "aalos_fossen2024": AALOS}


def fill_settings(out: np.void, vehicle: Vehicle, parameters: Parameters) -> None:
    """Fill a SETTINGS record, section by section."""
    out["dt"] = vehicle.control_period_s
    _supervisor(out["supervisor"], parameters)
    _bumpless(out["bumpless"], parameters)
    _allocation(out["allocation"], parameters)
    _guidance(out["guidance"], parameters)
    for row, mode in zip(out["modes"], parameters.modes, strict=True):
        row["Q"], row["lam"], row["n_sw"] = mode.q_diagonal, mode.lambda_, mode.ramp_cycles
        row["R"][: len(mode.r_diagonal)] = mode.r_diagonal
        row["K_P"], row["K_I"], row["K_D"] = mode.kp, mode.ki, mode.kd
        row["increment_share"] = mode.increment_share
        row["integral_limit"], row["demand_limit"] = mode.integral_limit, mode.demand_limit


def _supervisor(s: np.void, parameters: Parameters) -> None:
    sup = parameters.supervisor
    s["d_rh_l"], s["d_rh_u"] = sup.range_rh_lower_m, sup.range_rh_upper_m
    s["d_fr_l"], s["d_fr_u"] = sup.range_fr_lower_m, sup.range_fr_upper_m
    s["d_hf_u"], s["n_dwell"] = sup.range_hf_upper_m, sup.dwell_cycles
    s["hits"], s["window"] = sup.detection_hits, sup.detection_window
    s["hold"] = sup.detection_hold_cycles


def _bumpless(s: np.void, parameters: Parameters) -> None:
    bump = parameters.bumpless
    s["ramp"], s["align"], s["project"] = bump.ramp, bump.integrator_alignment, bump.warm_start_projection
    s["align_channels"] = bump.align_channels
    s["align_bleed"], s["scale_integration"] = bump.align_bleed_s, bump.scale_integration
    s["integral_at_switch"] = INTEGRALS[bump.integral_at_switch]
    s["ramp_increment_share"] = bump.ramp_increment_share
    s["ramp_increment_price"] = bump.ramp_increment_price


def _allocation(s: np.void, parameters: Parameters) -> None:
    alloc = parameters.allocation
    s["allocator"] = ALLOCATORS[alloc.allocator]
    s["sqp_iterations"], s["kkt_tolerance"] = alloc.sqp_iterations, alloc.kkt_tolerance
    s["fault_tolerant"], s["anti_windup"] = alloc.fault_tolerant, alloc.anti_windup_per_s
    s["estimate"], s["fault_evidence"] = alloc.effectiveness == "estimated", alloc.fault_evidence
    s["effectiveness_blend"] = alloc.effectiveness_blend_s
    s["increment_price"], s["direct_map"] = alloc.increment_price, DIRECT_MAPS[alloc.direct_map]
    s["degraded_map"], s["priority"], s["slack_price"] = alloc.degraded_map, alloc.priority, alloc.slack_price
    s["fault_gains"] = alloc.fault_kp, alloc.fault_ki, alloc.fault_kd
    s["easing_made_up"] = alloc.easing_made_up


def _guidance(s: np.void, parameters: Parameters) -> None:
    guide = parameters.guidance
    s["law"], s["look_ahead"], s["gamma"] = LAWS[guide.law], guide.look_ahead_m, guide.adaptation_gain
    s["pitch_look_ahead"], s["pitch_gamma"] = guide.pitch_look_ahead_m, guide.pitch_adaptation_gain
    s["pitch_max"], s["speed_min"] = radians(guide.pitch_max_deg), guide.speed_min_mps
    s["depth_rate"], s["acceleration"] = guide.depth_rate_mps, guide.acceleration_mps2
    s["reverse_slope"], s["reverse_offset"] = guide.reverse_speed_slope_per_s, guide.reverse_speed_offset_mps
    s["reverse_max"] = guide.reverse_speed_max_mps
    s["hover_gain"], s["hover_max"] = guide.hover_speed_gain_per_s, guide.hover_speed_max_mps
    s["hover_cross_gain"] = guide.hover_cross_gain
    s["schedule_speed"], s["schedule_min"] = guide.schedule_speed_mps, guide.schedule_min
    s["scheduled"] = guide.scheduled_channels
    s["schedule_limits"], s["flow_filter"] = guide.schedule_limits, guide.flow_filter_s
    s["flow_drift"] = guide.flow_drift
    s["flow_rates"], s["heading_rate"] = guide.flow_rates, radians(guide.heading_rate_degps)
    s["crab_gain"] = guide.crab_gain
    s["error_filter"], s["rate_filter"] = guide.error_filter_s, guide.rate_filter_s


def plan_of(mission: Mission, period_s: float) -> np.ndarray:
    """PLAN record of a mission, shape (1,), but for what `sim.truth.tell` adds: the start and the faults.

    Durations become counts of control periods: sums of period_s miss them by rounding.
    """
    out = np.zeros(1, PLAN)
    p = out[0]
    path = mission.path_ned_m
    p["n_legs"] = len(mission.legs)
    p["waypoint"][: len(path)] = path
    p["speed"][: len(mission.legs)] = [leg.speed_mps for leg in mission.legs]
    p["target"] = [*mission.target.position_ned_m, radians(mission.target.heading_deg)]
    p["standoff"] = mission.target.standoff_m
    p["cycles"] = round(mission.duration_s / period_s)
    hold_s = mission.end.hover_hold_s
    p["hold_cycles"] = 0 if hold_s is None else max(1, round(hold_s / period_s))
    return out


def _score(probability: float) -> float:
    """z below which a standard normal sample falls with this probability."""
    if probability <= 0.0:
        return -np.inf
    return np.inf if probability >= 1.0 else NormalDist().inv_cdf(probability)


def sensors_of(vehicle: Vehicle, mission: Mission) -> np.ndarray:
    """SENSORS record of a vehicle with a mission's changes, shape (1,)."""
    out = np.zeros(1, SENSORS)
    s, v, change = out[0], vehicle.sensors, mission.sensors.detection
    rate = 1.0 / vehicle.control_period_s
    s["roll_pitch_std"], s["heading_std"] = (
        radians(v.ins.roll_pitch_noise_deg),
        radians(v.ins.heading_noise_deg),
    )
    s["heading_bias_std"], s["rate_std"] = radians(v.ins.heading_bias_deg), radians(v.ins.rate_noise_degps)
    s["dvl_std"], s["dvl_water_std"] = v.dvl.ground_velocity_noise_mps, v.dvl.water_velocity_noise_mps
    s["dvl_period"], s["dvl_dropout"] = max(1, round(rate / v.dvl.rate_hz)), _score(v.dvl.dropout_probability)
    s["depth_std"], s["depth_bias_std"] = v.depth.depth_noise_m, v.depth.depth_bias_m
    c = v.camera
    s["camera_position"], s["camera_pitch"] = c.position_m, radians(c.pitch_down_deg)
    half, reach, missed = c.field_of_view_half_deg, c.range_max_m, c.dropout_probability
    if change is not None:
        half = half if change.field_of_view_half_deg is None else change.field_of_view_half_deg
        reach = reach if change.range_max_m is None else change.range_max_m
        missed = missed if change.dropout_probability is None else change.dropout_probability
    s["camera_half_angle"], s["camera_range_max"] = radians(half), reach
    s["camera_range_min"], s["camera_dropout"] = c.range_min_m, _score(missed)
    s["camera_period"] = max(1, round(rate / c.rate_hz))
    s["camera_range_std"], s["camera_bearing_std"] = c.range_noise_share, radians(c.bearing_noise_deg)
    return out
