"""The hull against the dock: how near it came to the marker, and whether it was in the dock's body.

The body stands behind the marker's plane, across the heading to approach with. The hull is spheres along its
axis, as wide as it is there, and one about each actuator, for these may stand out.
"""

from dataclasses import dataclass
from math import hypot, radians, sqrt
from typing import TYPE_CHECKING

import numpy as np

from bumpless.config.vehicle import Fin, MyringHull
from bumpless.metrics.columns import Columns, Floats, dots, lengths
from bumpless.physics.hydrodynamics.myring import myring_radius

if TYPE_CHECKING:
    from bumpless.config.mission.model import Target
    from bumpless.config.vehicle import Vehicle

AXIS_POINTS = 45  # spheres from nose to tail: between two of them 3 mm of TS-100 are missed


@dataclass(frozen=True)
class Body:
    """What must not be touched: a box about the approach line, from the marker's plane on."""

    width_m: float = 2.0  # also its height
    length_m: float = 1.5
    heading: float | None = None  # rad; None: it turns with the approach heading in use


ANY_SIDE = Body()


@dataclass(frozen=True)
class Clearance:
    """One row per cycle; where the place of hull or marker is not known, NaN and False."""

    to_marker: Floats  # (n,) m, least distance of the hull's axis from the marker
    inside: np.ndarray  # (n,) bool, a point of the hull is in the dock


def body_of(target: "Target | None") -> Body:
    """The dock of a mission's target; one of the usual size, and on any heading, where nobody knows it."""
    if target is None:
        return ANY_SIDE
    heading = None if target.turns else radians(target.heading_deg)
    return Body(target.dock_width_m, target.dock_length_m, heading)


def clearance_of(run: Columns, vehicle: "Vehicle", known: bool, body: Body) -> Clearance:
    """By the truth where it is known, else as the vehicle believed.

    A body with a heading of its own is sought there and across the approach heading in use.
    """
    eta, marker = (run.eta, run.target_true) if known else (run.eta_hat, run.target[:, :3])
    fore, aft = vehicle.ends_m
    ahead, from_marker = _ahead(eta), eta[:, :3] - marker
    to_marker = _to_origin(from_marker + fore * ahead, from_marker + aft * ahead)
    inside = np.zeros(len(eta), bool)
    near = np.flatnonzero(to_marker <= _reach(vehicle, body))
    for heading in (run.heading[near], body.heading):
        if len(near) and heading is not None:
            inside[near] |= is_inside(eta[near], from_marker[near], heading, vehicle, body)
    return Clearance(to_marker, inside)


def spheres_of(vehicle: "Vehicle") -> tuple[Floats, Floats]:
    """((m, 3), (m,)) middles in body axes and radii, m, that fill the hull, and one about each actuator."""
    hull, (fore, aft) = vehicle.hull, vehicle.ends_m
    axis = np.zeros((AXIS_POINTS, 3))
    x = axis[:, 0] = np.linspace(fore, aft, AXIS_POINTS)
    round_x = myring_radius(hull, x) if isinstance(hull, MyringHull) else 0.5 * hull.diameter_m
    radius = np.minimum(round_x, np.minimum(fore - x, x - aft))
    sizes = [0.5 * (a.span_m if isinstance(a, Fin) else a.diameter_m) for a in vehicle.actuators]
    return np.vstack([axis, [a.position_m for a in vehicle.actuators]]), np.array([*radius, *sizes])


def _reach(vehicle: "Vehicle", body: Body) -> float:
    """No farther than this is the axis from the marker when a part of the hull is in the dock, m."""
    points, radii = spheres_of(vehicle)
    corner = hypot(body.length_m, sqrt(0.5) * body.width_m)
    return float(corner + (lengths(points[:, 1:]) + radii).max())


def is_inside(
    eta: Floats, from_marker: Floats, heading: Floats | float, vehicle: "Vehicle", body: Body
) -> np.ndarray:
    """(n,) whether a part of the hull is in the body that stands along `heading`, rad.

    eta: (n, 6). from_marker: (n, 3) of O_b from the marker, NED, m.
    """
    (points, radii), half = spheres_of(vehicle), 0.5 * body.width_m
    phi, theta, delta = eta[:, 3], eta[:, 4], eta[:, 5] - heading
    sf, cf, st, ct, sd, cd = (f(a) for a in (phi, theta, delta) for f in (np.sin, np.cos))
    c, s = np.cos(heading), np.sin(heading)
    along = from_marker[:, 0] * c + from_marker[:, 1] * s
    deep = along[:, None] + np.stack([ct * cd, sf * st * cd - cf * sd, cf * st * cd + sf * sd], 1) @ points.T
    if not ((deep > -radii) & (deep < body.length_m + radii)).any():
        return np.zeros(len(eta), bool)
    aside = from_marker[:, 1] * c - from_marker[:, 0] * s
    wide = aside[:, None] + np.stack([ct * sd, cf * cd + sf * st * sd, cf * st * sd - sf * cd], 1) @ points.T
    high = from_marker[:, 2, None] + np.stack([-st, ct * sf, ct * cf], 1) @ points.T
    off = (np.maximum(-deep, deep - body.length_m), np.abs(wide) - half, np.abs(high) - half)
    far2 = sum(np.square(np.maximum(gap, 0.0)) for gap in off)
    return np.any((far2 < np.square(radii)) | (np.maximum.reduce(off) < 0.0), axis=1)


def _ahead(eta: Floats) -> Floats:
    """(n, 3) the body's x axis in NED."""
    c = np.cos(eta[:, 4])
    return np.stack([c * np.cos(eta[:, 5]), c * np.sin(eta[:, 5]), -np.sin(eta[:, 4])], axis=1)


def _to_origin(nose: Floats, tail: Floats) -> Floats:
    """Distance of the origin from each line between the two."""
    along = nose - tail
    share = np.clip(-dots(tail, along) / dots(along, along), 0.0, 1.0)
    return lengths(tail + share[:, None] * along)
