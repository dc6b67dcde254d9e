"""What the actuators can do at a speed, for a screen: both attainable sets and the reach along each axis."""

from dataclasses import dataclass

import numpy as np

from bumpless.config.vehicle import Vehicle
from bumpless_server.foresight.margin import STEP_MPS, Floats, supports

SPEEDS_MPS = (-1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0)  # over which a scale holds still


@dataclass(frozen=True)
class Reach:
    """Rows d / h(d) of both sets (inside: all rows @ tau at most 1); reach along X Y Z K M N, N and N m."""

    surge_mps: float
    force: Floats
    moment: Floats
    low: Floats
    high: Floats
    most: Floats


def reach_at(vehicle: Vehicle, surge_mps: float) -> Reach:
    """At the speed through the water nearest to `surge_mps` for which sets are kept.

    Source: Gao et al. 2026, eqs. (37)-(40).
    """
    bin_ = round(surge_mps / STEP_MPS)
    force, moment = supports(vehicle, bin_)
    low, high = _extents(force, moment)
    others = [_extents(*supports(vehicle, round(speed / STEP_MPS))) for speed in SPEEDS_MPS]
    most = np.max([np.maximum(-a, b) for a, b in [*others, (low, high)]], axis=0)
    return Reach(bin_ * STEP_MPS, force, moment, low, high, most)


def _extents(force: Floats, moment: Floats) -> tuple[Floats, Floats]:
    """(6,) least and largest along each axis; 0 where nothing acts."""
    return (
        -np.concatenate([_along(one, -1.0) for one in (force, moment)]),
        np.concatenate([_along(one, 1.0) for one in (force, moment)]),
    )


def _along(rows: Floats, sign: float) -> Floats:
    """(3,) reach along each axis in that sense: from the rows that point along it alone."""
    alone = (np.abs(rows) > 0.0).sum(axis=1) == 1
    reach = np.zeros(3)
    for axis in range(3):
        found = rows[alone & (sign * rows[:, axis] > 0.0), axis]
        if len(found):
            reach[axis] = 1.0 / np.abs(found).max()
    return reach
