"""What turning costs: at the start, from leg to leg, and on the way round to the approach line."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.docking.entry import choose_way
from bumpless.control.docking.gates import can_join
from bumpless.control.docking.line import place_on_line
from bumpless.feasibility.outline import near_part
from bumpless.feasibility.reach import docking_settings, plain
from bumpless.feasibility.station import station_keeping
from bumpless.sim.approach import turn_used_deg

_TURNED = 0.89  # of the radius that ways are planned with: what the hull turns with
_FAINT_MPS = 0.02  # of current: two deviations of what foresight draws turn it to any side
_EACH_DEG = 30.0  # headings that are tried
_BACK = 0.8  # of the radius that it is set off a line by a turn, for the way back on to it


def turns_time(mission: Mission, parameters: Parameters) -> float:
    """Time that turns on to the legs add to them, s: an arc by delta, and back on to the line.

    R (delta - sin delta) more than the leg, and about 0.8 R (1 - cos delta) for the offset; fitted to
    flights. None where the vehicle stops to turn.
    """
    if not parameters.docking.enabled:
        return 0.0
    radius, before, total = _TURNED * parameters.docking.turn_radius_m, mission.start.heading_deg, 0.0
    for i, leg in enumerate(mission.legs):
        course = math.degrees(_course(mission, i))
        turn = abs(math.radians((course - before + 180.0) % 360.0 - 180.0))
        total += radius * (turn - math.sin(turn) + _BACK * (1.0 - math.cos(turn))) / leg.speed_mps
        before = course
    return total


def round_time(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> float:
    """Time that the way round to the approach line adds to the last leg, s; 0 where the leg leads on to it.

    On the heading that the vehicle would take in the mission's current.
    """
    if not parameters.docking.enabled:
        return 0.0
    current = mission.environment.current_ned_mps
    chosen = station_keeping(vehicle, parameters, current, mission.target).chosen_deg
    return _round_time(mission, parameters, math.radians(chosen))


def longest_round_time(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> float:
    """The same on any heading that a current may call for which the plan, in as good as still water, can't
    know; as `round_time` where the plan has a current, or the target a heading, s."""
    known = math.hypot(*mission.environment.current_ned_mps[:2]) > _FAINT_MPS
    turn = turn_used_deg(mission.target, vehicle)
    if known or turn == 0.0 or not parameters.docking.enabled:
        return round_time(mission, vehicle, parameters)
    given = math.radians(mission.target.heading_deg)
    steps = math.ceil(turn / _EACH_DEG)
    off = [math.radians(turn * k / steps) for k in range(-steps, steps + 1)]
    return max(_round_time(mission, parameters, given + one) for one in off)


def _round_time(mission: Mission, parameters: Parameters, heading: float) -> float:
    """On an approach heading, rad: decided as in flight (`control.docking.stages.in_transit`), where the last
    leg comes near enough."""
    settings, target = docking_settings(parameters.docking), mission.target
    point = np.array(target.position_ned_m)
    point[:2] -= target.standoff_m * np.array([math.cos(heading), math.sin(heading)])
    eta, view = _decided(mission, parameters), SimpleNamespace()
    plain(place_on_line)(eta, point, heading, view)
    view.off = abs(math.remainder(eta[5] - heading, math.tau))
    if plain(can_join)(settings, parameters.supervisor.range_fr_lower_m, view):
        return 0.0
    keep = settings.keep_out + target.dock_radius_m
    docking = SimpleNamespace(heading=heading)
    marker = np.array(target.position_ned_m)
    way = plain(choose_way)(settings, keep, eta, marker, point, docking) + settings.entry_distance
    return max(way - math.dist(eta[:2], point[:2]), 0.0) / mission.legs[-1].speed_mps


def _decided(mission: Mission, parameters: Parameters) -> Any:
    """(6,) where and how the last leg is when the approach is chosen: near the target, or as it begins."""
    docking, last = parameters.docking, len(mission.legs) - 1
    start, end = (np.array(place) for place in mission.path_ned_m[-2:])
    target, course, eta = np.array(mission.target.position_ned_m), _course(mission, last), np.zeros(6)
    reach = docking.entry_distance_m + 2.0 * docking.turn_radius_m
    eta[:3], eta[5] = start, course
    if math.dist(start[:2], target[:2]) < reach:
        eta[5] = math.radians(mission.start.heading_deg) if last == 0 else _course(mission, last - 1)
    elif part := near_part(tuple(start[:2]), tuple(end[:2]), tuple(target[:2]), reach):
        eta[:3] = start + part[0] * (end - start)
    else:
        eta[:3] = end
    return eta


def _course(mission: Mission, leg: int) -> float:
    """Of a leg, rad."""
    start, end = mission.path_ned_m[leg : leg + 2]
    return math.atan2(end[1] - start[1], end[0] - start[0])
