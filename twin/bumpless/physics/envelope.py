"""What the actuators can do: attainable force set (AFS) and attainable moment set (AMS) at a surge speed.

A wrench is a sum of independent actuator terms, so the convex hull of what is attainable is the Minkowski
sum of the actuators' own sets f_i(s), and its support function is h(d) = sum_i max_s d . f_i(s), over all
commands s of an actuator together: f_i is a curve where it has one command, a surface where it has two. The
points where the maxima are taken lie on the hull's surface: exact in the limit of directions, deterministic,
and ready within a cycle. `sampled_sets` goes the paper's way.

Source: Gao et al. 2026, eqs. (37)-(40).
Differs: the paper takes the hull of sampled commands, which stays inside the true set.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bumpless.jit import allocating
from bumpless.physics.actuators import KINDS, actuator_wrench
from bumpless.physics.envelope_hull import Envelope, Hull, direction_sphere, hull_of_points

Array = NDArray[np.float64]
PUBLISHED = ("fin", "thruster")  # have a row in Table 3, empty or not
LEVELS = 41  # samples of a command, both bounds and the middle among them

__all__ = ["Envelope", "Hull", "attainable_sets", "sampled_sets", "select"]


def attainable_sets(
    model: np.record,
    surge_speed_mps: float,
    n_directions: int = 500,
    actuators: Sequence[int] | NDArray[np.int64] | None = None,
) -> Envelope:
    """AFS and AMS of the given actuators (by their first slots; all by default) in steady flow along x_b.

    Both hulls have n_directions vertices, in the order of the same fixed directions, and 2n - 4 faces.
    Source: eq. (37)-(40).
    """
    directions, faces = direction_sphere(n_directions)
    clouds = [actuator_cloud(model, surge_speed_mps, int(i), LEVELS) for i in select(model, actuators)]
    force = _support_points([cloud[:, :3] for cloud in clouds], directions)
    moment = _support_points([cloud[:, 3:] for cloud in clouds], directions)
    return Envelope(Hull(force, faces), Hull(moment, faces))


def sampled_sets(
    model: np.record, surge_speed_mps: float, seed: int = 0, n_random: int = 20_000
) -> dict[str, Envelope]:
    """The three rows of the paper's Table 3 in the paper's way: "rudder", "thrusters", "total", and one more
    for each other kind of actuator that the vehicle has.

    Rudders: 20 levels each, all combinations; thrusters: 100 levels each, all combinations; total:
    n_random commands, uniform within bounds.
    Source: Gao et al. 2026, section 2.6 and Table 3.
    """
    cloud = _random(model, surge_speed_mps, seed, n_random)
    kinds = [k for name, k in KINDS.items() if name in PUBLISHED or len(select(model, kind=k.KIND))]
    return {
        **{k.GROUP: _grid(model, surge_speed_mps, select(model, kind=k.KIND), k.GRID) for k in kinds},
        "total": Envelope(hull_of_points(cloud[:, :3]), hull_of_points(cloud[:, 3:])),
    }


def select(
    model: np.record, actuators: Sequence[int] | NDArray[np.int64] | None = None, kind: int | None = None
) -> NDArray[np.int64]:
    """First slots of actuators: the given ones or all, of the given kind (FIN, THRUSTER, ...) or any."""
    first = np.flatnonzero(model["part"][: int(model["n_u"])] == 0)
    chosen = first if actuators is None else np.asarray(actuators, np.int64)
    return chosen if kind is None else chosen[model["kind"][chosen] == kind]


@allocating
def wrench_curves(model, surge_speed, commands, chosen):
    """Wrenches (len(chosen), levels, 6) of single actuators at commands (levels, n), N and N m.

    chosen: their first slots; commands[l, i] is the deflection (rad) or shaft speed (rev/s) of slot i.
    """
    nu_r = np.zeros(6)
    nu_r[0] = surge_speed
    curves = np.zeros((len(chosen), commands.shape[0], 6))
    for k in range(len(chosen)):
        for level in range(commands.shape[0]):
            actuator_wrench(model, chosen[k], commands[level], nu_r, curves[k, level])
    return curves


def actuator_cloud(model: np.record, surge_speed: float, first: int, count: int) -> Array:
    """Wrenches (m, 6) of the actuator whose first slot is `first`: `count` levels of each of its commands
    from lower to upper bound, in every combination."""
    parts, n = model["part"], int(model["n_u"])
    end = next((i for i in range(first + 1, n) if parts[i] == 0), n)
    levels = np.linspace(model["command_min"][:n], model["command_max"][:n], count)
    mesh = np.meshgrid(*(levels[:, i] for i in range(first, end)), indexing="ij")
    commands = np.zeros((mesh[0].size, n))
    commands[:, first:end] = np.stack([m.ravel() for m in mesh], axis=1)
    return wrench_curves(model, surge_speed, commands, np.array([first]))[0]


def _support_points(clouds: Sequence[Array], directions: Array) -> Array:
    """Points (n, 3) of the Minkowski sum of clouds (m, 3), outermost in each direction.

    Directions are spread over the set scaled to equal widths along the axes: a thin set, such as the rudders'
    forces, would else be seen from its broad sides only.
    """
    points, width = np.zeros((len(directions), 3)), np.zeros(3)
    for cloud in clouds:
        width += np.ptp(cloud, axis=0)
    width[width <= 1e-9 * width.max()] = 1.0
    for cloud in clouds:
        _add_outermost(np.ascontiguousarray(cloud), directions / width, points)
    return points


@allocating
def _add_outermost(cloud, directions, points):
    """Add to points (n, 3) the point of the cloud (m, 3) that is outermost in each direction (n, 3)."""
    for j in range(len(directions)):
        x, y, z = directions[j, 0], directions[j, 1], directions[j, 2]
        best, at = -np.inf, 0
        for level in range(cloud.shape[0]):
            reach = x * cloud[level, 0] + y * cloud[level, 1] + z * cloud[level, 2]
            if reach > best:
                best, at = reach, level
        for c in range(3):
            points[j, c] += cloud[at, c]


def _grid(model: np.record, surge_speed: float, chosen: NDArray[np.int64], count: int) -> Envelope:
    """Hulls of every combination of `count` levels of each command of the chosen actuators.

    Corners are kept after each actuator: the hull of a sum is the hull of the sum of corners, so the
    result is that of all combinations.
    """
    clouds = [actuator_cloud(model, surge_speed, int(i), count) for i in chosen]
    hulls = []
    for half in (slice(0, 3), slice(3, 6)):
        hull = hull_of_points(np.zeros((1, 3)))
        for cloud in clouds:
            hull = hull_of_points((hull.vertices[:, None, :] + cloud[None, :, half]).reshape(-1, 3))
        hulls.append(hull)
    return Envelope(hulls[0], hulls[1])


def _random(model: np.record, surge_speed: float, seed: int, count: int) -> Array:
    """Wrenches (count, 6) of commands drawn uniformly within bounds, all actuators together."""
    n = int(model["n_u"])
    draw = np.random.default_rng(seed).random((count, n))
    low, high = model["command_min"][:n], model["command_max"][:n]
    return wrench_curves(model, surge_speed, low + (high - low) * draw, np.arange(n)).sum(axis=0)
