"""A mission of ours from a foreign way: what the way does not say is chosen, and each choice is told."""

import math
import re
from itertools import pairwise

from bumpless.config.capacity import MAX_WAYPOINTS
from bumpless.config.mission.origin import Origin
from bumpless.config.mission.rules import SHORTEST_LEG_M
from bumpless_server.plan.exchange.route import Item, NotImportable, Point, Route, Zone

DEPTH_M, SPEED_MPS, STANDOFF_M = 2.0, 0.7, 1.5
SLOWEST_MPS, FASTEST_MPS = 0.01, 5.0
FARTHEST_M = 1e5  # of a position from the origin
HOVER_S, LONGEST_S = 60.0, 1e5
Place = tuple[float, float, float]


def mission_text(route: Route, file_name: str, vehicle: str) -> str:
    """YAML of a mission along the way; adds to the route's items what was left out or chosen."""
    origin = _origin(route)
    places = [_place(route, origin, point) for point in route.points]
    speeds = [point.speed_mps for point in route.points]
    _tell_depths(route)
    if route.home is not None and route.geographic:
        places, speeds = [(0.0, 0.0, places[0][2]), *places], [None, *speeds]
        route.carried("start", "at the home position, at the depth of the first place")
    else:
        route.carried("start", "at the first place")
    places, speeds = _far_enough(route, places, speeds)
    if len(places) < 2:
        raise NotImportable("holds a single place: a mission leads from one to another")
    if len(places) > MAX_WAYPOINTS:
        route.left(
            f"{len(places) - MAX_WAYPOINTS} places at the end", f"a mission has {MAX_WAYPOINTS - 1} legs"
        )
        places, speeds = places[:MAX_WAYPOINTS], speeds[:MAX_WAYPOINTS]
    return _yaml(route, file_name, vehicle, origin, places, _flown(route, speeds[1:]))


def _origin(route: Route) -> Origin | None:
    if not route.geographic:
        return None
    first = route.points[0].first, route.points[0].second
    if route.home is not None and not _near(route.home, first):
        route.left("home position", f"more than {FARTHEST_M / 1e3:g} km from the first place")
        route.home = None
    if route.home is None:
        route.carried("origin", "the first place")
    latitude, longitude = route.home or first
    if abs(latitude) > 89.0:
        raise NotImportable("lies at a pole, where north and east mean nothing")
    return Origin(latitude_deg=latitude, longitude_deg=longitude)


def _near(home: tuple[float, float], first: tuple[float, float]) -> bool:
    if abs(home[0]) > 89.0:
        return False
    north, east = Origin(latitude_deg=home[0], longitude_deg=home[1]).to_local(*first)
    return math.hypot(north, east) < FARTHEST_M


def _place(route: Route, origin: Origin | None, point: Point) -> Place:
    north, east = origin.to_local(point.first, point.second) if origin else (point.first, point.second)
    if max(abs(north), abs(east)) > FARTHEST_M:
        raise NotImportable(f"leads {math.hypot(north, east) / 1e3:.0f} km away, farther than a mission can")
    depth = DEPTH_M if point.depth_m is None else min(point.depth_m, 11000.0)
    return round(north, 2), round(east, 2), round(depth, 2)


def _tell_depths(route: Route) -> None:
    unknown = sum(point.depth_m is None for point in route.points)
    if unknown:
        route.items.append(Item("depth", False, f"{_count(unknown, 'place')} none: {DEPTH_M:g} m was put in"))


def _far_enough(
    route: Route, places: list[Place], speeds: list[float | None]
) -> tuple[list[Place], list[float | None]]:
    """Without places that lie on the one before."""
    kept, at = [places[0]], [speeds[0]]
    for place, speed in zip(places[1:], speeds[1:], strict=True):
        if math.dist(place, kept[-1]) < SHORTEST_LEG_M:
            continue
        kept.append(place)
        at.append(speed)
    if len(kept) < len(places):
        count = len(places) - len(kept)
        route.left(f"{count} places", f"nearer than {SHORTEST_LEG_M:g} m to the one before")
    return kept, at


def _flown(route: Route, speeds: list[float | None]) -> list[float]:
    unknown = sum(speed is None for speed in speeds)
    if unknown:
        route.items.append(
            Item("speed", False, f"{_count(unknown, 'leg')} none: {SPEED_MPS:g} m/s was put in")
        )
    found = [SPEED_MPS if speed is None else speed for speed in speeds]
    fit = [min(max(speed, SLOWEST_MPS), FASTEST_MPS) for speed in found]
    if fit != found:
        route.items.append(Item("speed", False, f"kept within {SLOWEST_MPS:g} and {FASTEST_MPS:g} m/s"))
    return fit


def _yaml(
    route: Route,
    file_name: str,
    vehicle: str,
    origin: Origin | None,
    places: list[Place],
    speeds: list[float],
) -> str:
    heading, first = _heading(places[-2], places[-1]), _heading(places[0], places[1])
    ahead = [STANDOFF_M * f(math.radians(heading)) for f in (math.cos, math.sin)]
    target = (places[-1][0] + ahead[0], places[-1][1] + ahead[1], places[-1][2])
    times = [math.dist(a, b) / v for (a, b), v in zip(pairwise(places), speeds, strict=True)]
    duration = min(10.0 * math.ceil((1.2 * sum(times) + HOVER_S) / 10.0), LONGEST_S)
    route.items.append(
        Item("target", False, f"put {STANDOFF_M:g} m beyond the last place, on the last leg's heading")
    )
    lines = [
        "version: 1",
        f"name: {_name(file_name)}",
        f"title: {_quoted(route.title or file_name)}",
        f"summary: {_quoted(f'Imported from {route.kind}.')}",
        f"vehicle: {vehicle}",
        f"duration_s: {duration:g}",
        "",
        "start:",
        f"  position_ned_m: {_row(places[0])}",
        f"  heading_deg: {first:g}",
        f"  speed_mps: {speeds[0]:g}",
        "",
        "legs:",
        *(f"  - {{to_ned_m: {_row(p)}, speed_mps: {v:g}}}" for p, v in zip(places[1:], speeds, strict=True)),
        "",
        "target:",
        f"  position_ned_m: {_row(target)}",
        f"  heading_deg: {heading:g}",
        f"  standoff_m: {STANDOFF_M:g}",
    ]
    lines += _zones(route, origin)
    if origin is not None:
        lines += [
            "",
            "origin:",
            f"  latitude_deg: {origin.latitude_deg:.8f}",
            f"  longitude_deg: {origin.longitude_deg:.8f}",
        ]
    return "\n".join(lines) + "\n"


def _zones(route: Route, origin: Origin | None) -> list[str]:
    """The YAML of what to keep out of and inside."""
    outside = [zone for zone in route.zones if not zone.inside]
    boundary = next((zone for zone in route.zones if zone.inside), None)
    lines = ["", "keep_out:"] if outside else []
    for zone in outside:
        lines += ["  - corners:", *_corners(zone, origin, 6)]
    if boundary is not None:
        lines += ["", "keep_in:", "  corners:", *_corners(boundary, origin, 4)]
    return lines


def _corners(zone: Zone, origin: Origin | None, indent: int) -> list[str]:
    places = [origin.to_local(*corner) if origin else corner for corner in zone.corners]
    if any(abs(value) > FARTHEST_M for place in places for value in place):
        raise NotImportable("has a fence farther away than a mission can lead")
    return [f"{' ' * indent}- {{north_m: {n:.2f}, east_m: {e:.2f}}}" for n, e in places]


def _count(count: int, what: str) -> str:
    return f"{count} {what} has" if count == 1 else f"{count} {what}s have"


def _heading(a: Place, b: Place) -> float:
    """From north over east, deg, 0 to 360; 0 where only the depth changes."""
    return round(math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])) % 360.0, 1) % 360.0


def _row(place: tuple[float, ...]) -> str:
    return (
        "["
        + ", ".join(f"{round(value, 2) + 0.0:g}" if abs(value) < 1e4 else f"{value:.2f}" for value in place)
        + "]"
    )


def _name(file_name: str) -> str:
    """A mission's short name of a file's name."""
    stem = re.sub(r"\.[A-Za-z0-9]{1,8}$", "", file_name.rpartition("/")[2])
    found = re.sub(r"[^A-Za-z0-9_-]+", "_", stem).strip("_-")[:64]
    return found or "imported"


def _quoted(text: str) -> str:
    """A YAML string in double quotes, on one line."""
    plain = "".join(c if c.isprintable() else " " for c in text)[:120]
    return '"' + plain.replace("\\", "\\\\").replace('"', '\\"') + '"'
