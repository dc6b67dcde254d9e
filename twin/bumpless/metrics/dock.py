"""The hull against the dock: how near it came to the marker, and whether it was in the dock's body.

The body stands behind the marker's plane, across the heading to approach with. The hull is its axis from
nose to tail, with its radius, and the places of its actuators, for these may stand out.
"""

from dataclasses import dataclass
from math import hypot, radians, sqrt
from typing import TYPE_CHECKING

import numpy as np

from bumpless.metrics.columns import Columns, Floats, dots, lengths

if TYPE_CHECKING:
    from bumpless.config.mission.model import Target
    from bumpless.config.vehicle import Vehicle

AXIS_POINTS = 10  # of the hull, from nose to tail


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


def points_of(vehicle: "Vehicle") -> Floats:
    """(m, 3) points of the hull in body axes, m."""
    axis = np.zeros((AXIS_POINTS, 3))
    axis[:, 0] = np.linspace(*vehicle.ends_m, AXIS_POINTS)
    return np.vstack([axis, [actuator.position_m for actuator in vehicle.actuators]])


def _reach(vehicle: "Vehicle", body: Body) -> float:
    """No farther than this is the axis from the marker when a point of the hull is in the dock, m."""
    corner = hypot(body.length_m, sqrt(2.0) * _half(vehicle, body))
    return float(corner + lengths(points_of(vehicle)[:, 1:]).max())


def _half(vehicle: "Vehicle", body: Body) -> float:
    """Half the dock's width with the hull's radius, m."""
    return 0.5 * (body.width_m + vehicle.hull.diameter_m)


def is_inside(
    eta: Floats, from_marker: Floats, heading: Floats | float, vehicle: "Vehicle", body: Body
) -> np.ndarray:
    """(n,) whether a point of the hull is in the body that stands along `heading`, rad.

    eta: (n, 6). from_marker: (n, 3) of O_b from the marker, NED, m.
    """
    points, half = points_of(vehicle), _half(vehicle, body)
    phi, theta, delta = eta[:, 3], eta[:, 4], eta[:, 5] - heading
    sf, cf, st, ct, sd, cd = (f(a) for a in (phi, theta, delta) for f in (np.sin, np.cos))
    c, s = np.cos(heading), np.sin(heading)
    along = from_marker[:, 0] * c + from_marker[:, 1] * s
    deep = along[:, None] + np.stack([ct * cd, sf * st * cd - cf * sd, cf * st * cd + sf * sd], 1) @ points.T
    within = (deep > 0.0) & (deep < body.length_m)
    if not within.any():
        return np.zeros(len(eta), bool)
    aside = from_marker[:, 1] * c - from_marker[:, 0] * s
    wide = aside[:, None] + np.stack([ct * sd, cf * cd + sf * st * sd, cf * st * sd - sf * cd], 1) @ points.T
    high = from_marker[:, 2, None] + np.stack([-st, ct * sf, ct * cf], 1) @ points.T
    return np.any(within & (np.abs(wide) < half) & (np.abs(high) < half), axis=1)


def _ahead(eta: Floats) -> Floats:
    """(n, 3) the body's x axis in NED."""
    c = np.cos(eta[:, 4])
    return np.stack([c * np.cos(eta[:, 5]), c * np.sin(eta[:, 5]), -np.sin(eta[:, 4])], axis=1)


def _to_origin(nose: Floats, tail: Floats) -> Floats:
    """Distance of the origin from each line between the two."""
    along = nose - tail
    share = np.clip(-dots(tail, along) / dots(along, along), 0.0, 1.0)
    return lengths(tail + share[:, None] * along)
