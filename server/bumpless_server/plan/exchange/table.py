"""A table of waypoints (CSV): one row a place, its columns named in the first row."""

import csv
import io

from bumpless.config.text import BOM
from bumpless_server.plan.exchange.route import NotImportable, Point, Route, geographic, number

CSV = "a table of waypoints (CSV)"
NAMES = {  # what people call a column, in lower case without unit marks
    "north": ("north_m", "north", "n", "y", "y_m"),
    "east": ("east_m", "east", "e", "x", "x_m"),
    "latitude": ("latitude_deg", "latitude", "lat"),
    "longitude": ("longitude_deg", "longitude", "lon", "lng", "long"),
    "depth": ("depth_m", "depth", "down_m", "down", "z_down"),
    "altitude": ("altitude_m", "altitude", "alt", "elevation", "ele"),
    "speed": ("speed_mps", "speed_m_s", "speed", "velocity"),
}


def read_csv(text: str) -> Route:
    """Rows of north_m and east_m, or of latitude and longitude; depth and speed where they are given."""
    text = text.removeprefix(BOM)
    try:
        dialect = csv.Sniffer().sniff(text[:4096], ",;\t")
        rows = list(csv.reader(io.StringIO(text), dialect))
    except csv.Error as error:
        raise NotImportable(f"is no table of waypoints that can be read: {error}") from None
    head = [cell.strip().lower().replace(" ", "_") for cell in rows[0]] if rows else []
    columns = {key: _column(head, names) for key, names in NAMES.items()}
    on_earth = columns["latitude"] is not None and columns["longitude"] is not None
    if not on_earth and (columns["north"] is None or columns["east"] is None):
        raise NotImportable("has no columns north_m and east_m, and none for latitude and longitude")
    route = Route(CSV, geographic=on_earth)
    for name in head:
        if name and not any(name in names for names in NAMES.values()):
            route.left(f"column {name}", "has no meaning here")
    for i, row in enumerate(rows[1:], 2):
        if any(cell.strip() for cell in row):
            route.points.append(_point(route, row, columns, f"row {i}"))
    route.carried("rows", f"{len(route.points)} places")
    return route


def _point(route: Route, row: list[str], columns: dict[str, int | None], what: str) -> Point:
    def cell(key: str) -> float | None:
        at = columns[key]
        text = row[at].strip() if at is not None and at < len(row) else ""
        return number(text, f"{what}, {key}") if text else None

    first, second = (cell(k) for k in (("latitude", "longitude") if route.geographic else ("north", "east")))
    if first is None or second is None:
        raise NotImportable(f"{what} has no place")
    if route.geographic:
        first, second = geographic(first, second, what)
    depth, altitude = cell("depth"), cell("altitude")
    if depth is None and altitude is not None and altitude <= 0.0:
        depth = -altitude
    return Point(first, second, depth, cell("speed"))


def _column(head: list[str], names: tuple[str, ...]) -> int | None:
    return next((head.index(name) for name in names if name in head), None)
