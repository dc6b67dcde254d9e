"""Proposition 1 held against what was flown: no cycle may exceed its bounds or jump in its demand.

Source: Gao et al. 2026, eqs. (54)-(57), Proposition 1.
"""

import numpy as np

from bumpless.metrics.columns import Columns, Floats

TOLERANCE = 1e-6  # relative; what conversion to deg and rpm and back may cost


def increment_violations(run: Columns, lower: Floats, upper: Floats) -> int:
    """Cycles in which a command left its amplitude bounds or moved by more than its increment bound.

    lower, upper: (n_u,) amplitude bounds, rad or rev/s.
    """
    room = TOLERANCE * (upper - lower)
    outside = (run.u < lower - room) | (run.u > upper + room)
    if len(run) > 1:
        moved = np.abs(np.diff(run.u, axis=0)) > run.du_max[1:] + room
        outside[1:] |= moved & run.follows[1:, None]
    return int(np.any(outside, axis=1).sum())


def demand_step_violations(run: Columns) -> int:
    """Cycles in which tau_d stepped by more than one cycle of the ramp allows.

    In a ramp tau_d = (1 - kappa) tau_minus + kappa tau_plus, so that from one cycle to the next
    |step| <= (kappa - kappa') |tau_plus - tau_minus| + kappa' |tau_plus - tau_plus'|, primes marking
    the cycle before. Where a ramp begins (a mode switch, new parameters) the demand in force is the
    start of it, so the step is at most kappa |tau_plus - tau_d'|, and kappa is at most the next
    cycle's increment. A hard switch breaks this; the count says how often.
    """
    if len(run) < 2:
        return 0
    kappa, before = run.kappa[1:, None], run.kappa[:-1, None]
    step = np.abs(np.diff(run.tau_d, axis=0))
    ramp = np.abs(run.tau_plus - run.tau_minus)[1:]
    along = np.maximum(kappa - before, 0.0) * ramp + before * np.abs(np.diff(run.tau_plus, axis=0))
    following = np.append(run.kappa[2:], run.kappa[-1])[:, None]
    first = np.maximum(following - kappa, 0.0) * np.abs(run.tau_plus[1:] - run.tau_d[:-1])
    begins = (np.diff(run.mode) != 0) | np.any(np.diff(run.tau_minus, axis=0) != 0.0, axis=1)
    begins |= np.diff(run.kappa) < 0.0
    allowed = np.where(begins[:, None], first, along)
    scale = 1.0 + np.abs(run.tau_d[1:]) + np.abs(run.tau_plus[1:])
    broken = step > allowed + TOLERANCE * scale
    return int((np.any(broken, axis=1) & run.follows[1:]).sum())
