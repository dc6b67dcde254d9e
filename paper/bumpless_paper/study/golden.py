"""A small summary of a run that changes whenever the flight does: what golden files hold."""

from typing import Any

import numpy as np

from bumpless.sim.twin import Result
from bumpless_paper.study.figures import figures_of
from bumpless_paper.study.scenarios import FAULT_TIME_S

KEPT = (
    "t_FR",
    "t_RH",
    "switches",
    "rms_e_tau_true",
    "rms_e_tau_model",
    "r_sat",
    "d_u_FR_bound",
    "d_u_RH_bound",
    "hover_range_rms_m",
    "hover_depth_rms_m",
    "pitch_max_rad",
    "rms_e_tau_post_true",
    "d_theta_fault_rms",
    "d_psi_fault_rms",
    "s_rms",
    "demand_step_violations",
)


def summary_of(result: Result) -> dict[str, Any]:
    """Figures, where the vehicle ended, and the mean magnitude of each command, to six digits."""
    figures = figures_of(result, FAULT_TIME_S)
    log, n = result.log, len(result.vehicle.commands)
    return {
        "figures": {name: _six(figures[name]) for name in KEPT},
        "end": {
            "eta": [_six(v) for v in log["eta"][-1]],
            "nu": [_six(v) for v in log["nu"][-1]],
            "cycles": len(log),
        },
        "commands": [_six(v) for v in np.abs(log["u"][:, :n]).mean(axis=0)],
    }


def _six(value: float) -> float | None:
    return float(f"{value:.6g}") if np.isfinite(value) else None
