"""How steadily the vehicle flew in each mode."""

from dataclasses import dataclass

import numpy as np

from bumpless.metrics.columns import Columns, Floats
from bumpless.metrics.tracking import Tracking, tracking


@dataclass(frozen=True)
class ModeFigures:
    """Over all stays in one mode; RMS about each stay's own mean, peak-to-peak of the worst stay."""

    mode: int
    samples: int
    depth_rms: float  # m
    depth_peak_to_peak: float  # m
    attitude_rms: Floats  # (3,) roll, pitch, yaw, rad
    surge_mean: float  # m/s over ground
    command_rms: Floats  # (n_u,) rad or rev/s, mean not removed
    residual_rms: float
    tracking: Tracking


def mode_figures(run: Columns, residual: Floats) -> list[ModeFigures]:
    """For each mode that was flown, in the order F, R, H. residual: (n,) norm of e_tau.

    Source: Gao et al. 2026, tables A5 and A6.
    """
    edges = np.flatnonzero(np.diff(run.mode)) + 1
    stays = np.split(np.arange(len(run)), edges)
    return [
        _figures(run, residual, mode, [s for s in stays if run.mode[s[0]] == mode])
        for mode in np.unique(run.mode)
    ]


def _figures(run: Columns, residual: Floats, mode: int, stays: list[np.ndarray]) -> ModeFigures:
    rows = np.concatenate(stays)
    depth = [run.depth[s] for s in stays]
    attitude = [np.unwrap(run.eta_hat[s, 3:6], axis=0) for s in stays]
    return ModeFigures(
        mode=int(mode),
        samples=len(rows),
        depth_rms=float(_rms(np.concatenate([d - d.mean() for d in depth]))),
        depth_peak_to_peak=float(max(np.ptp(d) for d in depth)),
        attitude_rms=_rms(np.concatenate([a - a.mean(axis=0) for a in attitude])),
        surge_mean=float(run.nu_hat[rows, 0].mean()),
        command_rms=_rms(run.u[rows]),
        residual_rms=float(_rms(residual[rows])),
        tracking=tracking(run, rows),
    )


def _rms(values: Floats) -> Floats:
    return np.sqrt(np.mean(values**2, axis=0))
