"""For how long is station kept? A hull without sideways thrust holds it by keeping its bow in the current.

Fins turn the hull by the flow over them, so it needs flow enough to follow the current as it veers: the more,
the stronger the gusts. And the current must veer within the headings that the hull may take: the tolerance of
the target, and the crab angle of the approach line at rest. Outside of that it drifts off the line within
about a minute, waves off and docks again. The limits are fitted to flights of ten minutes in drawn currents.
"""

import math
from collections.abc import Iterator

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.path import time_there
from bumpless.sim.approach import turn_used_deg

BRIEF_S = 20.0  # held wherever docking is accepted
DOCKED_S = 10.0  # in place, which docked means
_LONG_S = 120.0
_STEADY_MPS = 0.05  # of current from which the bow follows one that hardly changes
_PER_GUST = 5.0  # m/s of current more for each m/s of deviation of its change
_DEVIATIONS = 2.0  # of the change, by which it veers
_SURE = 0.9  # of the crab angle
_NO_FLOW_MPS = 0.02  # with less, or this many crab angles off a fixed bow, nearly no flight held
_FAR_OFF = 2.0


def check_long_hover(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Can the vehicle stay for `end.hover_hold_s` where docking itself is accepted?"""
    if not parameters.docking.enabled:
        return
    asked = mission.end.hover_hold_s
    hold = mission.duration_s - time_there(mission, vehicle, parameters) if asked is None else asked
    if hold <= BRIEF_S:
        return
    flow, gust = _flow(mission), _gust(mission)
    needed, borne = _STEADY_MPS + _PER_GUST * gust, _SURE * math.asin(parameters.docking.crab_borne)
    off = _off_bow(mission, vehicle)
    if flow >= needed and off <= borne:
        return
    if asked is None:
        yield _to_the_end(vehicle, hold)
        return
    brief = Mend("end.hover_hold_s", BRIEF_S, f"Hold {BRIEF_S:g} s")
    again = f"may have to wave off and dock again within {hold:.0f} s."
    if flow < needed:
        why = f"keeps its bow by the flow over its fins; in less than {needed:.2f} m/s it {again}"
        change, mends = f"Ask for {BRIEF_S:g} s or less.", (brief,)
    else:
        why = f"stays with the current up to {math.degrees(borne):.0f}° off its bow, not "
        why += f"{math.degrees(off):.0f}°: it {again}"
        into = Mend("target.approach", "into_current", "Approach into the current")
        change, mends = "Let the approach turn into the current.", (into, brief)
    fixed = mission.target.turn_deg == 0.0
    hopeless = fixed and hold > _LONG_S and (flow < _NO_FLOW_MPS or off > _FAR_OFF * borne)
    severity = HARD if hopeless else SOFT
    yield Finding(severity, "long_hover", "end.hover_hold_s", f"{vehicle.id} {why}", change, mends)


def _to_the_end(vehicle: Vehicle, hold: float) -> Finding:
    """Nobody asked for a hover of that length: it only lasts until the mission's time is over."""
    field = "end.hover_hold_s"
    text = f"{vehicle.id} hovers until the mission's time is over, for about {hold:.0f} s: here it may "
    text += "have to wave off before that, and only what is docked at the end has docked."
    mend = Mend(field, DOCKED_S, f"End after {DOCKED_S:g} s of hover")
    change = f"Let the mission end once it has hovered for {DOCKED_S:g} s."
    return Finding(SOFT, "hover_to_the_end", field, text, change, (mend,))


def _flow(mission: Mission) -> float:
    north, east, _ = mission.environment.current_ned_mps
    return math.hypot(north, east)


def _gust(mission: Mission) -> float:
    change = mission.environment.current_variation
    return change.std_mps if change else 0.0


def _off_bow(mission: Mission, vehicle: Vehicle) -> float:
    """How far off the bow the current comes at times, rad, on the heading nearest to it that may be taken."""
    turn = math.radians(turn_used_deg(mission.target, vehicle))
    flow = _flow(mission)
    if flow == 0.0 or turn >= math.pi:
        return 0.0
    north, east, _ = mission.environment.current_ned_mps
    into = math.atan2(-east, -north) - math.radians(mission.target.heading_deg)
    veers = _DEVIATIONS * _gust(mission) / flow
    return max(abs(math.remainder(into, math.tau)) + veers - turn, 0.0)
