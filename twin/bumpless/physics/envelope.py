"""What the actuators can do: attainable force set (AFS) and attainable moment set (AMS) at a surge speed.

A wrench is a sum of independent actuator terms, so the convex hull of what is attainable is the Minkowski
sum of the actuators' own curves f_i(s), and its support function is h(d) = sum_i max_s d . f_i(s). The
points where the maxima are taken lie on the hull's surface: exact in the limit of directions,
deterministic, and ready within a cycle. `sampled_sets` goes the paper's way.

Source: Gao et al. 2026, eqs. (37)-(40).
Differs: the paper takes the hull of sampled commands, which stays inside the true set.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bumpless.jit import allocating
from bumpless.physics.actuators import actuator_wrench
from bumpless.physics.envelope_hull import Envelope, Hull, direction_sphere, hull_of_points
from bumpless.physics.model_record import FIN, THRUSTER

Array = NDArray[np.float64]
LEVELS = 41  # samples along an actuator's curve, both bounds and zero among them

__all__ = ["Envelope", "Hull", "attainable_sets", "sampled_sets", "select"]


def attainable_sets(
    model: np.record,
    surge_speed_mps: float,
    n_directions: int = 500,
    actuators: Sequence[int] | NDArray[np.int64] | None = None,
) -> Envelope:
    """AFS and AMS of the given actuators (indices; all by default) in steady flow along x_b.

    Both hulls have n_directions vertices, in the order of the same fixed directions, and 2n - 4 faces.
    """
    directions, faces = direction_sphere(n_directions)
    curves = wrench_curves(model, surge_speed_mps, _levels(model, LEVELS), select(model, actuators))
    force = _support_points(curves[:, :, :3].copy(), directions)
    moment = _support_points(curves[:, :, 3:].copy(), directions)
    return Envelope(Hull(force, faces), Hull(moment, faces))


def sampled_sets(
    model: np.record, surge_speed_mps: float, seed: int = 0, n_random: int = 20_000
) -> dict[str, Envelope]:
    """The three rows of the paper's Table 3 in the paper's way: "rudder", "thrusters", "total".

    Rudders: 20 levels each, all combinations; thrusters: 100 levels each, all combinations; total:
    n_random commands, uniform within bounds.
    Source: Gao et al. 2026, section 2.6 and Table 3.
    """
    cloud = _random(model, surge_speed_mps, seed, n_random)
    return {
        "rudder": _grid(model, surge_speed_mps, select(model, kind=FIN), 20),
        "thrusters": _grid(model, surge_speed_mps, select(model, kind=THRUSTER), 100),
        "total": Envelope(hull_of_points(cloud[:, :3]), hull_of_points(cloud[:, 3:])),
    }


def select(
    model: np.record, actuators: Sequence[int] | NDArray[np.int64] | None = None, kind: int | None = None
) -> NDArray[np.int64]:
    """Indices of actuators: the given ones or all, of the given kind (FIN, THRUSTER) or any."""
    chosen = np.arange(int(model["n_u"])) if actuators is None else np.asarray(actuators, np.int64)
    return chosen if kind is None else chosen[model["kind"][chosen] == kind]


@allocating
def wrench_curves(model, surge_speed, commands, chosen):
    """Wrenches (len(chosen), levels, 6) of single actuators at commands (levels, n), N and N m.

    commands[l, i] is a deflection (rad) or shaft speed (rev/s) of actuator i.
    """
    nu_r = np.zeros(6)
    nu_r[0] = surge_speed
    curves = np.zeros((len(chosen), commands.shape[0], 6))
    for k in range(len(chosen)):
        for level in range(commands.shape[0]):
            actuator_wrench(model, chosen[k], commands[level, chosen[k]], nu_r, curves[k, level])
    return curves


@allocating
def _support_points(curves, directions):
    """Points (n, 3) of the Minkowski sum of the curves (actuators, levels, 3), outermost in each direction.

    Directions are spread over the set scaled to equal widths along the axes: a thin set, such as the rudders'
    forces, would else be seen from its broad sides only.
    """
    points = np.zeros((len(directions), 3))
    width = np.zeros(3)
    for i in range(curves.shape[0]):
        for c in range(3):
            width[c] += curves[i, :, c].max() - curves[i, :, c].min()
    width[width <= 1e-9 * width.max()] = 1.0
    for j in range(len(directions)):
        x, y, z = directions[j, 0] / width[0], directions[j, 1] / width[1], directions[j, 2] / width[2]
        for i in range(curves.shape[0]):
            best, at = -np.inf, 0
            for level in range(curves.shape[1]):
                reach = x * curves[i, level, 0] + y * curves[i, level, 1] + z * curves[i, level, 2]
                if reach > best:
                    best, at = reach, level
            for c in range(3):
                points[j, c] += curves[i, at, c]
    return points


def _levels(model: np.record, count: int) -> Array:
    """(count, n) commands from lower to upper bound."""
    n = int(model["n_u"])
    return np.linspace(model["command_min"][:n], model["command_max"][:n], count)


def _grid(model: np.record, surge_speed: float, chosen: NDArray[np.int64], count: int) -> Envelope:
    """Hulls of every combination of `count` levels of the chosen actuators.

    Corners are kept after each actuator: the hull of a sum is the hull of the sum of corners, so the
    result is that of all count^len(chosen) combinations.
    """
    curves = wrench_curves(model, surge_speed, _levels(model, count), chosen)
    hulls = []
    for part in (curves[:, :, :3], curves[:, :, 3:]):
        hull = hull_of_points(np.zeros((1, 3)))
        for curve in part:
            hull = hull_of_points((hull.vertices[:, None, :] + curve[None, :, :]).reshape(-1, 3))
        hulls.append(hull)
    return Envelope(hulls[0], hulls[1])


def _random(model: np.record, surge_speed: float, seed: int, count: int) -> Array:
    """Wrenches (count, 6) of commands drawn uniformly within bounds, all actuators together."""
    n = int(model["n_u"])
    draw = np.random.default_rng(seed).random((count, n))
    low, high = model["command_min"][:n], model["command_max"][:n]
    return wrench_curves(model, surge_speed, low + (high - low) * draw, np.arange(n)).sum(axis=0)
