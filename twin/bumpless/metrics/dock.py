"""The hull against the dock: how near it came to the marker, and whether it went through the dock's plane.

The dock is a disc about the marker, across the approach heading; the hull is its axis from nose to tail.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from bumpless.metrics.columns import Columns, Floats

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

KEEP_OUT_M = 0.5  # radius of the disc: a dock's funnel for a hull of 0.2 m is about a metre wide


@dataclass(frozen=True)
class Clearance:
    """One row per cycle; NaN where the place of hull or marker is not known."""

    to_marker: Floats  # (n,) m, least distance of the hull's axis from the marker
    in_plane: Floats  # (n,) m from the marker at which the axis goes through the plane; inf where it does not


def clearance_of(run: Columns, vehicle: "Vehicle", known: bool) -> Clearance:
    """By the truth where it is known, else as the vehicle believed."""
    eta, marker = (run.eta, run.target_true) if known else (run.eta_hat, run.target[:, :3])
    fore, aft = ends_of(vehicle)
    ahead = _ahead(eta)
    nose, tail = eta[:, :3] + fore * ahead - marker, eta[:, :3] + aft * ahead - marker
    return Clearance(_to_origin(nose, tail), _in_plane(nose, tail, run.heading))


def ends_of(vehicle: "Vehicle") -> tuple[float, float]:
    """x of nose and tail in body axes, m; a box has its origin in the middle."""
    length = vehicle.hull.length_m
    fore = getattr(vehicle.hull, "nose_to_origin_m", 0.5 * length)
    return fore, fore - length


def _ahead(eta: Floats) -> Floats:
    """(n, 3) the body's x axis in NED."""
    c = np.cos(eta[:, 4])
    return np.stack([c * np.cos(eta[:, 5]), c * np.sin(eta[:, 5]), -np.sin(eta[:, 4])], axis=1)


def _to_origin(nose: Floats, tail: Floats) -> Floats:
    """Distance of the origin from each line between the two."""
    along = nose - tail
    share = np.clip(-np.sum(tail * along, axis=1) / np.sum(along**2, axis=1), 0.0, 1.0)
    return np.linalg.norm(tail + share[:, None] * along, axis=1)


def _in_plane(nose: Floats, tail: Floats, heading: Floats) -> Floats:
    """Where the line between the two goes through the plane across `heading`, as a distance in it."""
    normal = np.stack([np.cos(heading), np.sin(heading), np.zeros(len(heading))], axis=1)
    before, beyond = np.sum(tail * normal, axis=1), np.sum(nose * normal, axis=1)
    through = (before <= 0.0) != (beyond <= 0.0)
    share = np.where(through, before / np.where(through, before - beyond, 1.0), 0.0)
    at = np.linalg.norm(tail + share[:, None] * (nose - tail), axis=1)
    at = np.where(through, at, np.inf)
    return np.where(np.isfinite(before + beyond), at, np.nan)
