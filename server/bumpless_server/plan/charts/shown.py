"""A chart in metres of a mission's frame, as it is drawn."""

from dataclasses import dataclass

import numpy as np

from bumpless.chart import DepthGrid
from bumpless.config.mission.origin import Origin
from bumpless_server.plan.charts.content import Corners, Feature, Place
from bumpless_server.plan.charts.store import Chart, Charts, NoChart

MOST_ROWS = 128  # of a grid's drawing, and columns


class NotPlaced(ValueError):
    """The chart lies on the earth and the mission's frame does not."""


@dataclass(frozen=True)
class Depths:
    """A thinned grid: row by row, None where nobody knows."""

    rows: int
    columns: int
    depth_m: list[float | None]
    least_m: float
    deepest_m: float


@dataclass(frozen=True)
class Shown:
    """North and east, m."""

    chart: Chart
    features: tuple[Feature, ...] = ()
    corners: Corners | None = None
    depths: Depths | None = None


def shown(charts: Charts, name: str, origin: Origin | None) -> Shown:
    """The chart in the frame of this origin. Raises NoChart or NotPlaced."""
    chart = charts.get(name)
    if chart.geographic and origin is None:
        raise NotPlaced(f"{name} lies on the earth: give the mission an origin to show it")
    origin = origin if chart.geographic else None
    if chart.kind == "features":
        return Shown(chart, tuple(_placed(one, origin) for one in charts.features(name)))
    if chart.corners is not None:
        return Shown(chart, corners=_corners(chart.corners, origin))
    grid = charts.grid(name)
    if grid is None:
        raise NoChart(f"the chart {name!r} cannot be read")
    edges = (
        (grid.north, grid.west),
        (grid.north, grid.east),
        (grid.south, grid.east),
        (grid.south, grid.west),
    )
    return Shown(chart, corners=_corners(edges, origin), depths=thinned(grid))


def thinned(grid: DepthGrid, most: int = MOST_ROWS) -> Depths:
    """The grid with at most so many rows and columns, first and last among them."""
    rows, columns = (min(most, n) for n in grid.depth_m.shape)
    first = np.linspace(grid.north, grid.south, rows)
    second = np.linspace(grid.west, grid.east, columns)
    lat, lon = (v.ravel() for v in np.meshgrid(first, second, indexing="ij"))
    depths = grid.at(lat, lon).round(2)
    told = [float(d) if np.isfinite(d) else None for d in depths]
    least, deepest = float(np.nanmin(grid.depth_m)), float(np.nanmax(grid.depth_m))
    return Depths(rows, columns, told, round(least, 2), round(deepest, 2))


def _placed(feature: Feature, origin: Origin | None) -> Feature:
    parts = tuple(tuple((n, e) for n, e in _local(part, origin)) for part in feature.parts)
    return Feature(feature.kind, parts, feature.name, feature.colour)


def _local(part: tuple[Place, ...], origin: Origin | None) -> list[list[float]]:
    places = np.array(part, np.float64).reshape(-1, 2)
    if origin is not None:
        north, east = origin.to_local(places[:, 0], places[:, 1])
        places = np.stack([north, east], axis=1)
    return places.round(3).tolist()


def _corners(corners: Corners, origin: Origin | None) -> Corners:
    a, b, c, d = ((n, e) for n, e in _local(corners, origin))
    return a, b, c, d
