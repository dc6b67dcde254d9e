"""Depths at the middles of the cells of a grid, on the earth or in a local frame."""

import hashlib
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
MOST_CELLS = 4_000_000
DEEPEST_M = 11_100.0


class NotAGrid(ValueError):
    """The data are no depth grid that can be used; the text says why."""


@dataclass(frozen=True, eq=False)
class DepthGrid:
    """Depths, m, positive down, NaN where nobody knows: row 0 is the northernmost, column 0 the westernmost.

    Geographic: rows are latitudes and columns longitudes, deg, WGS 84; else m north and m east of a local
    frame.
    """

    depth_m: npt.NDArray[np.float32]  # (rows, columns)
    north: float  # of the middle of row 0, deg or m
    west: float  # of the middle of column 0
    step_north: float  # from a row to the next one south, > 0
    step_east: float  # from a column to the next one east, > 0
    geographic: bool

    def __post_init__(self) -> None:
        """Refuse what is no grid of depths in the sea."""
        if self.depth_m.ndim != 2 or min(self.depth_m.shape) < 2:
            raise NotAGrid("has fewer than two rows or columns")
        if self.depth_m.size > MOST_CELLS:
            raise NotAGrid(f"has {self.depth_m.size} cells, more than {MOST_CELLS}")
        places = (self.north, self.west, self.step_north, self.step_east)
        if not np.isfinite(places).all() or min(self.step_north, self.step_east) <= 0.0:
            raise NotAGrid("has no size of its cells that could be used")
        if self.geographic and not (abs(self.north) <= 90.0 and abs(self.west) <= 360.0):
            raise NotAGrid(f"lies at latitude {self.north:g}, longitude {self.west:g}, which is no place")
        if not np.isfinite(self.depth_m).any():
            raise NotAGrid("holds no depth at all")
        if np.nanmax(np.abs(self.depth_m)) > DEEPEST_M:
            raise NotAGrid(f"holds depths beyond {DEEPEST_M:g} m: are they metres?")

    @cached_property
    def sha256(self) -> str:
        """Hash of places and depths: the grid's identity."""
        told = (self.depth_m.shape, self.north, self.west, self.step_north, self.step_east, self.geographic)
        found = hashlib.sha256(repr(told).encode())
        found.update(np.ascontiguousarray(self.depth_m, "<f4").tobytes())
        return found.hexdigest()

    @property
    def south(self) -> float:
        """Of the middle of the last row."""
        return self.north - self.step_north * (self.depth_m.shape[0] - 1)

    @property
    def east(self) -> float:
        """Of the middle of the last column."""
        return self.west + self.step_east * (self.depth_m.shape[1] - 1)

    def at(self, first: Floats, second: Floats) -> Floats:
        """Depth at latitudes or m north (n,) and longitudes or m east (n,): bilinear; NaN where unknown."""
        if self.geographic:
            second = self.west + np.mod(second - self.west + 1e-9, 360.0)
        rows, columns = self.depth_m.shape
        y, x = (self.north - first) / self.step_north, (second - self.west) / self.step_east
        within = (y >= -1e-9) & (y <= rows - 1 + 1e-9) & (x >= -1e-9) & (x <= columns - 1 + 1e-9)
        y, x = (np.where(within, v, 0.0) for v in (y, x))
        i = np.clip(y.astype(int), 0, rows - 2)
        j = np.clip(x.astype(int), 0, columns - 2)
        v, u = np.clip(y - i, 0.0, 1.0), np.clip(x - j, 0.0, 1.0)
        # a corner that is not known does not count where its share is nothing
        parts = [(self.depth_m[i + a, j + b].astype(np.float64), s) for a, b, s in _corners(u, v)]
        found = sum(np.where(share > 0.0, value * share, 0.0) for value, share in parts)
        return np.where(within, found, np.nan)


def _corners(u: Floats, v: Floats) -> list[tuple[int, int, Floats]]:
    return [(0, 0, (1 - v) * (1 - u)), (0, 1, (1 - v) * u), (1, 0, v * (1 - u)), (1, 1, v * u)]
