"""Missions drawn on both sides of each rule of the check, one family a rule or a few that are neighbours.

Each is the planner's walk with one thing drawn from well below the rule's limit to well above it. The vehicle
may turn into the current, so that nothing but that thing is in question.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.mission.model import Leg, Start
from bumpless.config.mission.sea import Environment
from bumpless_paper.study.docks.plans import FIRST, SPEEDS_MPS

Draw = Callable[[np.random.Generator, Mission], Mission]


@dataclass(frozen=True)
class Family:
    """Missions about some codes of findings."""

    codes: tuple[str, ...]
    draw: Draw

    def mission(self, name: str, number: int) -> Mission:
        """Mission `number`, always the same."""
        r = np.random.Generator(np.random.PCG64([95, number, *name.encode()]))
        return replace(self.draw(r, _walk()), name=f"{name}{number}", seed=number % 2**31)


@cache
def _walk() -> Mission:
    walk = parse_mission(FIRST, "first.yaml")
    return replace(walk, duration_s=500.0, target=replace(walk.target, heading_tolerance_deg=180.0))


def _with_legs(mission: Mission, *ends: tuple[float, float, float], speed: float = 0.7) -> Mission:
    return replace(mission, legs=tuple(Leg(end, speed) for end in ends))


def _to(mission: Mission, target: Any) -> Mission:
    """With another target, and the last leg to its observation point."""
    last = Leg(target.observation_point_ned_m, mission.legs[-1].speed_mps)
    return replace(mission, target=target, legs=(*mission.legs[:-1], last))


def _current(speed: float, toward_deg: float) -> Environment:
    toward = math.radians(toward_deg)
    return Environment((speed * math.cos(toward), speed * math.sin(toward), 0.0))


def _start(r: np.random.Generator, m: Mission) -> Mission:
    """From in the dock to 6 m off, on any side of it, mostly with the bow to it."""
    bearing, off = r.uniform(0.0, 2.0 * math.pi), r.uniform(1.0, 6.0)
    bow = math.degrees(bearing) + (r.uniform(-75.0, 75.0) if r.random() < 0.7 else r.uniform(-180.0, 180.0))
    free = (0.0, 30.0, 180.0)[int(r.integers(3))]
    size = {
        "dock_width_m": float(r.choice((0.6, 1.0, 2.0))),
        "dock_length_m": float(r.choice((0.6, 1.0, 2.0, 3.0))),
    }
    target = replace(m.target, heading_tolerance_deg=free, **size)
    n, e, d = target.position_ned_m
    place = (
        n - off * math.cos(bearing),
        e - off * math.sin(bearing),
        d + float(r.choice((0.0, 0.0, -1.0, 1.0))),
    )
    start = Start(place, bow % 360.0, float(r.choice(SPEEDS_MPS)))
    sea = _current(0.07, r.uniform(0.0, 360.0) if free == 180.0 else 180.0)
    return replace(_with_legs(m, target.observation_point_ned_m), start=start, target=target, environment=sea)


def _fast(r: np.random.Generator, m: Mission) -> Mission:
    speed = float(r.uniform(0.6, 1.0))
    return replace(m, legs=tuple(replace(leg, speed_mps=speed) for leg in m.legs))


def _abeam(r: np.random.Generator, m: Mission) -> Mission:
    """A leg across a current, and slow for it."""
    out = _with_legs(m, (0.0, 25.0, 2.0), m.legs[-1].to_ned_m, speed=float(r.uniform(0.3, 0.7)))
    return replace(out, environment=_current(r.uniform(0.05, 0.4), r.choice((0.0, 180.0))), duration_s=900.0)


def _against(r: np.random.Generator, m: Mission) -> Mission:
    return replace(m, environment=_current(r.uniform(0.2, 0.6), 180.0), duration_s=900.0)


def _steep(r: np.random.Generator, m: Mission) -> Mission:
    far, deep = r.uniform(12.0, 30.0), r.uniform(3.0, 12.0)
    target = replace(m.target, position_ned_m=(far + 40.0, 0.0, deep))
    return _to(_with_legs(m, (far, 0.0, deep), (0.0, 0.0, 0.0)), target)


def _short(r: np.random.Generator, m: Mission) -> Mission:
    """Less and more time than it takes, with a turn at the start; half of them free to turn."""
    start = replace(m.start, heading_deg=float(r.choice((0.0, 60.0, 120.0, 180.0))))
    out = replace(m, start=start, duration_s=float(r.uniform(40.0, 260.0)))
    if r.random() < 0.5:
        return out
    fixed = replace(m.target, heading_tolerance_deg=0.0)
    return replace(out, target=fixed, environment=_current(0.07, 180.0))


def _brief(r: np.random.Generator, m: Mission) -> Mission:
    return replace(m, end=replace(m.end, hover_hold_s=float(r.uniform(2.0, 18.0))))


def _off_path(r: np.random.Generator, m: Mission) -> Mission:
    off, way = r.uniform(0.0, 14.0), r.uniform(0.0, 2.0 * math.pi)
    n, e, d = m.target.observation_point_ned_m
    end = (n - abs(off * math.cos(way)), e + off * math.sin(way), d)
    return replace(m, legs=(*m.legs[:-2], Leg(end, 0.7)))


def _deep(r: np.random.Generator, m: Mission) -> Mission:
    n, e, d = m.target.position_ned_m
    return replace(m, target=replace(m.target, position_ned_m=(n, e, d + float(r.uniform(0.0, 6.0)))))


def _nose(r: np.random.Generator, m: Mission) -> Mission:
    return _to(m, replace(m.target, standoff_m=float(r.uniform(0.7, 1.6))))


def _wide(r: np.random.Generator, m: Mission) -> Mission:
    size = float(r.uniform(2.0, 24.0))
    start = replace(m.start, position_ned_m=(-40.0, 0.0, 2.0))
    target = replace(m.target, dock_width_m=size, dock_length_m=size)
    return replace(_with_legs(m, target.observation_point_ned_m), start=start, target=target)


def _corner(r: np.random.Generator, m: Mission) -> Mission:
    """A corner 1 to 10 m from the dock."""
    off, way = r.uniform(1.0, 10.0), r.uniform(0.0, 2.0 * math.pi)
    n, e, d = m.target.position_ned_m
    corner = (n + off * math.cos(way), e + off * math.sin(way), d)
    return _with_legs(m, (n - 20.0, 15.0, d), corner, (n - 20.0, -15.0, d), m.legs[-1].to_ned_m)


def _sight(r: np.random.Generator, m: Mission) -> Mission:
    """From a standoff, in murky water."""
    out = _to(m, replace(m.target, standoff_m=float(r.uniform(1.5, 12.0))))
    murk = float(r.uniform(0.0, 2.5)) if r.random() < 0.5 else 0.0
    start = replace(m.start, position_ned_m=(-15.0, 0.0, 2.0))
    return replace(
        _with_legs(out, out.legs[-1].to_ned_m),
        start=start,
        environment=Environment(beam_attenuation_per_m=murk),
    )


def _station(r: np.random.Generator, m: Mission) -> Mission:
    """A current of up to 0.12 m/s from any side, on a fixed heading."""
    target = replace(m.target, heading_tolerance_deg=0.0)
    return replace(m, target=target, environment=_current(r.uniform(0.0, 0.12), r.uniform(90.0, 270.0)))


def _long(r: np.random.Generator, m: Mission) -> Mission:
    hold = float(r.uniform(15.0, 300.0))
    sea = _current(r.uniform(0.0, 0.1), r.uniform(0.0, 360.0))
    return replace(m, environment=sea, duration_s=800.0, end=replace(m.end, hover_hold_s=hold))


def _endless(r: np.random.Generator, m: Mission) -> Mission:
    sea = _current(r.uniform(0.0, 0.1), r.uniform(0.0, 360.0))
    return replace(
        m, environment=sea, duration_s=float(r.uniform(120.0, 500.0)), end=replace(m.end, hover_hold_s=None)
    )


FAMILIES: dict[str, Family] = {
    "start": Family(("starts_in_dock", "starts_too_near", "starts_near"), _start),
    "fast": Family(("leg_too_fast",), _fast),
    "abeam": Family(("leg_not_flyable", "leg_drifted_off"), _abeam),
    "against": Family(("approach_too_slow", "current_not_holdable"), _against),
    "steep": Family(("leg_too_steep",), _steep),
    "short": Family(("too_far", "short_of_time"), _short),
    "brief": Family(("hold_too_short",), _brief),
    "off_path": Family(("target_not_on_path",), _off_path),
    "deep": Family(("target_depth",), _deep),
    "nose": Family(("standoff_too_short",), _nose),
    "wide": Family(("line_in_keep_out",), _wide),
    "corner": Family(("leg_near_dock", "seen_early"), _corner),
    "sight": Family(("never_seen", "seen_too_late"), _sight),
    "station": Family(("current_not_holdable", "current_hard_to_hold", "current_may_differ"), _station),
    "long": Family(("long_hover",), _long),
    "endless": Family(("hover_to_the_end",), _endless),
}
