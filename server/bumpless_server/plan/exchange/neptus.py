"""Neptus' missions: `.nmis` (XML), alone or packed (`.nmisz`)."""

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element

from bumpless_server.plan.exchange.hostile import local_name, parsed
from bumpless_server.plan.exchange.route import NotImportable, Point, Route, geographic, number

NEPTUS = "a Neptus mission"
_ANGLE = re.compile(
    r"\s*(?P<early>[NSEW])?\s*(?P<deg>[-+]?[\d.]+)\s*°?\s*(?P<side>[NSEW])?\s*"
    r"(?:(?P<min>[\d.]+)\s*'?\s*(?:(?P<sec>[\d.]+)\s*(?:''|\")?)?)?\s*(?P<late>[NSEW])?\s*",
    re.IGNORECASE,
)
_FLOWN = {"Goto": "", "PopUp": "surfacing is not done", "StationKeeping": "the stay there is not done"}
_NOT_KINDS = ("minTime", "maxTime", "annotation")


def read_nmis(data: bytes, part: str | None = None) -> Route:
    """One plan's manoeuvres in the order of its transitions; their places become waypoints.

    part: the plan's name; by default the first with two places or more.
    """
    root = parsed(data)
    route = Route(NEPTUS, geographic=True)
    home = next((e for e in root.iter() if local_name(e) in ("homeref", "home-reference", "home")), None)
    place = _place(home) if home is not None else None
    if place is not None:
        route.home = place[0], place[1]
        route.carried("home reference", "is the mission's origin")
    plans = [e for e in root.iter() if local_name(e) in ("individual-plan", "plan") and _nodes(e)]
    if not plans:
        raise NotImportable("is a Neptus mission without a plan: it holds maps alone")
    route.parts = tuple(plan.get("id") or f"plan {i}" for i, plan in enumerate(plans, 1))
    if part is not None and part not in route.parts:
        raise NotImportable(f"has no plan {part!r}; there are {', '.join(route.parts)}")
    likely = next((i for i, p in enumerate(plans) if sum(_place(n) is not None for n in _nodes(p)) > 1), 0)
    chosen = likely if part is None else route.parts.index(part)
    for i, name in enumerate(route.parts):
        if i != chosen:
            route.left(f"plan {name}", "one plan is imported at a time")
    route.title = route.parts[chosen]
    for node in _ordered(plans[chosen]):
        _maneuver(route, node)
    return route


def _nodes(plan: Element) -> list[Element]:
    return [e for e in plan.iter() if local_name(e) == "node"]


def _ordered(plan: Element) -> Iterator[Element]:
    """The plan's nodes along its transitions from the first; those that none leads to come last."""
    nodes = {_child(node, "id") or str(i): node for i, node in enumerate(_nodes(plan))}
    after = {_child(e, "source"): _child(e, "target") for e in plan.iter() if local_name(e) == "edge"}
    start = next((key for key, node in nodes.items() if node.get("start") == "true"), next(iter(nodes), None))
    seen: list[str] = []
    while start in nodes and start not in seen:
        seen.append(start)
        start = after.get(start)
    yield from (nodes[key] for key in seen)
    yield from (node for key, node in nodes.items() if key not in seen)


def _maneuver(route: Route, node: Element) -> None:
    holder = next((e for e in node.iter() if local_name(e) == "maneuver"), None)
    kind = (
        next((child for child in holder if local_name(child) not in _NOT_KINDS), None)
        if holder is not None
        else None
    )
    what = f"manoeuvre {_child(node, 'id')}".strip()
    if kind is None:
        route.left(what, "it says not what to do")
        return
    what = f"{what}: {local_name(kind)}"
    place = _place(kind)
    if place is None:
        route.left(what, "it has no place")
        return
    speed, note = _speed(kind)
    notes = [_FLOWN.get(local_name(kind), "its pattern is not flown, only its place"), place[3], note]
    route.points.append(Point(place[0], place[1], place[2], speed))
    route.carried(what, "; ".join(word for word in notes if word))


def _place(element: Element) -> tuple[float, float, float | None, str] | None:
    """(latitude, longitude, depth, note) of the first coordinate inside."""
    for one in element.iter():
        latitude, longitude = _child(one, "latitude"), _child(one, "longitude")
        if latitude and longitude:
            where = geographic(_angle(latitude), _angle(longitude), "a coordinate")
            depth, note = _depth(one, element)
            return *where, depth, note
    return None


def _depth(place: Element, around: Element) -> tuple[float | None, str]:
    """(depth, note): what z says in its units, which later versions write, else the coordinate's own."""
    units = next((e.text or "" for e in around.iter() if local_name(e) in ("z-units", "zunits")), "").strip()
    z = next((e.text or "" for e in around.iter() if local_name(e) == "z"), "").strip()
    if z and units.upper() == "DEPTH":
        return max(number(z, "z"), 0.0), ""
    if z and units and units.upper() != "NONE":
        return None, f"{units.lower()} of {z} m: the depth is to be set"
    if depth := _child(place, "depth"):
        return max(number(depth, "depth"), 0.0), ""
    return None, ""


def _speed(kind: Element) -> tuple[float | None, str]:
    found = next((e for e in kind.iter() if local_name(e) in ("speed", "velocity")), None)
    if found is None or not (found.text or "").strip():
        return None, ""
    unit = (found.get("unit") or "m/s").strip().lower()
    if unit in ("m/s", "meters_ps", "metres_ps"):
        return number(found.text, "speed"), ""
    return None, f"a speed in {unit} has no meaning for another vehicle"


def _angle(text: str) -> float:
    """41N11'6.8'', 41.185, or 8W42.5 in deg."""
    found = _ANGLE.fullmatch(text)
    if found is None:
        raise NotImportable(f"{text[:40]!r} is no latitude or longitude")
    parts = [number(found[name] or 0.0, "an angle") for name in ("deg", "min", "sec")]
    size = abs(parts[0]) + parts[1] / 60.0 + parts[2] / 3600.0
    side = (found["early"] or found["side"] or found["late"] or "").upper()
    return -size if side in ("S", "W") or parts[0] < 0.0 else size


def _child(element: Element, name: str) -> str:
    found = next((child.text for child in element if local_name(child) == name), None)
    return (found or "").strip()
