"""Can station be held before the target in the mission's current, and on which headings could it?"""

import math
from collections.abc import Iterator

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.mission.model import Target
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.docking.line import approach_speed
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.long_hover import check_long_hover
from bumpless.feasibility.reach import docking_settings, plain, top_speed
from bumpless.feasibility.station import ACCEPT, REFUSE, Station, station_keeping, surely_held
from bumpless.physics.model import build_model
from bumpless.sim.approach import turn_limit_deg

_FIELD = "target.heading_deg"
_FAULTS = 1.6  # of the speed error that counts as a fault in R: twice it does in F
OPEN_MPS = 0.01  # of current across that a plan can't know: two deviations of what foresight draws
_SIDES = (
    "north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west",
)  # fmt: skip


def check_station(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Can station be held before the target in the mission's current?"""
    if parameters.guidance.speed_min_mps > 0.0:
        return  # it passes through the observation point, which is its docking
    current, target = mission.environment.current_ned_mps, mission.target
    station = station_keeping(vehicle, parameters, current, target)
    held = station.chosen
    yield from _against(mission, vehicle, parameters, station.chosen_deg)
    if held.zone == ACCEPT:
        yield from check_long_hover(mission, vehicle, parameters)
        yield from _unforeseen(mission, vehicle, parameters)
        return
    at = f"heading {station.chosen_deg % 360.0:03.0f}° in {_flow(current)}"
    change, mends = what_would(station, target, vehicle, parameters.docking.enabled)
    if held.zone == REFUSE:
        text = f"{vehicle.id} can't hold {at}: {held.reason}."
        yield Finding(HARD, "current_not_holdable", _FIELD, text, change, mends)
    else:
        text = f"{vehicle.id} may not hold {at}: {held.reason}."
        yield Finding(SOFT, "current_hard_to_hold", _FIELD, text, change, mends)


def _against(
    mission: Mission, vehicle: Vehicle, parameters: Parameters, heading_deg: float
) -> Iterator[Finding]:
    """Is it fast enough against the current for the speed that the approach begins to brake from?"""
    docking, guidance = parameters.docking, parameters.guidance
    if not docking.enabled:
        return
    north, east, _ = mission.environment.current_ned_mps
    heading, leg = math.radians(heading_deg), mission.legs[-1].speed_mps
    head = -north * math.cos(heading) - east * math.sin(heading)
    begins = plain(approach_speed)(docking_settings(docking), parameters.supervisor.range_fr_lower_m)
    least = min(begins, guidance.reverse_speed_max_mps) - _FAULTS * docking.lag_most_mps
    if leg - head >= least:
        return
    field, speed = f"legs[{len(mission.legs) - 1}].speed_mps", math.ceil(20.0 * (least + head)) / 20.0
    good = max(leg - head, 0.0)
    text = f"Against {head:.2f} m/s it makes {good:.2f} m/s good; an approach with less than {least:.2f} is "
    text += "given up as too slow."
    if speed > top_speed(build_model(vehicle)):
        yield Finding(SOFT, "approach_too_slow", field, text, "Dock in less current.")
        return
    mend = Mend(field, speed, f"Fly the last leg at {speed:g} m/s")
    yield Finding(SOFT, "approach_too_slow", field, text, f"Fly it at {speed:g} m/s.", (mend,))


def _unforeseen(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Would a current that is hardly another than the plan's take it out of place?"""
    target, docking = mission.target, parameters.docking
    current = mission.environment.current_ned_mps
    if not docking.enabled or surely_held(vehicle, parameters, current, target, OPEN_MPS):
        return
    text = (
        f"{vehicle.id} has no sideways thrust, and by the flow over its fins it surely bears "
        f"{docking.sure_side_still_mps:g} m/s abeam on heading {target.heading_deg % 360.0:03.0f}°: "
        f"in {OPEN_MPS:g} m/s more than planned it may wave off."
    )
    ahead = (OPEN_MPS - docking.sure_side_still_mps) / docking.sure_side_share
    change, mends = f"Dock where {ahead:.2f} m/s or more come from ahead", ()
    if target.dock is None:
        change += ", or let the approach turn into the current"
        mends = (Mend("target.approach", "into_current", "Approach into the current"),)
    yield Finding(SOFT, "current_may_differ", _FIELD, text, f"{change}.", mends)


def _flow(current: tuple[float, float, float]) -> str:
    """A current in words, by where it comes from: "0.10 m/s from the west (270°)"."""
    north, east, _ = current
    from_deg = math.degrees(math.atan2(-east, -north)) % 360.0
    side = _SIDES[round(from_deg / 45.0) % 8]
    return f"{math.hypot(north, east):.2f} m/s from the {side} ({from_deg:03.0f}°)"


def what_would(
    station: Station, target: Target, vehicle: Vehicle, chooses: bool
) -> tuple[str, tuple[Mend, ...]]:
    """The headings that hold, in words and as changes. chooses: the autopilot may turn the approach."""
    nearest, given = station.nearest_deg, target.heading_deg
    if nearest is None:
        return "No heading surely holds in it: dock in less current.", ()
    mends = [Mend(_FIELD, nearest, f"Approach with {nearest:03.0f}°")]
    if chooses:
        mends.insert(0, Mend("target.approach", "into_current", "Approach into the current"))
        off = math.ceil(abs((nearest - given + 180.0) % 360.0 - 180.0))
        if off <= turn_limit_deg(target, vehicle):
            field = "target.heading_tolerance_deg"
            mends.append(Mend(field, float(off), f"Let the approach turn by {off}°"))
    return f"Can be held: {spans(station.heading_deg, station.zone == ACCEPT)}.", tuple(mends)


def spans(headings: np.ndarray, good: np.ndarray) -> str:
    """Arcs of headings, deg, in words: "070° to 110°, 300° to 010°"; good: one flag a heading, a circle."""
    if good.all():
        return "any heading"
    found = arcs(headings, good)
    return ", ".join(f"{a:03.0f}°" if a == b else f"{a:03.0f}° to {b:03.0f}°" for a, b in found)


def arcs(headings: np.ndarray, good: np.ndarray) -> list[tuple[float, float]]:
    """First and last heading of each stretch that is good, clockwise, deg; not for all of them good."""
    first = int(np.argmin(good))  # begin where it is not good, so that no arc is cut
    turned, flags = np.roll(headings, -first), np.roll(good, -first).astype(int)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags, [0]])))
    return [(float(turned[a]), float(turned[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True)]
