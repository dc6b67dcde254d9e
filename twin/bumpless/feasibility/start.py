"""Can the vehicle turn away from the dock where it starts?

It begins in F, which can't stop: it runs into what lies ahead before it has turned.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.mission.model import Target
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.dock import HULL_M
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.rehearsal import FLIGHTS, Rehearsed, rehearse
from bumpless.metrics.dock import body_of, is_inside

_NEAR_M = 8.0  # farther from the dock than this no turn ends in it: the farthest that did began 4 m off
_MOST = 0.6  # of the flights in the dock, from which on it is refused
_AWAY_M, _FARTHEST_M = 1.0, 12.0  # steps, and most, of a start that is offered instead
_FIELD = "start.position_ned_m"

Place = tuple[float, float, float]


def check_start(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """The start against the dock: in it, or too near before it."""
    target, start = mission.target, mission.start
    if in_dock(target, vehicle, start.position_ned_m, math.radians(start.heading_deg)):
        yield Finding(HARD, "starts_in_dock", _FIELD, "The vehicle starts in the dock.")
        return
    off = math.dist(start.position_ned_m[:2], target.position_ned_m[:2])
    if not parameters.docking.enabled or off > _NEAR_M + target.dock_radius_m + HULL_M:
        return
    found = rehearse(mission, vehicle, parameters)
    if found.struck:
        yield _too_near(mission, vehicle, parameters, off, found)


def in_dock(target: Target, vehicle: Vehicle, place: Place, heading: float) -> bool:
    """Whether a part of a level hull at `place`, heading in rad, is in the dock where the plan has it."""
    body, eta = body_of(target), np.array([[*place, 0.0, 0.0, heading]])
    from_marker: Any = eta[:, :3] - np.array(target.position_ned_m)
    return bool(is_inside(eta, from_marker, math.radians(target.heading_deg), vehicle, body)[0])


def _too_near(
    mission: Mission, vehicle: Vehicle, parameters: Parameters, off: float, found: Rehearsed
) -> Finding:
    """Refused where it mostly ends in the dock; what may as well go well is warned of."""
    ahead = f"It starts {off:.1f} m from the target, bow to the dock, and"
    options = _elsewhere(mission, vehicle, parameters)
    words = " or ".join(mend.words[0].lower() + mend.words[1:] for mend in options)
    change = f"{words[0].upper()}{words[1:]}." if options else "Start farther from the dock."
    if found.struck < _MOST * FLIGHTS:
        text = f"{ahead} may not turn away before it: {found.struck} of {FLIGHTS} trial flights ran into it."
        return Finding(SOFT, "starts_near", _FIELD, text, change, options)
    text = f"{ahead} can't turn away before it: it is there after {found.when_s:.0f} s."
    return Finding(HARD, "starts_too_near", _FIELD, text, change, options)


def _elsewhere(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> tuple[Mend, ...]:
    """A start straight back, and the bow away from the dock: what of the two turns away for sure."""
    start, found = mission.start, []
    north, east, down = start.position_ned_m
    heading = math.radians(start.heading_deg)
    for k in range(1, int(_FARTHEST_M / _AWAY_M) + 1):
        back = k * _AWAY_M
        there = (
            round(north - back * math.cos(heading), 2),
            round(east - back * math.sin(heading), 2),
            down,
        )
        if _is_clear(replace(mission, start=replace(start, position_ned_m=there)), vehicle, parameters):
            words = f"Start at [{there[0]:g}, {there[1]:g}, {there[2]:g}]"
            found.append(Mend(_FIELD, there, words))
            break
    to_north, to_east = (a - b for a, b in zip(mission.target.position_ned_m, (north, east), strict=False))
    away = round(math.degrees(math.atan2(-to_east, -to_north)) % 360.0)
    if _is_clear(replace(mission, start=replace(start, heading_deg=float(away))), vehicle, parameters):
        found.append(Mend("start.heading_deg", float(away), f"Start with heading {away:03.0f}°"))
    return tuple(found)


def _is_clear(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> bool:
    """Whether no flight of it comes into the dock, which it doesn't start in."""
    start = mission.start
    if in_dock(mission.target, vehicle, start.position_ned_m, math.radians(start.heading_deg)):
        return False
    return rehearse(mission, vehicle, parameters).struck == 0
