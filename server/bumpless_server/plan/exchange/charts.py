"""Ways drawn on charts: GeoJSON and KML."""

import json
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element

from bumpless.config.text import BOM
from bumpless_server.plan.exchange.hostile import local_name, parsed
from bumpless_server.plan.exchange.route import NotImportable, Point, Route, depth_of, geographic, number

GEOJSON, KML = "GeoJSON", "a KML file"


def read_geojson(text: str) -> Route:
    """The first line, or all points in order when there is no line. Source: RFC 7946."""
    try:
        tree = json.loads(text.removeprefix(BOM))
    except (ValueError, RecursionError) as error:
        raise NotImportable(f"is not valid JSON: {error}") from None
    route = Route(GEOJSON, geographic=True)
    found = list(_features(tree, 0))
    line = next(
        (i for i, (_, kind, *_) in enumerate(found) if kind in ("LineString", "MultiLineString")), None
    )
    for i, (name, kind, coordinates, speed) in enumerate(found):
        what = f"feature {i + 1}: {name or kind}"
        if i == line and kind == "MultiLineString":
            coordinates = [place for part in _rows(coordinates, what) for place in _rows(part, what)]
        if i == line:
            _line(route, what, coordinates, speed)
        elif kind == "Point" and line is None:
            _line(route, what, [coordinates], speed)
        else:
            route.left(what, f"a {kind} is no way" if line is None else "one way is imported, the first line")
    return route


def read_kml(data: bytes) -> Route:
    """The first line (LineString or gx:Track), or all placemarks that are points, in order."""
    root = parsed(data)
    route = Route(KML, geographic=True)
    marks = [mark for mark in root.iter() if local_name(mark) == "Placemark"]
    lines = [mark for mark in marks if _places(mark, ("LineString", "Track"))]
    for i, mark in enumerate(marks, 1):
        what = f"placemark {i}: {_text(mark, 'name') or 'without a name'}"
        points = _places(mark, ("LineString", "Track") if lines else ("Point",))
        if not points or (lines and mark is not lines[0]):
            reason = "one way is imported, the first line" if lines else "it is no point and no line"
            route.left(what, reason)
            continue
        _line(route, what, points, None)
    for kind in ("GroundOverlay", "ScreenOverlay", "NetworkLink"):
        for element in root.iter():
            if local_name(element) == kind:
                route.left(f"{kind}: {_text(element, 'name')}", "pictures and links are not imported")
    return route


def _features(tree: Any, depth: int) -> Iterator[tuple[str, str, Any, float | None]]:
    """(name, kind of geometry, coordinates, speed) of every feature."""
    kind = tree.get("type") if isinstance(tree, dict) else None
    if not isinstance(kind, str) or depth > 8:
        raise NotImportable("is JSON, but no GeoJSON: an object has no type")
    if kind == "FeatureCollection":
        for feature in _rows(tree.get("features"), "features"):
            yield from _features(feature, depth + 1)
    elif kind == "Feature":
        told = tree.get("properties") or {}
        for _, inner, coordinates, _ in _features(tree.get("geometry"), depth + 1):
            speed = told.get("speed_mps") if isinstance(told, dict) else None
            name = str(told.get("name", "")) if isinstance(told, dict) else ""
            yield name[:80], inner, coordinates, None if speed is None else number(speed, "speed_mps")
    elif kind == "GeometryCollection":
        for geometry in _rows(tree.get("geometries"), "geometries"):
            yield from _features(geometry, depth + 1)
    else:
        yield "", kind, tree.get("coordinates"), None


def _line(route: Route, what: str, coordinates: Any, speed: float | None) -> None:
    """Take a row of [longitude, latitude, height] over."""
    notes = set[str]()
    for k, place in enumerate(_rows(coordinates, what), 1):
        numbers = [number(value, f"{what}, place {k}") for value in _rows(place, what)]
        if len(numbers) < 2:
            raise NotImportable(f"{what}, place {k} has no longitude and latitude")
        latitude, longitude = geographic(numbers[1], numbers[0], f"{what}, place {k}")
        depth, note = depth_of(numbers[2]) if len(numbers) > 2 and numbers[2] != 0.0 else (None, "")
        notes.add(note)
        route.points.append(Point(latitude, longitude, depth, speed))
    count = len(coordinates)
    route.carried(what, "; ".join([f"{count} places" if count > 1 else "one place", *sorted(notes - {""})]))


def _rows(value: Any, what: str) -> list[Any]:
    if not isinstance(value, list):
        raise NotImportable(f"{what} holds {type(value).__name__}, not a list")
    return value


def _places(mark: Element, kinds: tuple[str, ...]) -> list[list[str]]:
    """Places of a placemark's geometries of these kinds, as texts."""
    found: list[list[str]] = []
    for element in mark.iter():
        if local_name(element) not in kinds:
            continue
        for inner in element.iter():
            if local_name(inner) == "coordinates":
                found += [place.split(",") for place in (inner.text or "").split()]
            elif local_name(inner) == "coord":
                found.append((inner.text or "").split())
    return found


def _text(element: Element, name: str) -> str:
    found = next((child.text for child in element if local_name(child) == name), None)
    return (found or "").strip()[:80]
