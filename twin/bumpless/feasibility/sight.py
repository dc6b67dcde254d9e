"""From where on the legs is the target seen, and what becomes of the legs that are left?"""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.dock import ROOM_M
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.outline import near_part
from bumpless.feasibility.reach import plain
from bumpless.physics.camera import in_view, view_from
from bumpless.sim.settings import sensors_of

_STEP_M = 0.25
_DETOUR = 1.2  # of the straight way
_LEAST_M = 2.5  # before the observation point: seen later, no break-off is late enough
_LATE_M, _ENOUGH_M = 4.0, 5.0  # a late break-off works in murk more than in clear water; sure to do


def seen_from(mission: Mission, vehicle: Vehicle, leg: int) -> float | None:
    """Least distance to the observation point, m, at which the target is seen on a leg; None: never."""
    sensors: Any = sensors_of(vehicle, mission).view(np.recarray)[0]
    start, end = (np.array(x) for x in mission.path_ned_m[leg : leg + 2])
    target, point = np.array(mission.target.position_ned_m), np.array(mission.target.observation_point_ned_m)
    course, view = math.atan2(end[1] - start[1], end[0] - start[0]), np.zeros(3)
    nearest = None
    begin, finish = mission.path_ned_m[leg : leg + 2]
    part = near_part(begin, finish, mission.target.position_ned_m, _sight_m(sensors))
    if part is None:
        return None
    step = _STEP_M / max(math.dist(start, end), _STEP_M)
    for share in np.arange(max(math.floor(part[0] / step), 0) * step, min(part[1] + step, 1.0), step):
        place = start + share * (end - start)
        eta = np.array([*place, 0.0, 0.0, course])
        plain(view_from)(sensors.camera_position[0], sensors.camera_pitch[0], eta, target, view)
        if plain(in_view)(sensors, 0, view):
            far = math.dist(place[:2], point[:2])
            nearest = far if nearest is None else min(nearest, far)
    return nearest


def _sight_m(sensors: Any) -> float:
    """No farther than this is a place from the target that its main camera sees, m."""
    return float(sensors.camera_range_max[0]) + float(np.linalg.norm(sensors.camera_position[0]))


def check_sight(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Legs before the last from which the target is seen."""
    last = len(mission.legs) - 1
    for i in range(last):
        near = seen_from(mission, vehicle, i)
        if near is None or (parameters.docking.enabled and _leads_on(mission, i)):
            continue
        field = f"legs[{i}].to_ned_m"
        if parameters.docking.enabled:
            text = (
                f"The target is seen from this leg already, {near:.1f} m before the observation point; "
                f"the {last - i} legs after it are flown all the same and the approach begins on the last."
            )
            yield Finding(SOFT, "seen_early", field, text, "Leave those legs out to dock from here.")
        elif near <= parameters.supervisor.range_fr_lower_m:
            text = f"The target is seen from here, {near:.1f} m away: the {last - i} legs left are skipped."
            yield Finding(SOFT, "legs_skipped", field, text, "Keep this leg farther from the target.")


def _leads_on(mission: Mission, leg: int) -> bool:
    """Whether the legs after this one go on to the target without a detour worth a word."""
    ways = [math.dist(*pair) for pair in pairwise(mission.path_ned_m[leg + 1 :])]
    straight = math.dist(mission.path_ned_m[leg + 1], mission.target.observation_point_ned_m)
    return sum(ways) <= _DETOUR * straight


def check_first_sight(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Is the target seen early enough on the approach line, at the camera's range and in this water?"""
    if not parameters.docking.enabled:
        return
    sensors: Any = sensors_of(vehicle, mission).view(np.recarray)[0]
    reach, murk = float(sensors.camera_range_max[0]), mission.environment.beam_attenuation_per_m
    if murk > 0.0:
        reach = min(reach, float(sensors.camera_sight) / murk)
    target = mission.target
    left = reach - target.standoff_m + float(sensors.camera_position[0][0])
    if left < _LEAST_M:
        where = "no sooner than there" if left < 0.0 else f"{left:.1f} m before it"
        text = f"{target.standoff_m:g} m off, the target is seen {where}: too late to stop by it."
        yield Finding(HARD, "never_seen", "target.standoff_m", text, *_nearer(mission, vehicle, left))
    elif left < parameters.docking.break_off_m:
        text = f"The target is seen {left:.1f} m before the observation point, past the place to break off."
        field = "parameters.docking.break_off_m"
        later = round(left - 1.0, 1)
        mends = (Mend(field, later, f"Break off at {later:g} m"),)
        if left < _LATE_M:
            mends = (*_nearer(mission, vehicle, left)[1], *mends)
        yield Finding(SOFT, "seen_too_late", field, text, f"Set it to {later:g} m.", mends)


def _nearer(mission: Mission, vehicle: Vehicle, left: float) -> tuple[str, tuple[Mend, ...]]:
    """A standoff from which the target is seen early enough, in words and as a change."""
    standoff = math.floor(10.0 * (mission.target.standoff_m - _ENOUGH_M + left)) / 10.0
    if standoff < vehicle.ends_m[0] + ROOM_M:
        return "Dock in clearer water.", ()
    mend = Mend("target.standoff_m", standoff, f"Stand off {standoff:g} m")
    return f"Make it {standoff:g} m.", (mend,)
