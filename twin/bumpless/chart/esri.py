"""ESRI ASCII grids (`.asc`): six lines of head, then rows from north to south."""

import re

import numpy as np

from bumpless.chart.grid import MOST_CELLS, DepthGrid, NotAGrid

_HEAD = re.compile(
    r"\s*(ncols|nrows|xllcorner|xllcenter|yllcorner|yllcenter|cellsize|dx|dy|nodata_value)\s+(\S+)", re.I
)
_NEEDED = ("ncols", "nrows")


def read_esri(text: str, geographic: bool, down: bool | None = None) -> DepthGrid:
    """The grid; x is longitude or east, y latitude or north. down: numbers are depths; None: as they look.

    Raises NotAGrid.
    """
    head, end = _head(text)
    columns, rows = (_count(head, name) for name in ("ncols", "nrows"))
    if columns * rows > MOST_CELLS:
        raise NotAGrid(f"has {columns * rows} cells, more than {MOST_CELLS}")
    step_east, step_north = (head.get(name, head.get("cellsize", np.nan)) for name in ("dx", "dy"))
    west = head["xllcenter"] if "xllcenter" in head else head.get("xllcorner", np.nan) + 0.5 * step_east
    south = head["yllcenter"] if "yllcenter" in head else head.get("yllcorner", np.nan) + 0.5 * step_north
    values = _values(text[end:], rows, columns)
    values[values == head.get("nodata_value", -9999.0)] = np.nan
    north = south + step_north * (rows - 1)
    depths = as_depths(values, down)
    return DepthGrid(depths, float(north), float(west), float(step_north), float(step_east), geographic)


def as_depths(values: np.ndarray, down: bool | None) -> np.ndarray:
    """Depths, positive down, float32: where nobody says, mostly negative numbers are heights."""
    if down is None:
        known = values[np.isfinite(values)]
        down = bool(len(known) == 0 or np.median(known) >= 0.0)
    return np.asarray(values if down else -values, np.float32)


def _head(text: str) -> tuple[dict[str, float], int]:
    head: dict[str, float] = {}
    end = 0
    while found := _HEAD.match(text, end):
        try:
            head[found[1].lower()] = float(found[2])
        except ValueError:
            raise NotAGrid(f"says {found[2][:40]!r} for {found[1]}, which is no number") from None
        end = found.end()
    missing = [name for name in _NEEDED if name not in head]
    if missing:
        raise NotAGrid(f"has no {' and no '.join(missing)} in its head")
    return head, end


def _count(head: dict[str, float], name: str) -> int:
    if not (head[name].is_integer() and 2 <= head[name] <= MOST_CELLS):
        raise NotAGrid(f"has {head[name]:g} for {name}")
    return int(head[name])


def _values(body: str, rows: int, columns: int) -> np.ndarray:
    try:
        values = np.array(body.split(), np.float64)
    except ValueError as error:
        raise NotAGrid(f"holds something that is no number ({error})") from None
    if values.size != rows * columns:
        raise NotAGrid(f"holds {values.size} numbers, its head says {rows} rows of {columns}")
    return values.reshape(rows, columns)
