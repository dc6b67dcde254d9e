"""QGroundControl's `.plan` (JSON) and MAVLink's list of waypoints (`QGC WPL 110`)."""

import json
import math
from typing import Any

from bumpless.config.mission.origin import Origin
from bumpless.config.mission.zones import MOST_CORNERS
from bumpless.config.text import BOM
from bumpless_server.plan.exchange.commands import FENCES, GLOBAL_FRAMES, PLACES, RALLIES, SPEED, name_of
from bumpless_server.plan.exchange.route import (
    NotImportable,
    Point,
    Route,
    Zone,
    depth_of,
    geographic,
    number,
)

CIRCLE_CORNERS = 24
PLAN, WPL = "a QGroundControl plan", "a list of waypoints (QGC WPL)"


def read_plan(text: str) -> Route:
    """The way of a `.plan`; surveys and other patterns give their own transects where they hold them."""
    tree = _json(text)
    mission = tree.get("mission") if isinstance(tree, dict) else None
    if not isinstance(mission, dict) or not isinstance(mission.get("items"), list):
        raise NotImportable("is JSON, but no QGroundControl plan: it has no mission with items")
    route = Route(PLAN, geographic=True)
    home = mission.get("plannedHomePosition")
    if isinstance(home, list) and len(home) >= 2:
        route.home = geographic(
            number(home[0], "the home latitude"), number(home[1], "the home longitude"), "the home position"
        )
        route.carried("planned home position", "is the mission's origin")
    _vehicle(route, mission)
    _walk(route, mission["items"], "item", 0)
    _beside(route, tree)
    return route


def read_wpl(text: str) -> Route:
    """The way of a WPL file; its first row is the home position."""
    route = Route(WPL, geographic=True)
    rows = [line.split() for line in text.removeprefix(BOM).splitlines()[1:] if line.strip()]
    speed: float | None = None
    commands = set[int]()
    for i, row in enumerate(rows):
        what = f"row {i}"
        if len(row) < 12:
            raise NotImportable(f"{what} has {len(row)} columns; a row of a WPL file has 12")
        frame, command = int(number(row[2], f"{what}, frame")), int(number(row[3], f"{what}, command"))
        params = [number(value, f"{what}, column {k}") for k, value in enumerate(row[4:11], 5)]
        if i == 0 and command == 16:
            route.home = geographic(params[4], params[5], what)
            route.carried(f"{what}: home", "is the mission's origin")
            continue
        commands.add(command)
        speed = _command(route, f"{what}: {name_of(command)}", command, frame, params, speed)
    for kind, those in (("fence points", FENCES), ("rally points", RALLIES)):
        if commands and commands <= set(those):
            raise NotImportable(f"is a list of {kind} (QGC WPL), not of waypoints: it says nowhere to go")
    return route


def _json(text: str) -> Any:
    try:
        return json.loads(text.removeprefix(BOM))
    except (ValueError, RecursionError) as error:
        raise NotImportable(f"is not valid JSON: {error}") from None


def _vehicle(route: Route, mission: dict[str, Any]) -> None:
    for field, words in (("cruiseSpeed", "cruise speed"), ("hoverSpeed", "hover speed")):
        if field in mission:
            route.left(words, "belongs to another vehicle; legs have speeds of their own")
    if "vehicleType" in mission or "firmwareType" in mission:
        route.left("firmware and vehicle type", "the mission names one of our vehicles")


def _walk(
    route: Route, items: list[Any], prefix: str, depth: int, speed: float | None = None
) -> float | None:
    for i, item in enumerate(items):
        what = f"{prefix} {i + 1}"
        if not isinstance(item, dict):
            raise NotImportable(f"{what} is no object")
        if item.get("type") == "ComplexItem" or "complexItemType" in item:
            speed = _pattern(route, item, what, depth, speed)
            continue
        command = int(number(item.get("command"), f"{what}, command"))
        frame = int(number(item.get("frame", 3), f"{what}, frame"))
        params = item.get("params")
        if not isinstance(params, list) or len(params) < 7:
            raise NotImportable(f"{what} has no seven params")
        values = [0.0 if p is None else number(p, f"{what}, param {k}") for k, p in enumerate(params, 1)]
        speed = _command(route, f"{what}: {name_of(command)}", command, frame, values, speed)
    return speed


def _pattern(route: Route, item: dict[str, Any], what: str, depth: int, speed: float | None) -> float | None:
    kind = str(item.get("complexItemType", "pattern"))
    inner = item.get("TransectStyleComplexItem", item)
    steps = inner.get("Items") if isinstance(inner, dict) else None
    if not isinstance(steps, list) or depth > 0:
        route.left(f"{what}: {kind}", "its pattern is made by QGroundControl; draw its legs")
        return speed
    route.carried(f"{what}: {kind}", "as the legs it was made of; it is no pattern any more")
    return _walk(route, steps, f"{what}, step", depth + 1, speed)


def _command(
    route: Route, what: str, command: int, frame: int, params: list[float], speed: float | None
) -> float | None:
    """Take one command over, or say why not; the speed in force after it."""
    if command == SPEED:
        if params[1] > 0.0:
            route.carried(what, f"{params[1]:g} m/s from here on")
            return params[1]
        route.left(what, "no speed in it")
        return speed
    if command not in PLACES:
        route.left(what, "there is no such thing in a mission of ours")
        return speed
    if frame not in GLOBAL_FRAMES:
        route.left(what, f"frame {frame} is not one of latitude and longitude")
        return speed
    if params[4] == 0.0 and params[5] == 0.0:
        route.left(what, "it has no place of its own")
        return speed
    latitude, longitude = geographic(params[4], params[5], what)
    depth, note = depth_of(params[6])
    notes = [PLACES[command], note, f"the hold of {params[0]:g} s is not done" if params[0] else ""]
    if frame in (10, 11):
        depth, notes[1] = None, "height above the ground is not known: the depth is to be set"
    route.points.append(Point(latitude, longitude, depth, speed))
    route.carried(what, "; ".join(note for note in notes if note))
    return speed


def _beside(route: Route, tree: dict[str, Any]) -> None:
    """Fences and rally points."""
    fence, rally = tree.get("geoFence"), tree.get("rallyPoints")
    fence = fence if isinstance(fence, dict) else {}
    for i, given in enumerate(fence.get("polygons") or ()):
        corners = given.get("polygon") if isinstance(given, dict) else given
        _fence(route, f"geofence polygon {i + 1}", given, corners)
    for i, given in enumerate(fence.get("circles") or ()):
        circle = given.get("circle") if isinstance(given, dict) else None
        corners = _round(circle, f"geofence circle {i + 1}") if isinstance(circle, dict) else None
        _fence(route, f"geofence circle {i + 1}", given, corners)
    for i, _ in enumerate(rally.get("points") or () if isinstance(rally, dict) else ()):
        route.left(f"rally point {i + 1}", "the vehicle waves off to where its approach began")


def _fence(route: Route, what: str, given: Any, corners: Any) -> None:
    if not isinstance(corners, list) or not 3 <= len(corners) <= MOST_CORNERS:
        route.left(what, f"its outline has not 3 to {MOST_CORNERS} corners")
        return
    places = []
    for corner in corners:
        if not isinstance(corner, list) or len(corner) < 2:
            raise NotImportable(f"{what}: a corner is no latitude and longitude")
        latitude, longitude = (number(value, f"{what}, corner") for value in corner[:2])
        places.append(geographic(latitude, longitude, what))
    inside = not isinstance(given, dict) or bool(given.get("inclusion", True))
    if inside and any(zone.inside for zone in route.zones):
        route.left(what, "a mission has one boundary to keep inside")
        return
    route.zones.append(Zone(inside, tuple(places)))
    route.carried(what, "as the keep-in boundary" if inside else "as a keep-out zone over all depths")


def _round(circle: dict[str, Any], what: str) -> list[list[float]] | None:
    """A circle as an outline of latitudes and longitudes."""
    center = circle.get("center")
    if not isinstance(center, list) or len(center) < 2:
        return None
    radius = number(circle.get("radius"), f"{what}, radius")
    latitude, longitude = (number(value, f"{what}, centre") for value in center[:2])
    if abs(latitude) > 89.0 or not 0.0 < radius < 1e5:
        return None
    origin = Origin(latitude_deg=latitude, longitude_deg=longitude)
    turns = [2.0 * math.pi * k / CIRCLE_CORNERS for k in range(CIRCLE_CORNERS)]
    return [list(origin.to_geographic(radius * math.cos(t), radius * math.sin(t))) for t in turns]
