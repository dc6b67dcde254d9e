"""Neptus' missions: `.nmis` (XML), alone or packed (`.nmisz`)."""

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element

from bumpless_server.plan.exchange.hostile import local_name, parsed
from bumpless_server.plan.exchange.route import NotImportable, Point, Route, geographic, number

NEPTUS = "a Neptus mission"
_ANGLE = re.compile(
    r"\s*(?P<deg>[-+]?[\d.]+)\s*(?P<side>[NSEW])?\s*(?:(?P<min>[\d.]+)\s*'?\s*(?:(?P<sec>[\d.]+)\s*(?:''|\")?)?)?\s*"
    r"(?P<late>[NSEW])?\s*",
    re.IGNORECASE,
)
_FLOWN = {"Goto": "", "PopUp": "surfacing is not done"}


def read_nmis(data: bytes) -> Route:
    """The first plan's manoeuvres in the order of its transitions; their places become waypoints."""
    root = parsed(data)
    route = Route(NEPTUS, geographic=True)
    home = next((e for e in root.iter() if local_name(e) in ("homeref", "home-reference", "home")), None)
    place = _place(home) if home is not None else None
    if place is not None:
        route.home = place[0], place[1]
        route.carried("home reference", "is the mission's origin")
    plans = [e for e in root.iter() if local_name(e) in ("individual-plan", "plan", "single-vehicle-plan")]
    plans = [plan for plan in plans if any(local_name(e) == "node" for e in plan.iter())] or [root]
    for plan in plans[1:]:
        route.left(
            f"plan {plan.get('id') or plan.get('name') or ''}".strip(), "one plan is imported, the first"
        )
    route.title = plans[0].get("id") or ""
    for node in _ordered(plans[0]):
        _maneuver(route, node)
    return route


def _ordered(plan: Element) -> Iterator[Element]:
    """The plan's nodes along its transitions from the first; those that none leads to come last."""
    nodes = {
        _child(n, "id") or str(i): n for i, n in enumerate(e for e in plan.iter() if local_name(e) == "node")
    }
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
        next((child for child in holder if local_name(child) != "annotation"), None)
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
    if depth := _child(place, "depth"):
        return max(number(depth, "depth"), 0.0), ""
    if height := _child(place, "height"):
        return max(-number(height, "height"), 0.0), ""
    units = next((e.text for e in around.iter() if local_name(e) in ("z-units", "zunits")), None)
    z = next((e.text for e in around.iter() if local_name(e) == "z"), None)
    if z is None or units is None:
        return None, ""
    if units.strip().upper() == "DEPTH":
        return max(number(z, "z"), 0.0), ""
    return None, f"{units.strip().lower()} of {z.strip()} m: the depth is to be set"


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
    side = (found["side"] or found["late"] or "").upper()
    return -size if side in ("S", "W") or parts[0] < 0.0 else size


def _child(element: Element, name: str) -> str:
    found = next((child.text for child in element if local_name(child) == name), None)
    return (found or "").strip()
