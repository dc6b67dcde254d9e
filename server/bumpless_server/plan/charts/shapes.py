"""Shapes drawn on charts: GeoJSON and KML."""

import json
import re
from collections.abc import Iterator
from typing import Any, Literal
from xml.etree.ElementTree import Element

from bumpless.config.text import BOM
from bumpless_server.plan.charts.content import Content, Feature, NotAChart, Place
from bumpless_server.plan.exchange.hostile import local_name, parsed
from bumpless_server.plan.exchange.route import geographic, number

MOST_FEATURES, MOST_PLACES, DEEPEST = 5000, 200_000, 8
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}")
_SHAPES = {  # GeoJSON's kinds: how many lists lie around a place, and what each innermost row is
    "Point": (0, "point"),
    "MultiPoint": (1, "point"),
    "LineString": (1, "line"),
    "MultiLineString": (2, "line"),
    "Polygon": (2, "area"),
    "MultiPolygon": (3, "area"),
}  # fmt: skip


class Gathered:
    """Features so far, and how many places they have."""

    def __init__(self, local: bool) -> None:
        self.features: list[Feature] = []
        self._places, self._local = 0, local

    def add(self, kind: str, parts: list[list[Place]], name: str, colour: str) -> None:
        """Take a feature in. Raises NotAChart when there are too many."""
        shape: Literal["point", "line", "area"] = (
            "point" if kind == "point" else "line" if kind == "line" else "area"
        )
        self._places += sum(map(len, parts))
        if len(self.features) >= MOST_FEATURES or self._places > MOST_PLACES:
            raise NotAChart(f"holds more than {MOST_FEATURES} shapes or {MOST_PLACES} places")
        if all(parts) and parts:
            self.features.append(Feature(shape, tuple(map(tuple, parts)), name[:80], colour))

    def place(self, x: Any, y: Any, what: str) -> Place:
        """(latitude, longitude), or (north, east) of a local chart, whose x is east and y north."""
        east, north = number(x, what), number(y, what)
        if not self._local:
            return geographic(north, east, what)
        if max(abs(north), abs(east)) > 1e6:
            raise NotAChart(f"{what}: {north:g}, {east:g} is too far away")
        return north, east


def read_geojson(text: str, local: bool) -> Content:
    """Every geometry of a GeoJSON. Source: RFC 7946. Raises NotAChart or NotImportable."""
    try:
        tree = json.loads(text.removeprefix(BOM))
    except (ValueError, RecursionError) as error:
        raise NotAChart(f"is not valid JSON: {error}") from None
    found, notes = Gathered(local), set[str]()
    for name, colour, kind, coordinates in _geometries(tree, 0, "", ""):
        if kind not in _SHAPES:
            notes.add(f"a {kind} is not drawn")
            continue
        depth, shape = _SHAPES[kind]
        _shape(found, coordinates, depth, shape, name, colour)
    return Content("features", "a GeoJSON file", not local, tuple(sorted(notes)), tuple(found.features))


def _geometries(tree: Any, depth: int, name: str, colour: str) -> Iterator[tuple[str, str, str, Any]]:
    """(name, colour, kind, coordinates) of every geometry."""
    if tree is None and depth:  # a feature without a geometry
        return
    if not isinstance(tree, dict) or not isinstance(kind := tree.get("type"), str) or depth > DEEPEST:
        raise NotAChart("is JSON, but no GeoJSON: an object has no type")
    if kind in ("FeatureCollection", "GeometryCollection"):
        inner = tree.get("features" if kind == "FeatureCollection" else "geometries")
        for one in _rows(inner, kind):
            yield from _geometries(one, depth + 1, name, colour)
    elif kind == "Feature":
        told = tree.get("properties")
        told = told if isinstance(told, dict) else {}
        said = next((str(told[k]) for k in ("name", "title", "NAME") if told.get(k)), "")
        drawn = next((v for k in ("stroke", "marker-color", "fill") if _is_colour(v := told.get(k))), "")
        yield from _geometries(tree.get("geometry"), depth + 1, said, str(drawn))
    else:
        yield name, colour, kind, tree.get("coordinates")


def _is_colour(value: Any) -> bool:
    return isinstance(value, str) and _COLOUR.fullmatch(value) is not None


def _shape(found: Gathered, coordinates: Any, depth: int, shape: str, name: str, colour: str) -> None:
    """Features of coordinates that lie in `depth` lists."""
    what = f"a {shape}" + (f" {name}" if name else "")
    if depth == 0:
        found.add(shape, [_row(found, [coordinates], what)], name, colour)
    elif shape == "area" and depth == 2:
        found.add(shape, [_row(found, ring, what) for ring in _rows(coordinates, what)], name, colour)
    elif shape == "line" and depth == 1:
        found.add(shape, [_row(found, coordinates, what)], name, colour)
    else:
        for one in _rows(coordinates, what):
            _shape(found, one, depth - 1, shape, name, colour)


def _row(found: Gathered, places: Any, what: str) -> list[Place]:
    row = [_rows(place, what) for place in _rows(places, what)]
    if any(len(place) < 2 for place in row):
        raise NotAChart(f"{what} has a place without two numbers")
    return [found.place(place[0], place[1], what) for place in row]


def _rows(value: Any, what: str) -> list[Any]:
    if not isinstance(value, list):
        raise NotAChart(f"{what} holds {type(value).__name__}, not a list")
    return value


def read_kml(data: bytes) -> Content:
    """Every placemark of a KML. Raises NotAChart or NotImportable."""
    root, found, notes = parsed(data), Gathered(False), set[str]()
    styles = {f"#{e.get('id')}": _colour(e) for e in root.iter() if local_name(e) == "Style" and e.get("id")}
    for mark in root.iter():
        kind = local_name(mark)
        if kind in ("GroundOverlay", "ScreenOverlay", "NetworkLink", "Model"):
            notes.add(f"a {kind} is not shown: store its picture by itself, with corners")
        if kind != "Placemark":
            continue
        style = _text(mark, "styleUrl")
        colour = next(
            (c for e in mark if local_name(e) == "Style" and (c := _colour(e))), styles.get(style, "")
        )
        for shape, parts in _kml_shapes(found, mark):
            found.add(shape, parts, _text(mark, "name"), colour)
    return Content("features", "a KML file", True, tuple(sorted(notes)), tuple(found.features))


def _kml_shapes(found: Gathered, mark: Element) -> Iterator[tuple[str, list[list[Place]]]]:
    inside = {id(inner) for e in mark.iter() if local_name(e) == "Polygon" for inner in e.iter()}
    for element in mark.iter():
        kind = local_name(element)
        if kind == "Polygon":
            rings = [e for e in element.iter() if local_name(e) == "LinearRing"]
            outer = [e for e in element if local_name(e) == "outerBoundaryIs"]
            if outer:
                first = next((e for e in outer[0].iter() if local_name(e) == "LinearRing"), None)
                rings.sort(key=lambda ring: ring is not first)
            yield "area", [_kml_row(found, ring) for ring in rings]
        elif kind in ("Point", "LineString", "LinearRing", "Track") and id(element) not in inside:
            yield "point" if kind == "Point" else "line", [_kml_row(found, element)]


def _kml_row(found: Gathered, element: Element) -> list[Place]:
    texts: list[list[str]] = []
    for inner in element.iter():
        if local_name(inner) == "coordinates":
            texts += [place.split(",") for place in (inner.text or "").split()]
        elif local_name(inner) == "coord":
            texts.append((inner.text or "").split())
    if any(len(place) < 2 for place in texts):
        raise NotAChart("has a place without longitude and latitude")
    return [found.place(place[0], place[1], "a place") for place in texts]


def _colour(style: Element) -> str:
    """KML writes aabbggrr."""
    for element in style.iter():
        said = (element.text or "").strip()
        if local_name(element) == "color" and re.fullmatch(r"[0-9a-fA-F]{8}", said):
            return f"#{said[6:8]}{said[4:6]}{said[2:4]}".lower()
    return ""


def _text(element: Element, name: str) -> str:
    found = next((child.text for child in element if local_name(child) == name), None)
    return (found or "").strip()[:80]
