"""Finite differences of the compiled cycle, in the coordinates that have memory.

The slow estimates of drift, the path law's and the approach line's, are taken as constant. Each is learnt
in some modes, or with flow over the fins, and frozen else. What is frozen is a parameter and no mode of
motion: no mode-wise function could contract it, and its 1.00000 would hide what the hull does.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bumpless.control.onboard import STATE
from bumpless.physics.plant import PLANT
from bumpless.stability.operating import Point

Array = NDArray[np.float64]

_PLANT = ("eta", "nu", "u")
# of the autopilot's state: clocks, what is taken as exact, what is frozen in H, and the estimator, which
# changes nothing until it raises an alarm
_NOT_STATE = {
    "clock.time",
    "navigation.target",
    "navigation.target_variance",
    "navigation.doubt",
    "guidance.b",
    "docking.drift",
    "docking.back_to",
    "switching.minus",
    "switching.ramp_length",
    "switching.kappa",
    "estimator",
}
_SIZE = 1e-5  # of a disturbance
_FORGETS = 1e-9  # columns below this carry nothing to the next cycle


@dataclass(frozen=True)
class Coordinate:
    """One number of the state: where it lives."""

    record: str  # "plant" or "autopilot"
    field: str  # dotted, such as "pid.integral"
    index: int
    size: float

    @property
    def name(self) -> str:
        """Such as plant.nu[3]."""
        return f"{self.record}.{self.field}[{self.index}]"

    def place(self, point: Point) -> NDArray[np.float64]:
        """The numbers of its field, (n,), to be read and changed in place."""
        here: Any = point.twin._world["plant"] if self.record == "plant" else point.twin._onboard["state"]
        for part in self.field.split("."):
            here = here[part]
        return here.reshape(-1)  # of an array of one record: a view


def _floats(dtype: np.dtype, path: str = "") -> Iterator[tuple[str, int]]:
    """(dotted name, count) of every float field of a nested record but for what is no state."""
    for name in dtype.names or ():
        here, kind = f"{path}{name}", dtype[name]
        if here in _NOT_STATE:
            continue
        if kind.names:
            yield from _floats(kind, f"{here}.")
        elif kind.base == np.float64:
            yield here, int(np.prod(kind.shape, dtype=int))


def coordinates(point: Point) -> list[Coordinate]:
    """All candidates; position north and east of the autopilot are the plant's.

    An aligned offset that is never bled off only adds to its integral, which stands for both.
    """
    bled = point.twin.onboard["settings"]["bumpless"]["align_bleed"] > 0.0
    found = [("plant", name, size) for name, size in _floats(PLANT) if name in _PLANT]
    found += [("autopilot", name, size) for name, size in _floats(STATE) if bled or name != "pid.bias"]
    return [
        Coordinate(record, name, k, _SIZE)
        for record, name, size in found
        for k in range(size)
        if record == "plant" or name != "navigation.eta" or k > 1
    ]


def _add(point: Point, at: Coordinate, amount: float) -> None:
    at.place(point)[at.index] += amount


def read(point: Point, where: list[Coordinate]) -> Array:
    """The present values of the coordinates."""
    return np.array([c.place(point)[c.index] for c in where], float)


def difference(point: Point, where: list[Coordinate], cycles: int, enter: int | None = None) -> Array:
    """Jacobian (n, n) of the state after `cycles` over the state now; `enter`: a mode to switch to first."""
    saved, mode = point.save(), point.mode
    out = np.zeros((len(where), len(where)))
    for j, coordinate in enumerate(where):
        ends = []
        for sign in (1.0, -1.0):
            point.restore(saved)
            _add(point, coordinate, sign * coordinate.size)
            if enter is not None:
                point.enter(enter)
            for _ in range(cycles):
                point.step()
            ends.append(read(point, where))
        out[:, j] = (ends[0] - ends[1]) / (2.0 * coordinate.size)
    point.restore(saved)
    point.mode = mode
    return out


def with_memory(maps: list[Array]) -> NDArray[np.int64]:
    """Indices of the coordinates that carry anything through any of the maps and are no constants.

    What carries nothing follows from the others; what nothing ever changes is a parameter.
    """
    unit = np.eye(maps[0].shape[0])
    constant = np.all([np.abs(m - unit).max(axis=1) < _FORGETS for m in maps], axis=0)
    keep = np.flatnonzero(~constant)
    while True:
        strength = np.max([np.abs(m[np.ix_(keep, keep)]).max(axis=0) for m in maps], axis=0)
        alive = strength > _FORGETS
        if alive.all():
            return keep
        keep = keep[alive]
