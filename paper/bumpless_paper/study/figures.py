"""The figures of merit of one scenario run, with every definition that decides a figure beside its twin.

Source: Gao et al. 2026, sec. 4.2, tables 6 to 8. The paper leaves open what tau_c is, in which unit d_u is
taken and what "deviation" means; each open choice is a name here:

  e_tau      `model`  tau_d minus the map of eq. (28) at the commands and the estimated flow (primary
                      without a fault, where the map is right)
             `true`   tau_d minus the plant's actuator wrench, with lags, passive lift of fins in turns and
                      drift, and faults (primary after a fault, which S5's own map hides)
  d_u        `bound`  commands divided by their amplitude bounds (primary)
             `thrust` the same with a screw's n|n| instead of n
             `mixed`  degrees and rpm in one norm, as printed in the paper
             each with the window from 2 s before to 2 s after the run's own first switch of the kind;
             `1s`     as `bound`, 1 s before to 1 s after
             `15s`    as `bound`, from the switch to 15 s after it, or to the next switch: past every ramp
  deviation  `rms`    of the true angle about its reference, from the fault to the end (primary)
             `10s`    the same over the first 10 s
             `peak`   its largest magnitude
             `moved`  largest change of the angle since the fault, whatever the reference
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.contract.units import EDGE_PER_SI, WRENCH
from bumpless.metrics.columns import Columns
from bumpless.metrics.proposition import demand_step_violations, increment_violations
from bumpless.metrics.summary import AT_BOUND
from bumpless.metrics.switches import WINDOW_S
from bumpless.sim.twin import Result

LONG_S, SHORT_S = 15.0, 1.0  # the other windows about a switch
SHORT_FAULT_S = 10.0

Figures = dict[str, float]
Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Bounds:
    """Amplitude bounds of a vehicle's commands, rad or rev/s, and what turns them into degrees and rpm."""

    lower: Floats  # (n_u,)
    upper: Floats
    edge: Floats
    fin: npt.NDArray[np.bool_]
    served: Floats  # (6,) 1 where the vehicle can act

    @property
    def largest(self) -> Floats:
        """(n_u,) largest magnitude."""
        return np.maximum(np.abs(self.lower), np.abs(self.upper))


def bounds_of(result: Result) -> Bounds:
    """Bounds of the vehicle that flew."""
    commands = result.vehicle.commands
    edge = np.array([EDGE_PER_SI[c.unit] for c in commands])
    return Bounds(
        np.array([c.lower for c in commands]) / edge,
        np.array([c.upper for c in commands]) / edge,
        edge,
        np.isin(np.arange(len(commands)), result.vehicle.slots("fin")),
        np.array([name in result.vehicle.controllable for name in WRENCH], float),
    )


def figures_of(result: Result, fault_time: float | None = None) -> Figures:
    """Every figure of a run, by name; NaN for what did not happen. Angles in rad, times in s or ms."""
    bounds, log = bounds_of(result), result.log
    run = Columns.from_log(log, len(bounds.lower))
    out: Figures = {"duration_s": float(log["time"][-1]) if len(log) else 0.0}
    residual = {
        "true": np.linalg.norm((log["tau_d"] - log["tau"]) * bounds.served, axis=1),
        "model": np.linalg.norm((log["tau_d"] - log["tau_c"]) * bounds.served, axis=1),
    }
    for name, values in residual.items():
        out[f"rms_e_tau_{name}"] = rms(values)
    near = AT_BOUND * (bounds.upper - bounds.lower)
    at_bound = (run.u <= bounds.lower + near) | (run.u >= bounds.upper - near)
    out["r_sat"] = float(np.mean(np.any(at_bound, axis=1)))
    out["r_sat_increment"] = float(np.mean(np.any(np.abs(steps_of(run)) >= run.du_max * (1 - 1e-9), axis=1)))
    for name, before, after in (("FR", FORWARD, REVERSE), ("RH", REVERSE, HOVER)):
        out |= _switch(run, bounds, name, before, after)
    out["switches"] = float(np.count_nonzero(np.diff(run.mode)))
    out |= _flight(log)
    if fault_time is not None:
        out |= _fault(log, residual, fault_time)
    micro = run.solve_time * 1e3
    out |= {
        "runtime_mean_ms": float(micro.mean()),
        "runtime_std_ms": float(micro.std()),
        "runtime_p95_ms": float(np.percentile(micro, 95)),
        "runtime_max_ms": float(micro.max()),
    }
    out["increment_violations"] = float(increment_violations(run, bounds.lower, bounds.upper))
    out["demand_step_violations"] = float(demand_step_violations(run))
    return out


def rms(values: Floats) -> float:
    """Root mean square; NaN of nothing."""
    return float(np.sqrt(np.mean(values**2))) if len(values) else float("nan")


def steps_of(run: Columns) -> Floats:
    """(n, n_u) change of each command from the cycle before; zero in the first row."""
    steps = np.zeros_like(run.u)
    steps[1:] = np.diff(run.u, axis=0)
    return steps


def _switch(run: Columns, bounds: Bounds, name: str, before: int, after: int) -> Figures:
    """d_u in the windows about the first switch from `before` to `after`."""
    rows = np.flatnonzero((run.mode[:-1] == before) & (run.mode[1:] == after)) + 1
    kinds = ("bound", "thrust", "mixed", "1s", "15s", "limit")
    if not len(rows):
        return dict.fromkeys((f"t_{name}", *(f"d_u_{name}_{kind}" for kind in kinds)), float("nan"))
    first = int(rows[0])
    time = float(run.time[first])
    du = steps_of(run)
    share = run.u / bounds.largest
    thrust = np.where(bounds.fin, share, share * np.abs(share))
    norms = {
        "bound": np.linalg.norm(du / bounds.largest, axis=1),
        "thrust": np.linalg.norm(np.diff(thrust, axis=0, prepend=thrust[:1]), axis=1),
        "mixed": np.linalg.norm(du * bounds.edge, axis=1),
        "limit": np.linalg.norm(run.du_max / bounds.largest, axis=1),
    }
    near = np.abs(run.time - time) <= WINDOW_S + 1e-9
    out = {f"d_u_{name}_{kind}": float(norm[near].max()) for kind, norm in norms.items()}
    short = np.abs(run.time - time) <= SHORT_S + 1e-9
    left = np.flatnonzero(run.mode[first:] != after)
    stay = np.arange(len(run.time)) < (first + left[0] if len(left) else len(run.time))
    long = stay & (run.time >= time) & (run.time <= time + LONG_S + 1e-9)
    out[f"d_u_{name}_1s"] = float(norms["bound"][short].max())
    out[f"d_u_{name}_15s"] = float(norms["bound"][long].max())
    return {f"t_{name}": time, **out}


def _flight(log: np.ndarray) -> Figures:
    """How well the vehicle flew, whatever the allocator: range and depth in H, largest pitch and roll."""
    hover = log[log["mode"] == HOVER]
    depth = hover["eta"][:, 2] - hover["observation_point"][:, 2]
    return {
        "hover_range_rms_m": rms(hover["range_true"]),
        "hover_range_max_m": float(hover["range_true"].max(initial=0.0)) if len(hover) else float("nan"),
        "hover_depth_rms_m": rms(depth),
        "hover_share": float(len(hover) / max(1, len(log))),
        "pitch_max_rad": float(np.abs(log["eta"][:, 4]).max(initial=0.0)),
        "roll_max_rad": float(np.abs(log["eta"][:, 3]).max(initial=0.0)),
    }


def _fault(log: np.ndarray, residual: dict[str, Floats], fault_time: float) -> Figures:
    """What happened from the fault to the end: wrench error, attitude deviation, slack."""
    post = log["time"] >= fault_time
    out = {f"rms_e_tau_post_{name}": rms(values[post]) for name, values in residual.items()}
    for name, i in (("theta", 4), ("psi", 5)):
        deviation = log["reference"][post, i] - log["eta"][post, i]
        deviation = (deviation + np.pi) % (2.0 * np.pi) - np.pi
        out[f"d_{name}_fault_rms"] = rms(deviation)
        out[f"d_{name}_fault_10s"] = rms(deviation[log["time"][post] <= fault_time + SHORT_FAULT_S])
        out[f"d_{name}_fault_peak"] = float(np.abs(deviation).max(initial=0.0))
        moved = np.unwrap(log["eta"][post, i])
        out[f"d_{name}_fault_moved"] = float(np.abs(moved - moved[0]).max()) if len(moved) else float("nan")
    slack = np.linalg.norm(log["slack"][post], axis=1)
    out["s_max"], out["s_rms"] = float(slack.max(initial=0.0)), rms(slack)
    return out
