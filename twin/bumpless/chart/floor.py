"""How deep the sea is under a mission: its depth grid, or a flat floor."""

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from bumpless.chart.grid import DepthGrid
from bumpless.config.mission import Mission
from bumpless.config.mission.origin import Origin

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Floor:
    """A sea floor in a mission's frame."""

    grid: DepthGrid | None = None
    origin: Origin | None = None  # of the frame; needed where the grid is geographic
    flat_m: float = 0.0  # depth where there is no grid
    level_m: float = 0.0  # of the water above the grid's zero

    def depth(self, north_m: npt.ArrayLike, east_m: npt.ArrayLike) -> Floats:
        """Depth of the floor below the surface at places of the mission's frame, m; NaN where unknown."""
        north, east = (np.atleast_1d(np.asarray(v, np.float64)) for v in (north_m, east_m))
        if self.grid is None:
            return np.full(north.shape, self.flat_m)
        if self.grid.geographic:
            assert self.origin is not None
            north, east = self.origin.to_geographic(north, east)
        return self.grid.at(north, east) + self.level_m


def with_floor(mission: Mission, grid: DepthGrid | None) -> Mission:
    """The mission with its depth grid found, so that check and judge know it."""
    return replace(mission, depth_grid=grid)


def floor_of(mission: Mission) -> Floor | None:
    """The floor that a mission is to keep clear of; None where it names none or its grid can't be placed."""
    said = mission.sea_floor
    if said is None:
        return None
    if not said.grid:
        flat = mission.environment.water_depth_m
        return Floor(flat_m=flat) if flat > 0.0 else None
    grid = mission.depth_grid
    if not isinstance(grid, DepthGrid) or (grid.geographic and mission.origin is None):
        return None
    return Floor(grid, mission.origin, level_m=said.water_level_m)
