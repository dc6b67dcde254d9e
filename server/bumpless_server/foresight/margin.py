"""How much of the attainable force and moment sets a demand leaves: 1 at rest, 0 at their edge or beyond."""

import numpy as np
import numpy.typing as npt

from bumpless.config.vehicle import Vehicle
from bumpless.physics.envelope import attainable_sets
from bumpless.physics.envelope_hull import direction_sphere
from bumpless.physics.model import build_model

Floats = npt.NDArray[np.float64]
STEP_MPS = 0.1  # of surge through water, between the sets that are made
DIRECTIONS = 240
_FLAT = 1e-6  # width over the widest, below which nothing acts along an axis
_MOST_KEPT = 400
_kept: dict[tuple[str, int], tuple[Floats, Floats]] = {}


def margins(tau_d: Floats, surge_mps: Floats, vehicle: Vehicle) -> Floats:
    """(n,) margins of demands (n, 6), N and N m, at surge speeds (n,) through the water.

    The share of the set that is left in the demand's own direction, the smaller of force and moment. An axis
    along which the vehicle has no actuator does not count.
    """
    bins = np.round(surge_mps / STEP_MPS).astype(int)
    used = np.zeros(len(tau_d))
    for one in np.unique(bins):
        rows = bins == one
        force, moment = supports(vehicle, int(one))
        used[rows] = np.maximum(_gauge(tau_d[rows, :3], force), _gauge(tau_d[rows, 3:], moment))
    return np.clip(1.0 - used, 0.0, 1.0)


def _gauge(demand: Floats, support: Floats) -> Floats:
    """(n,) by how much the set must be scaled to just hold each demand (n, 3): max_d d . tau / h(d)."""
    return (demand @ support.T).max(axis=1, initial=0.0)


def supports(vehicle: Vehicle, speed_bin: int) -> tuple[Floats, Floats]:
    """Force and moment set at `speed_bin` times STEP_MPS, each as rows d / h(d), the axes' own among them.

    Inside is where all rows @ tau are at most 1.
    """
    key = (vehicle.sha256, speed_bin)
    if key not in _kept:
        if len(_kept) >= _MOST_KEPT:
            _kept.clear()
        sets = attainable_sets(build_model(vehicle), speed_bin * STEP_MPS, DIRECTIONS)
        _kept[key] = _support(sets.force.vertices), _support(sets.moment.vertices)
    return _kept[key]


def _support(vertices: Floats) -> Floats:
    """(m, 3) directions over the set's reach along them, h(d); directions that it does not reach left out."""
    width = np.ptp(vertices, axis=0)
    acts = width > _FLAT * width.max(initial=0.0)
    scale = np.where(acts, 1.0 / np.where(acts, width, 1.0), 0.0)
    directions = np.concatenate([direction_sphere(DIRECTIONS)[0], np.eye(3), -np.eye(3)]) * scale
    reach = (vertices @ directions.T).max(axis=0)
    kept = reach > _FLAT
    return directions[kept] / reach[kept, None]
