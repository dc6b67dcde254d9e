"""Places of a file's own coordinate system, and grids turned from it. Coordinates are turned by pyproj."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bumpless.chart import DepthGrid
from bumpless_server.plan.charts.content import NotAChart

WGS84 = 4326
MOST_CELLS = 1_000_000  # of a grid that has to be turned


@dataclass(frozen=True)
class Place:
    """From the middle of a pixel (column, row) to x, y of the file's system: A [column, row, 1]."""

    matrix: np.ndarray  # (2, 3)
    epsg: int | None  # None: m of the missions' frame

    def xy(self, column: Any, row: Any) -> tuple[Any, Any]:
        m = self.matrix
        return m[0, 0] * column + m[0, 1] * row + m[0, 2], m[1, 0] * column + m[1, 1] * row + m[1, 2]


def turned(depths: np.ndarray, place: Place) -> tuple[DepthGrid, str]:
    """The grid along meridians and parallels (or along north and east), interpolated."""
    rows, columns = depths.shape
    along = np.linspace(0.0, 1.0, 65)
    edge_c = np.concatenate([along, along, 0.0 * along, 0.0 * along + 1.0]) * (columns - 1)
    edge_r = np.concatenate([0.0 * along, 0.0 * along + 1.0, along, along]) * (rows - 1)
    x, y = on_earth(*place.xy(edge_c, edge_r), place.epsg)
    thin = max(1.0, np.sqrt(depths.size / MOST_CELLS))
    n_rows, n_columns = (max(2, round(n / thin)) for n in (rows, columns))
    south, north, west, east = y.min(), y.max(), x.min(), x.max()
    step_n, step_e = (north - south) / (n_rows - 1), (east - west) / (n_columns - 1)
    lon, lat = np.meshgrid(west + step_e * np.arange(n_columns), north - step_n * np.arange(n_rows))
    if place.epsg is None:
        px, py = lon, lat
    else:
        from pyproj import Transformer

        back = Transformer.from_crs(WGS84, place.epsg, always_xy=True)
        px, py = back.transform(lon, lat)
    inverse = np.linalg.inv(place.matrix[:, :2])
    px, py = px - place.matrix[0, 2], py - place.matrix[1, 2]
    column, row = inverse[0, 0] * px + inverse[0, 1] * py, inverse[1, 0] * px + inverse[1, 1] * py
    source = DepthGrid(depths, 0.0, 0.0, 1.0, 1.0, False)
    found = source.at(-row.ravel(), column.ravel()).reshape(lat.shape)
    grid = DepthGrid(found.astype(np.float32), north, west, step_n, step_e, place.epsg is not None)
    system = (
        "turned to north"
        if place.epsg is None
        else f"turned from EPSG:{place.epsg} to latitude and longitude"
    )
    return grid, f"{system}: {n_rows} rows of {n_columns}"


def on_earth(x: np.ndarray, y: np.ndarray, epsg: int | None) -> tuple[np.ndarray, np.ndarray]:
    """(longitudes, latitudes) of places of a system; places of the missions' frame stay."""
    if epsg in (None, WGS84):
        return x, y
    from pyproj import Transformer

    lon, lat = Transformer.from_crs(epsg, WGS84, always_xy=True).transform(x, y)
    if not (np.isfinite(lon).all() and np.isfinite(lat).all()):
        raise NotAChart(f"lies outside of where EPSG:{epsg} is defined")
    return lon, lat


def known_system(code: int) -> int:
    """The EPSG code, where there is such a system. Raises NotAChart."""
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    try:
        CRS.from_epsg(code)
    except CRSError:
        raise NotAChart(f"is in a coordinate system that nobody knows, EPSG:{code}") from None
    return code
