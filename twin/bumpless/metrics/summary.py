"""Every figure of a run in one message."""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import FORWARD, HOVER, REVERSE, SOLVED
from bumpless.contract.messages import as_json
from bumpless.contract.units import DEG, EDGE_PER_SI, WRENCH
from bumpless.metrics.capture import capture_of
from bumpless.metrics.columns import Columns, Floats, lengths
from bumpless.metrics.cost import cost_of
from bumpless.metrics.modes import ModeFigures, mode_figures
from bumpless.metrics.proposition import demand_step_violations, increment_violations
from bumpless.metrics.switches import SwitchSteps, largest, switch_steps

MOST_MISSING = 2**32 - 1  # that the contract can tell

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

AT_BOUND = 1e-6  # closer than this share of the span counts as at the bound


def metrics_of(run: Columns, vehicle: "Vehicle", run_id: str = "", *, checks: bool = True) -> pb.Metrics:
    """Figures of merit of a run of `vehicle`; figures of what did not happen are NaN.

    e_tau = tau_d - tau_c over the vehicle's controllable components, N and N m together as the paper
    has it; tau_c is the allocator's model in `residual_rms` and the plant's true wrench in
    `residual_rms_true`. A command is at a bound within AT_BOUND of its amplitude span.
    checks: with what tells of the allocator and of Proposition 1: bounds met, violations, solve times.
    Source: Gao et al. 2026, section 4.1 and tables 5 to 8.
    """
    edge = np.array([EDGE_PER_SI[c.unit] for c in vehicle.commands])
    lower = np.array([c.lower for c in vehicle.commands]) / edge
    upper = np.array([c.upper for c in vehicle.commands]) / edge
    bounds = np.maximum(np.abs(lower), np.abs(upper))
    served = np.array([name in vehicle.controllable for name in WRENCH], float)
    message = pb.Metrics(run_id=run_id, cycles=len(run), missing_cycles=min(run.missing, MOST_MISSING))
    if len(run) == 0:
        return message
    residual = lengths((run.tau_d - run.tau_c) * served)
    steps = switch_steps(run, bounds, edge)
    message.duration_s = float(run.time[-1] - run.time[0]) + vehicle.control_period_s
    message.residual_rms = _rms(residual)
    message.residual_rms_true = _rms(lengths((run.tau_d - run.tau) * served))
    message.solved_ratio = float(np.mean(run.status == SOLVED))
    message.d_u_fr, message.d_u_fr_settling = largest(steps, FORWARD, REVERSE)
    message.d_u_rh, message.d_u_rh_settling = largest(steps, REVERSE, HOVER)
    message.switches.extend(_switch(run, s) for s in steps)
    for figures in mode_figures(run, residual):
        message.modes.append(_mode(figures, vehicle.control_period_s, edge))
    cost = cost_of(run, vehicle)
    message.shaft_energy_j, message.fin_travel_deg = cost.shaft_energy_j, cost.fin_travel_deg
    message.screw_reversals = cost.screw_reversals
    dock = capture_of(run)
    if dock:
        message.capture.CopyFrom(dock.message())
    message.final_range_m = float(run.range[-1])
    if checks:
        message.saturation_ratio = _saturation_ratio(run, lower, upper)
        message.increment_violations = increment_violations(run, lower, upper)
        message.demand_step_violations = demand_step_violations(run)
        _solve_times(message, run.solve_time * 1e6)
    return message


def as_dict(metrics: pb.Metrics) -> dict[str, Any]:
    """For JSON: the contract's field names, every field present, None for NaN."""
    return _without_nan(as_json(metrics))


def _without_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_without_nan(item) for item in value]
    return None if value in ("NaN", "Infinity", "-Infinity") else value


def _rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _saturation_ratio(run: Columns, lower: Floats, upper: Floats) -> float:
    near = AT_BOUND * (upper - lower)
    return float(np.mean(np.any((run.u <= lower + near) | (run.u >= upper - near), axis=1)))


def _switch(run: Columns, steps: SwitchSteps) -> pb.SwitchMetrics:
    late = steps.settling
    return pb.SwitchMetrics(
        from_mode=cast("pb.Mode", steps.from_mode),
        to_mode=cast("pb.Mode", steps.to_mode),
        time_s=float(run.time[steps.row]),
        command_step_normalised=steps.normalised,
        command_step_raw=steps.raw,
        actuator_step=steps.per_actuator.tolist(),
        settling_s=late.seconds,
        command_step_settling=late.normalised,
        force_step_n=late.force,
        moment_step_nm=late.moment,
        acceleration_step_mps2=late.acceleration,
        angular_acceleration_step_degps2=late.angular_acceleration * DEG,
    )


def _mode(figures: ModeFigures, period_s: float, edge: Floats) -> pb.ModeMetrics:
    roll, pitch, yaw = figures.attitude_rms * DEG
    rms, largest_error = figures.tracking.rms, figures.tracking.largest
    return pb.ModeMetrics(
        mode=cast("pb.Mode", figures.mode),
        duration_s=figures.samples * period_s,
        samples=figures.samples,
        depth_rms_m=figures.depth_rms,
        depth_peak_to_peak_m=figures.depth_peak_to_peak,
        roll_rms_deg=roll,
        pitch_rms_deg=pitch,
        yaw_rms_deg=yaw,
        surge_speed_mean_mps=figures.surge_mean,
        actuator_rms=(figures.command_rms * edge).tolist(),
        residual_rms=figures.residual_rms,
        depth_error_rms_m=rms[0],
        depth_error_max_m=largest_error[0],
        cross_track_error_rms_m=rms[1],
        cross_track_error_max_m=largest_error[1],
        heading_error_rms_deg=rms[2],
        heading_error_max_deg=largest_error[2],
        speed_error_rms_mps=rms[3],
        speed_error_max_mps=largest_error[3],
    )


def _solve_times(message: pb.Metrics, micros: Floats) -> None:
    message.solve_time_mean_us = float(micros.mean())
    message.solve_time_std_us = float(micros.std())
    message.solve_time_p95_us = float(np.percentile(micros, 95))
    message.solve_time_max_us = float(micros.max())
