"""How steadily the vehicle flew in each mode."""

import itertools
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
    edges = [0, *(np.flatnonzero(np.diff(run.mode)) + 1).tolist(), len(run)]
    stays = [slice(a, b) for a, b in itertools.pairwise(edges)]
    modes = [int(run.mode[s.start]) for s in stays]
    return [
        _figures(run, residual, mode, [s for s, flown in zip(stays, modes, strict=True) if flown == mode])
        for mode in sorted(set(modes))
    ]


def _figures(run: Columns, residual: Floats, mode: int, stays: list[slice]) -> ModeFigures:
    rows = stays[0] if len(stays) == 1 else np.concatenate([np.arange(s.start, s.stop) for s in stays])
    depth = [run.depth[s] for s in stays]
    attitude = [_unwrapped(run.eta_hat[s, 3:6]) for s in stays]
    return ModeFigures(
        mode=mode,
        samples=sum(map(len, depth)),
        depth_rms=float(_rms(np.concatenate([d - d.mean() for d in depth]))),
        depth_peak_to_peak=float(max(np.ptp(d) for d in depth)),
        attitude_rms=_rms(np.concatenate([a - a.mean(axis=0) for a in attitude])),
        surge_mean=float(run.nu_hat[rows, 0].mean()),
        command_rms=_rms(run.u[rows]),
        residual_rms=float(_rms(residual[rows])),
        tracking=tracking(run, rows),
    )


def _unwrapped(angles: Floats) -> Floats:
    """Angles (n, 3) without jumps, rad; NumPy looks for them at length."""
    jumps = np.abs(np.diff(angles, axis=0)) >= np.pi
    return np.unwrap(angles, axis=0) if jumps.any() else angles


def _rms(values: Floats) -> Floats:
    return np.sqrt(np.mean(values**2, axis=0))
