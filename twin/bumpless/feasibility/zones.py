"""Do the legs keep out of where they must not lead, and inside what they must not leave?"""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

from bumpless.config.mission import Mission
from bumpless.config.mission.zones import Corner, KeepOut
from bumpless.feasibility.finding import HARD, Finding, Mend
from bumpless.feasibility.outline import Point, apart, beyond, inside, middle_of, nearest, stretches

_CLEAR_M = 2.0  # of a zone, for a place that is offered instead
Place = tuple[float, float, float]


def check_zones(mission: Mission) -> Iterator[Finding]:
    """Every leg against every keep-out zone and the keep-in boundary."""
    boxes = [_box(_plan(zone.corners)) for zone in mission.keep_out]
    for i, (start, end) in enumerate(pairwise(mission.path_ned_m)):
        for k, zone in enumerate(mission.keep_out):
            if apart(start[:2], end[:2], boxes[k]):
                continue
            crossed = _crossed(start, end, zone)
            if crossed > 0.0:
                yield _through(mission, i, k, crossed)
    yield from _left(mission)


def _crossed(start: Place, end: Place, zone: KeepOut) -> float:
    """Length of a leg's part inside a zone, m."""
    length, total = math.dist(start, end), 0.0
    for first, last in stretches(start[:2], end[:2], _plan(zone.corners)):
        depths = [start[2] + share * (end[2] - start[2]) for share in (first, last)]
        if min(depths) <= zone.to_depth_m and max(depths) >= zone.from_depth_m:
            total += (last - first) * length
    return total


def _through(mission: Mission, leg: int, zone: int, crossed: float) -> Finding:
    keep_out = mission.keep_out[zone]
    name = keep_out.name or f"keep-out zone {zone + 1}"
    text = f"It leads {crossed:.1f} m through {name}."
    best = _way_round(mission, leg, keep_out)
    field = f"legs[{leg}].to_ned_m"
    if best is None:
        return Finding(HARD, "keep_out_crossed", field, text, "Lead it round with another leg.")
    at, place = best
    words = f"End leg {at + 1} at [{place[0]:g}, {place[1]:g}]"
    mend = Mend(f"legs[{at}].to_ned_m", place, words)
    return Finding(HARD, "keep_out_crossed", field, text, f"{words}.", (mend,))


def _way_round(mission: Mission, leg: int, zone: KeepOut) -> tuple[int, Place] | None:
    """(leg, its new end): the smallest move of this leg's end, or of the one before, that clears all."""
    corners, last = _plan(zone.corners), len(mission.legs) - 1
    middle = middle_of(corners)
    options: list[tuple[float, int, Place]] = []
    for at in (leg, leg - 1):
        if not 0 <= at <= last or at == last:  # the last one's end belongs to the target
            continue
        now = mission.legs[at].to_ned_m
        places = [beyond(middle, corner, _CLEAR_M) for corner in corners]
        places.append(beyond(now[:2], nearest(now[:2], corners), _CLEAR_M))
        for north, east in places:
            place = (round(north, 1), round(east, 1), now[2])
            if _is_clear(mission, at, place):
                options.append((math.dist(now, place), at, place))
    return min(options)[1:] if options else None


def _is_clear(mission: Mission, at: int, place: Place) -> bool:
    """Whether the two legs at a moved end keep to all zones."""
    legs = list(mission.legs)
    legs[at] = replace(legs[at], to_ned_m=place)
    points = [mission.start.position_ned_m, *(leg.to_ned_m for leg in legs)]
    pairs = list(pairwise(points))[at : at + 2]
    free = all(_crossed(a, b, zone) == 0.0 for a, b in pairs for zone in mission.keep_out)
    boundary = _plan(mission.keep_in.corners) if mission.keep_in else None
    return (
        free and (boundary is None or inside(place[:2], boundary)) and all(math.dist(*p) > 1.0 for p in pairs)
    )


def _left(mission: Mission) -> Iterator[Finding]:
    if mission.keep_in is None:
        return
    boundary = _plan(mission.keep_in.corners)
    start = mission.start.position_ned_m
    if not inside(start[:2], boundary):
        text = "The start lies outside the keep-in boundary."
        yield Finding(
            HARD,
            "keep_in_left",
            "start.position_ned_m",
            text,
            "",
            _back(start, boundary, "start.position_ned_m"),
        )
    for i, (a, b) in enumerate(pairwise(mission.path_ned_m)):
        within = sum(last - first for first, last in stretches(a[:2], b[:2], boundary))
        outside = (1.0 - within) * math.dist(a[:2], b[:2])
        if outside <= 0.01:
            continue
        field = f"legs[{i}].to_ned_m"
        mends = () if inside(b[:2], boundary) else _back(b, boundary, field)
        change = f"{mends[0].words}." if mends else "Lead it within the boundary with another leg."
        text = f"It leads {outside:.1f} m outside the keep-in boundary."
        yield Finding(HARD, "keep_in_left", field, text, change, mends)


def _back(place: Place, boundary: list[Point], field: str) -> tuple[Mend, ...]:
    """The nearest place inside the boundary, a little way in."""
    north, east = beyond(place[:2], nearest(place[:2], boundary), _CLEAR_M)
    if not inside((north, east), boundary):
        return ()
    moved = (round(north, 1), round(east, 1), place[2])
    return (Mend(field, moved, f"Move it inside, to [{moved[0]:g}, {moved[1]:g}]"),)


def _box(outline: list[Point]) -> list[Point]:
    """Two opposite corners of the box around an outline."""
    return [(f(n for n, _ in outline), f(e for _, e in outline)) for f in (min, max)]


def _plan(corners: tuple[Corner, ...]) -> list[Point]:
    return [(corner.north_m, corner.east_m) for corner in corners]
