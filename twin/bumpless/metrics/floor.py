"""How far the hull stays above the sea floor."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from bumpless.chart import Floor
from bumpless.metrics.columns import Floats

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle


SPACING_M, MOST_PLACES = 0.5, 400  # along a planned leg


@dataclass(frozen=True)
class Below:
    """The floor along planned places."""

    places: Floats  # (n, 3) NED, m
    along: Floats  # (n,) m in the plane, from the start
    floor: Floats  # (n,) depth of the floor, m; NaN where unknown
    clearance: Floats  # (n,) m below the hull, on an even keel


def floor_clearance(eta: Floats, vehicle: "Vehicle", floor: Floor) -> Floats:
    """(n,) m from the hull down to the floor at poses (n, 6), below nose, middle and tail; NaN where unknown.

    Positive above the floor. The hull is its axis with its radius; what stands out below it counts in the
    middle.
    """
    fore, aft = vehicle.ends_m
    phi, theta, psi = eta[:, 3], eta[:, 4], eta[:, 5]
    radius = 0.5 * vehicle.hull.diameter_m
    least = np.full(len(eta), np.inf)
    for x in (fore, 0.5 * (fore + aft), aft):
        level = x * np.cos(theta)
        depth = eta[:, 2] - x * np.sin(theta) + radius
        if x == 0.5 * (fore + aft):
            depth = np.maximum(depth, eta[:, 2] + _keel(phi, theta, vehicle))
        under = floor.depth(eta[:, 0] + level * np.cos(psi), eta[:, 1] + level * np.sin(psi))
        least = np.fmin(least, under - depth)
    return np.where(np.isfinite(least), least, np.nan)


def _keel(phi: Floats, theta: Floats, vehicle: "Vehicle") -> Floats:
    """(n,) how far below O_b the lowest actuator is."""
    places = np.array([actuator.position_m for actuator in vehicle.actuators], np.float64).reshape(-1, 3)
    if not len(places):
        return np.full(len(phi), -np.inf)
    down = np.stack([-np.sin(theta), np.cos(theta) * np.sin(phi), np.cos(theta) * np.cos(phi)], axis=1)
    return (down @ places.T).max(axis=1)


def least_clearance(eta: Floats, vehicle: "Vehicle", floor: Floor | None) -> float | None:
    """The least of them, m; None where it is nowhere known."""
    if floor is None or not len(eta):
        return None
    found = floor_clearance(eta, vehicle, floor)
    return float(np.nanmin(found)) if np.isfinite(found).any() else None


def below(places: Floats, vehicle: "Vehicle", floor: Floor) -> Below:
    """The floor along straight lines through places (m, 3), looked at each half metre or 400 times a leg."""
    steps = np.linalg.norm(np.diff(places[:, :2], axis=0), axis=1)
    rows, along, done = [places[:1]], [np.zeros(1)], 0.0
    for k, step in enumerate(steps):
        share = np.linspace(0.0, 1.0, int(min(max(math.ceil(step / SPACING_M), 1), MOST_PLACES)) + 1)[1:]
        rows.append(places[k] + share[:, None] * (places[k + 1] - places[k]))
        along.append(done + share * step)
        done += float(step)
    path = np.concatenate(rows)
    depth = floor.depth(path[:, 0], path[:, 1])
    return Below(path, np.concatenate(along), depth, depth - path[:, 2] - keel_m(vehicle))


def keel_m(vehicle: "Vehicle") -> float:
    """How far the hull reaches below its axis on an even keel."""
    return max(0.5 * vehicle.hull.diameter_m, *(float(a.position_m[2]) for a in vehicle.actuators))
