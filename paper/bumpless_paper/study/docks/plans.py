"""Missions that are asked whether they dock: the shipped examples, a newcomer's first one, and odd plans."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np

from bumpless.config.mission import Mission, missions_folder, parse_mission
from bumpless.config.mission.model import Leg
from bumpless.config.mission.sea import Environment

DOCKS, NOT_MEANT, SELDOM = "docks", "does not dock", "seldom docks"  # promises; the latter two are in titles
FIRST = """
version: 1
name: first
vehicle: ts100
duration_s: 300
seed: 1
start: {position_ned_m: [0, 0, 2], heading_deg: 0, speed_mps: 0.7}
legs:
  - {to_ned_m: [8, 0, 2], speed_mps: 0.7}
  - {to_ned_m: [16, 0, 2], speed_mps: 0.7}
  - {to_ned_m: [24, 0, 2], speed_mps: 0.7}
  - {to_ned_m: [34.5, 0, 2], speed_mps: 0.7}
target: {position_ned_m: [36, 0, 2], heading_deg: 0, standoff_m: 1.5}
end: {hover_hold_s: 10}
"""  # the planner's template, as the walk in tests/console/test_planner_walk.py draws it
SPEEDS_MPS = (0.0, 0.4, 0.7)
NEAR_M, FAR_M = 2.0, 25.0  # of corners from the dock of an odd plan


@dataclass(frozen=True)
class Plans:
    """Missions by number, asked the same question."""

    name: str
    promise: str
    mission: Callable[[int], Mission]


def examples() -> Iterator[Plans]:
    """Every shipped mission with what its title promises."""
    for file in sorted(missions_folder().glob("*.yaml")):
        mission = parse_mission(file.read_text(encoding="utf-8"), file.name)
        promise = next((word for word in (NOT_MEANT, SELDOM) if word in mission.title), DOCKS)
        yield Plans(file.stem, promise, partial(_always, mission))


def groups() -> dict[str, Plans]:
    """All of them by name."""
    walk = parse_mission(FIRST, "first.yaml")
    others = (
        Plans("newcomer, as the planner's walk draws it", DOCKS, partial(_always, walk)),
        Plans("newcomer, the same for a hover of 20 s", DOCKS, partial(_always, _holding(walk, 20.0))),
        Plans("newcomer, drawn waypoints", DOCKS, newcomer),
        Plans("odd corners near the dock", DOCKS, odd),
    )
    return {plans.name: plans for plans in (*examples(), *others)}


def newcomer(number: int) -> Mission:
    """One to three clicks ahead, turning by up to 45° at each, and the dock along the last of them."""
    r = np.random.Generator(np.random.PCG64([93, number]))
    course, place, legs = 0.0, np.array([0.0, 0.0, 2.0]), []
    for _ in range(int(r.integers(1, 4))):
        place, course = place + _way(r.uniform(6.0, 15.0), course), course + r.uniform(-45.0, 45.0)
        legs.append(Leg(_place(place), 0.7))
    marker = place + _way(r.uniform(8.0, 15.0), course)
    walk = _first()
    target = replace(walk.target, position_ned_m=_place(marker), heading_deg=course % 360.0)
    legs.append(Leg(target.observation_point_ned_m, 0.7))
    return replace(walk, name=f"newcomer{number}", legs=tuple(legs), target=target)


def odd(number: int) -> Mission:
    """One to three corners anywhere 2 to 25 m from the dock, a start and a bow that point anywhere.

    Odd ones keep their heading in still water, the others turn into a current from any side.
    """
    r = np.random.Generator(np.random.PCG64([94, number]))
    walk, into = _first(), number % 2 == 0
    marker = np.array([40.0, 0.0, 2.3])
    begin = _about(r, marker, 16.0, 30.0)
    target = replace(walk.target, position_ned_m=_place(marker), heading_tolerance_deg=180.0 if into else 0.0)
    corners = [_about(r, marker, NEAR_M, FAR_M) for _ in range(int(r.integers(1, 4)))]
    ends = (*corners, target.observation_point_ned_m)
    heading, speed = float(r.uniform(0.0, 360.0)), float(r.choice(SPEEDS_MPS))
    flow = (float(r.uniform(-0.08, 0.08)), float(r.uniform(-0.08, 0.08)), 0.0)
    start = replace(walk.start, position_ned_m=begin, heading_deg=heading, speed_mps=speed)
    return replace(
        walk, name=f"odd{number}", duration_s=500.0, start=start, legs=tuple(Leg(end, 0.7) for end in ends),
        target=target, environment=Environment(flow) if into else Environment(),
    )  # fmt: skip


def _always(mission: Mission, _: int) -> Mission:
    return mission


@cache
def _first() -> Mission:
    return parse_mission(FIRST, "first.yaml")


def _holding(mission: Mission, hold_s: float) -> Mission:
    return replace(mission, end=replace(mission.end, hover_hold_s=hold_s))


def _way(far: float, course_deg: float) -> np.ndarray:
    course = math.radians(course_deg)
    return far * np.array([math.cos(course), math.sin(course), 0.0])


def _about(
    r: np.random.Generator, middle: np.ndarray, least: float, most: float
) -> tuple[float, float, float]:
    off = _way(r.uniform(least, most), r.uniform(0.0, 360.0))
    return _place(np.array([*(middle + off)[:2], r.uniform(1.5, 3.5)]))


def _place(x: np.ndarray) -> tuple[float, float, float]:
    return float(x[0]), float(x[1]), float(x[2])
