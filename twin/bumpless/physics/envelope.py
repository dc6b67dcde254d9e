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
from itertools import pairwise

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
    clouds, starts = actuator_clouds(model, surge_speed_mps, select(model, actuators), LEVELS)
    force = _support_points(clouds[:, :3].copy(), starts, directions)
    moment = _support_points(clouds[:, 3:].copy(), starts, directions)
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


def actuator_clouds(
    model: np.record, surge_speed: float, chosen: NDArray[np.int64], count: int
) -> tuple[Array, NDArray[np.int64]]:
    """Wrenches (m, 6) of the actuators whose first slots are chosen (k,): `count` levels of each of their
    commands from lower to upper bound, in every combination. Those of actuator i are the rows from starts[i]
    to starts[i + 1]; starts: (k + 1,)."""
    n = int(model["n_u"])
    first = np.append(np.flatnonzero(model["part"][:n] == 0), n)
    slots = first[np.searchsorted(first, chosen) + 1] - chosen
    starts = np.concatenate(([0], np.cumsum(count**slots)))
    levels = np.linspace(model["command_min"][:n], model["command_max"][:n], count)
    return _combined(model, surge_speed, levels, chosen, slots, starts), starts


@allocating
def _combined(model, surge_speed, levels, chosen, slots, starts):
    """Wrenches (starts[-1], 6) of every combination of levels (count, n), the last slot's running fastest."""
    nu_r = np.zeros(6)
    nu_r[0] = surge_speed
    clouds = np.zeros((starts[-1], 6))
    command = np.zeros(levels.shape[1])
    for k in range(len(chosen)):
        for row in range(starts[k], starts[k + 1]):
            rest = row - starts[k]
            for slot in range(chosen[k] + slots[k] - 1, chosen[k] - 1, -1):
                command[slot] = levels[rest % levels.shape[0], slot]
                rest //= levels.shape[0]
            actuator_wrench(model, chosen[k], command, nu_r, clouds[row])
    return clouds


@allocating
def _support_points(clouds, starts, directions):
    """Points (n, 3) of the Minkowski sum of clouds (m, 3), outermost in each direction.

    Directions are spread over the set scaled to equal widths along the axes: a thin set, such as the rudders'
    forces, would else be seen from its broad sides only.
    """
    points, width = np.zeros((len(directions), 3)), np.zeros(3)
    for i in range(len(starts) - 1):
        for c in range(3):
            cloud = clouds[starts[i] : starts[i + 1], c]
            width[c] += cloud.max() - cloud.min()
    width[width <= 1e-9 * width.max()] = 1.0
    for j in range(len(directions)):
        x, y, z = directions[j, 0] / width[0], directions[j, 1] / width[1], directions[j, 2] / width[2]
        for i in range(len(starts) - 1):
            best, at = -np.inf, 0
            for row in range(starts[i], starts[i + 1]):
                reach = x * clouds[row, 0] + y * clouds[row, 1] + z * clouds[row, 2]
                if reach > best:
                    best, at = reach, row
            for c in range(3):
                points[j, c] += clouds[at, c]
    return points


def _grid(model: np.record, surge_speed: float, chosen: NDArray[np.int64], count: int) -> Envelope:
    """Hulls of every combination of `count` levels of each command of the chosen actuators.

    Corners are kept after each actuator: the hull of a sum is the hull of the sum of corners, so the
    result is that of all combinations.
    """
    clouds, starts = actuator_clouds(model, surge_speed, chosen, count)
    hulls = []
    for half in (slice(0, 3), slice(3, 6)):
        hull = hull_of_points(np.zeros((1, 3)))
        for start, end in pairwise(starts):
            hull = hull_of_points((hull.vertices[:, None, :] + clouds[None, start:end, half]).reshape(-1, 3))
        hulls.append(hull)
    return Envelope(hulls[0], hulls[1])


def _random(model: np.record, surge_speed: float, seed: int, count: int) -> Array:
    """Wrenches (count, 6) of commands drawn uniformly within bounds, all actuators together."""
    n = int(model["n_u"])
    draw = np.random.default_rng(seed).random((count, n))
    low, high = model["command_min"][:n], model["command_max"][:n]
    return wrench_curves(model, surge_speed, low + (high - low) * draw, np.arange(n)).sum(axis=0)
