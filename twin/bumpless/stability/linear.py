"""Finite differences of the compiled cycle, in the coordinates that have memory.

The path law's slow estimate of drift is taken as constant: in H it is frozen, so no mode-wise function
could contract it there.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bumpless.stability.operating import Point

Array = NDArray[np.float64]

_PLANT = ("eta", "nu", "u")
# of the autopilot every number may have memory but these: clocks, what is taken as exact, what is frozen in H
_NOT_STATE = {"time", "hover_time", "solve_time", "target", "b", "hold_point", "ramp_length", "kappa"}
_SIZE = 1e-5  # of a disturbance
_FORGETS = 1e-9  # columns below this carry nothing to the next cycle


@dataclass(frozen=True)
class Coordinate:
    """One number of the state: where it lives."""

    record: str
    field: str
    index: int
    size: float

    @property
    def name(self) -> str:
        """Such as plant.nu[3]."""
        return f"{'autopilot' if self.record == '_a' else 'plant'}.{self.field}[{self.index}]"


def coordinates(point: Point) -> list[Coordinate]:
    """All candidates; position north and east of the autopilot are the plant's.

    An aligned offset that is never bled off only adds to its integral, which stands for both.
    """
    skipped = _NOT_STATE | (set() if point.twin._settings[0]["align_bleed"] > 0.0 else {"bias"})
    numbers = point.twin._a.dtype
    names = [n for n in numbers.names or () if numbers[n].base == np.float64 and n not in skipped]
    found = []
    for record, fields in (("_plant", _PLANT), ("_a", names)):
        rows = getattr(point.twin, record)
        for name in fields:
            count = int(np.prod(rows.dtype[name].shape)) if rows.dtype[name].shape else 1
            for k in range(count):
                if not (record == "_a" and name == "eta" and k < 2):
                    found.append(Coordinate(record, name, k, _SIZE))
    return found


def _add(point: Point, at: Coordinate, amount: float) -> None:
    row = getattr(point.twin, at.record)[0]
    if row.dtype[at.field].shape:
        row[at.field][at.index] += amount
    else:
        row[at.field] += amount


def read(point: Point, where: list[Coordinate]) -> Array:
    """The present values of the coordinates."""
    return np.array([np.atleast_1d(getattr(point.twin, c.record)[0][c.field])[c.index] for c in where], float)


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
