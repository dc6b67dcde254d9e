"""True and believed errors of a flight against where it should hover, and its nose against the marker."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from bumpless.config.mission import Mission
from bumpless.config.vehicle import MyringHull, Vehicle

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Errors:
    """Distances from the observation point, one per row: m, m, rad and m/s."""

    range: Floats  # over three axes
    depth: Floats  # signed, positive too deep
    heading: Floats  # signed, about the approach heading
    speed: Floats  # over ground


def true_errors(log: npt.NDArray, mission: Mission) -> Errors:
    """Against the true target."""
    return _errors(log["eta"], log["nu"], _hover_point(mission), mission)


def believed_errors(log: npt.NDArray, mission: Mission) -> Errors:
    """Against where the vehicle believes it has to be, by its own estimate."""
    return _errors(log["eta_hat"], log["nu_hat"], log["observation_point"], mission)


def _errors(eta: Floats, nu: Floats, point: Floats, mission: Mission) -> Errors:
    eta, nu = np.ascontiguousarray(eta), np.ascontiguousarray(nu)  # of a log, whose rows are far apart
    away = eta[:, :3] - point
    heading = eta[:, 5] - np.radians(mission.target.heading_deg)
    return Errors(
        np.sqrt(np.einsum("ij,ij->i", away, away)),
        away[:, 2],
        wrapped(heading),
        np.sqrt(np.einsum("ij,ij->i", nu[:, :3], nu[:, :3])),
    )


def _hover_point(mission: Mission) -> Floats:
    """The true observation point: as far from the planned one as the true target from the planned."""
    point, offset = mission.target.observation_point_ned_m, mission.target.true_offset_ned_m
    return np.array(point) + np.array(offset)


def nose_clearance(log: npt.NDArray, mission: Mission, vehicle: Vehicle) -> Floats:
    """(n,) distance of the true nose from the true marker, m."""
    eta = np.ascontiguousarray(log["eta"])
    ct = np.cos(eta[:, 4])
    ahead = np.stack([ct * np.cos(eta[:, 5]), ct * np.sin(eta[:, 5]), -np.sin(eta[:, 4])], axis=1)
    nose = eta[:, :3] + nose_x(vehicle) * ahead
    return np.linalg.norm(nose - np.array(mission.target.true_position_ned_m), axis=1)


def nose_x(vehicle: Vehicle) -> float:
    """How far the nose lies ahead of O_b, m."""
    hull = vehicle.hull
    return hull.nose_to_origin_m if isinstance(hull, MyringHull) else hull.length_m / 2.0


def wrapped(angle: Floats) -> Floats:
    """Into -pi to pi."""
    return (angle + np.pi) % (2.0 * np.pi) - np.pi
