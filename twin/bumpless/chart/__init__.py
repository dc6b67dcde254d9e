"""The sea floor: depth grids, and how deep it is under a place of a mission's own frame."""

from bumpless.chart.floor import Floor, floor_of, with_floor
from bumpless.chart.grid import DepthGrid, NotAGrid
from bumpless.chart.kept import from_bytes, to_bytes

__all__ = ["DepthGrid", "Floor", "NotAGrid", "floor_of", "from_bytes", "to_bytes", "with_floor"]
