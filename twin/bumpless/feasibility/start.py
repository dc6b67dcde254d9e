"""Can the vehicle turn away from the dock where it starts?

It begins in F, which can't stop: it runs into what lies within its turning circle ahead. It turns to the side
that the bow points to already, as the docking automaton does (`control.docking.entry.turns_into`).
"""

import math
from collections.abc import Iterator

from bumpless.config.mission import Mission
from bumpless.config.mission.model import Target
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.dock import HULL_M, inside
from bumpless.feasibility.finding import HARD, Finding, Mend

_LAG_M = 2.5  # flown until a turn that is asked for is flown in full
_TIGHTEST = 0.8  # of the turning radius that ways are planned with
_CLIMB_M = 1.0  # by which depth may change before the dock is passed
_STEP_M = 0.1
_ROOM_M = HULL_M + 0.4  # of the hull's axis to the dock's body
_AWAY_M, _FARTHEST_M = 0.5, 20.0  # steps, and most, of a start that is offered instead

Place = tuple[float, float, float]


def check_start(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """The start against the dock: in it, or too near before it."""
    target, start = mission.target, mission.start
    field, place, heading = "start.position_ned_m", start.position_ned_m, math.radians(start.heading_deg)
    if _touches(target, vehicle, place, heading, HULL_M):
        text = "The vehicle starts in the dock."
        yield Finding(HARD, "starts_in_dock", field, text)
    elif parameters.docking.enabled and not turns_away(target, vehicle, parameters, place, heading):
        off = math.dist(place[:2], target.position_ned_m[:2])
        text = f"It starts {off:.1f} m from the target, bow to the dock, and can't turn away before it."
        there = _farther(target, vehicle, parameters, place, heading)
        mends = (Mend(field, there, "Start farther from the dock"),) if there else ()
        what = f"Start at [{there[0]:g}, {there[1]:g}, {there[2]:g}], or" if there else "Start"
        change = f"{what} with the bow away from the dock."
        yield Finding(HARD, "starts_too_near", field, text, change, mends)


def turns_away(
    target: Target, vehicle: Vehicle, parameters: Parameters, place: Place, heading: float
) -> bool:
    """Whether a hull that moves ahead at `place`, heading in rad, turns without touching the dock."""
    north, east, down = place
    bearing = math.atan2(target.position_ned_m[1] - east, target.position_ned_m[0] - north)
    bow = math.remainder(heading - bearing, math.tau)
    side, radius = 1.0 if bow >= 0.0 else -1.0, _TIGHTEST * parameters.docking.turn_radius_m
    flown = 0.0
    while abs(bow) < 0.5 * math.pi:
        if _touches(target, vehicle, (north, east, down), heading, _ROOM_M):
            return False
        north, east = north + _STEP_M * math.cos(heading), east + _STEP_M * math.sin(heading)
        heading += side * _STEP_M / radius * min(flown / _LAG_M, 1.0)
        flown += _STEP_M
        bearing = math.atan2(target.position_ned_m[1] - east, target.position_ned_m[0] - north)
        bow = math.remainder(heading - bearing, math.tau)
    return True


def _touches(target: Target, vehicle: Vehicle, place: Place, heading: float, room: float) -> bool:
    """Whether nose, middle or tail is in the dock, or within `room` of it, m."""
    north, east, down = place
    if abs(down - target.position_ned_m[2]) > 0.5 * target.dock_width_m + _CLIMB_M:
        return False
    level = (*place[:2], target.position_ned_m[2])
    if not target.turns:
        axis = [_ahead(level, heading, x) for x in (*vehicle.ends_m, 0.0)]
        return any(inside(target, point, room) for point in axis)
    to_north, to_east = target.position_ned_m[0] - north, target.position_ned_m[1] - east
    along = to_north * math.cos(heading) + to_east * math.sin(heading)
    across = to_east * math.cos(heading) - to_north * math.sin(heading)
    fore, aft = vehicle.ends_m
    gap = along - min(max(along, aft), fore)  # of the marker before the nose or behind the tail
    return math.hypot(gap, across) < target.dock_radius_m + room


def _ahead(place: Place, heading: float, by: float) -> Place:
    return place[0] + by * math.cos(heading), place[1] + by * math.sin(heading), place[2]


def _farther(
    target: Target, vehicle: Vehicle, parameters: Parameters, place: Place, heading: float
) -> Place | None:
    """The nearest start straight back from which it turns away; None where there is none in reach."""
    for k in range(1, int(_FARTHEST_M / _AWAY_M) + 1):
        north, east, down = _ahead(place, heading, -k * _AWAY_M)
        there = (round(north, 2), round(east, 2), down)
        if turns_away(target, vehicle, parameters, there, heading):
            return there
    return None
