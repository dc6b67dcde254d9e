"""An outline in the plan and straight ways through it: plain geometry of the plane."""

import math
from collections.abc import Sequence
from itertools import pairwise

Point = tuple[float, float]


def inside(point: Point, corners: Sequence[Point]) -> bool:
    """Whether a point lies within an outline, by the number of edges that a ray from it meets."""
    north, east = point
    found = False
    for (n0, e0), (n1, e1) in _edges(corners):
        if (e0 > east) != (e1 > east) and north < n0 + (east - e0) / (e1 - e0) * (n1 - n0):
            found = not found
    return found


def stretches(a: Point, b: Point, corners: Sequence[Point]) -> list[tuple[float, float]]:
    """The parts of the way from a to b within an outline, as shares of the way."""
    cuts = {0.0, 1.0}
    dn, de = b[0] - a[0], b[1] - a[1]
    for (n0, e0), (n1, e1) in _edges(corners):
        en, ee = n1 - n0, e1 - e0
        cross = dn * ee - de * en
        if abs(cross) < 1e-12:
            continue
        along = ((n0 - a[0]) * ee - (e0 - a[1]) * en) / cross
        edge = ((n0 - a[0]) * de - (e0 - a[1]) * dn) / cross
        if 0.0 <= along <= 1.0 and 0.0 <= edge <= 1.0:
            cuts.add(along)
    ordered = sorted(cuts)
    found: list[tuple[float, float]] = []
    for first, last in pairwise(ordered):
        middle = 0.5 * (first + last)
        if inside((a[0] + middle * dn, a[1] + middle * de), corners):
            found.append((first, last))
    return found


def near_part(
    start: Sequence[float], end: Sequence[float], middle: Sequence[float], radius: float
) -> tuple[float, float] | None:
    """The part of a straight way within `radius` of a place, as shares of the way; None: it is never."""
    way = [b - a for a, b in zip(start, end, strict=True)]
    off = [a - m for a, m in zip(start, middle, strict=True)]
    length2, along = sum(w * w for w in way), sum(w * o for w, o in zip(way, off, strict=True))
    beyond2 = sum(o * o for o in off) - radius * radius
    if length2 == 0.0:
        return (0.0, 1.0) if beyond2 <= 0.0 else None
    root2 = along * along - length2 * beyond2
    if root2 < 0.0:
        return None
    first, last = ((-along + sign * math.sqrt(root2)) / length2 for sign in (-1.0, 1.0))
    return (max(first, 0.0), min(last, 1.0)) if last >= 0.0 and first <= 1.0 else None


def apart(a: Point, b: Point, corners: Sequence[Point]) -> bool:
    """Whether the way from a to b lies wholly on one side of the outline's box, so that they can't meet."""
    return any(
        max(a[k], b[k]) < min(c[k] for c in corners) or min(a[k], b[k]) > max(c[k] for c in corners)
        for k in (0, 1)
    )


def nearest(point: Point, corners: Sequence[Point]) -> Point:
    """The point of an outline's edge that is nearest."""
    options = [_on_edge(point, *edge) for edge in _edges(corners)]
    return min(options, key=lambda one: math.dist(one, point))


def beyond(point: Point, through: Point, by: float) -> Point:
    """The place `by` beyond `through` as seen from `point`; `through` itself where they are the same."""
    far = math.dist(point, through)
    if far < 1e-9:
        return through
    share = 1.0 + by / far
    return point[0] + share * (through[0] - point[0]), point[1] + share * (through[1] - point[1])


def middle_of(corners: Sequence[Point]) -> Point:
    """The mean of the corners."""
    return sum(n for n, _ in corners) / len(corners), sum(e for _, e in corners) / len(corners)


def _edges(corners: Sequence[Point]) -> list[tuple[Point, Point]]:
    return list(zip(corners, [*corners[1:], corners[0]], strict=True))


def _on_edge(point: Point, a: Point, b: Point) -> Point:
    dn, de = b[0] - a[0], b[1] - a[1]
    length = dn * dn + de * de
    share = 0.0 if length == 0.0 else ((point[0] - a[0]) * dn + (point[1] - a[1]) * de) / length
    share = min(max(share, 0.0), 1.0)
    return a[0] + share * dn, a[1] + share * de
