"""Can the legs be flown: their speed, their depth, their time, and do they lead to the target?"""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.docking.line import approach_speed
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.reach import docking_settings, plain, top_speed
from bumpless.feasibility.turns import longest_round_time, round_time, turns_time
from bumpless.metrics.outcome import DOCKED
from bumpless.physics.model import build_model

_CRAB_SURE = 0.45  # sine of the crab angle up to which a leg is followed without an offset
_CRAB_MOST = 0.75  # and with which hardly any way is made good along it
_LAGS = 3.0  # two count as a fault in F; a vehicle a little stronger than its file stays within
_ASIDE_M = 6.0  # from the last leg's end to the observation point: an approach can make up for no more
_DEEPER_M = 1.0


def check_legs(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Speed, ground speed and depth of each leg."""
    fastest = top_speed(build_model(vehicle))
    points = mission.path_ned_m
    for i, (leg, (start, end)) in enumerate(zip(mission.legs, pairwise(points), strict=True)):
        field = f"legs[{i}].speed_mps"
        if leg.speed_mps > fastest:
            text = f"{leg.speed_mps:g} m/s is faster than {vehicle.id} can be: {fastest:.2f} m/s."
            slower = math.floor(10.0 * fastest) / 10.0
            mend = Mend(field, slower, f"Fly it at {slower:g} m/s")
            kind = SOFT if leg.speed_mps <= fastest + _borne_lag(parameters) else HARD
            yield Finding(kind, "leg_too_fast", field, text, f"Fly it at {slower:g} m/s or slower.", (mend,))
            continue
        if leg_speed(mission, i) <= 0.02:
            text = "The current sets it off the leg faster than it can make good."
            yield Finding(HARD, "leg_not_flyable", field, text, "Fly it faster, or along another way.")
            continue
        if abs(_crab(mission, i)) > _CRAB_SURE:
            text = "The current comes so much from abeam that it may fly beside the leg by some metres."
            yield Finding(SOFT, "leg_drifted_off", field, text, "Fly it faster, or along another way.")
        yield from _depth(mission, i, start, end, parameters)


def _borne_lag(parameters: Parameters) -> float:
    """By how much a vehicle may stay behind the speed of its leg, m/s, and not surely give up in F."""
    return _LAGS * parameters.docking.lag_most_mps if parameters.docking.enabled else 0.0


def leg_speed(mission: Mission, i: int) -> float:
    """Speed over ground that leg i is flown with in the mission's current, m/s; 0 where it can't be."""
    sine, (along, _) = _crab(mission, i), _split(mission, i)
    if abs(sine) > _CRAB_MOST:
        return 0.0
    return max(mission.legs[i].speed_mps * math.sqrt(1.0 - sine * sine) + along, 0.0)


def _crab(mission: Mission, i: int) -> float:
    """Sine of the angle into the current that keeps leg i; beyond 1: there is none."""
    return _split(mission, i)[1] / mission.legs[i].speed_mps


def _split(mission: Mission, i: int) -> tuple[float, float]:
    """The current along leg i and across it, m/s."""
    start, end = mission.path_ned_m[i : i + 2]
    course = math.atan2(end[1] - start[1], end[0] - start[0])
    north, east, _ = mission.environment.current_ned_mps
    c, s = math.cos(course), math.sin(course)
    return north * c + east * s, -north * s + east * c


def leg_time(mission: Mission, i: int) -> float:
    """Time that leg i takes, s; infinite where it can't be flown."""
    start, end = mission.path_ned_m[i : i + 2]
    speed = leg_speed(mission, i)
    return math.dist(start, end) / speed if speed > 0.0 else math.inf


def _depth(
    mission: Mission,
    i: int,
    start: tuple[float, float, float],
    end: tuple[float, float, float],
    parameters: Parameters,
) -> Iterator[Finding]:
    guidance, docking = parameters.guidance, parameters.docking
    rate = docking.depth_rate_pitch_mps if docking.enabled else guidance.depth_rate_mps
    if guidance.pitch_look_ahead_m > 0.0:
        rate = max(rate, mission.legs[i].speed_mps * math.sin(math.radians(guidance.pitch_max_deg)))
        rate = docking.depth_rate_pitch_mps if docking.enabled else rate
    time, change = leg_time(mission, i), abs(end[2] - start[2])
    if change - rate * time > 0.3:
        text = f"{change:.1f} m of depth in {time:.0f} s is more than the {rate:g} m/s its depth can follow."
        least = change / rate * leg_speed(mission, i)
        what = f"Make the leg {least:.0f} m long, or fly it slower."
        yield Finding(SOFT, "leg_too_steep", f"legs[{i}].to_ned_m", text, what)


def approach_time(parameters: Parameters, mission: Mission) -> float:
    """Time from the last leg's speed to rest at the observation point, s, less what the leg itself takes."""
    speed = mission.legs[-1].speed_mps
    if parameters.guidance.speed_min_mps > 0.0:
        return 0.0
    if parameters.docking.enabled:
        settings = docking_settings(parameters.docking)
        left = np.arange(0.05, 60.0, 0.05)
        speeds = np.array([plain(approach_speed)(settings, float(x)) for x in left])
        tried = left <= parameters.docking.try_brake_m
        speeds[tried] = np.minimum(speeds[tried], parameters.docking.try_brake_mps)
    else:
        guide = parameters.guidance
        left = np.arange(0.05, parameters.supervisor.range_fr_lower_m, 0.05)
        speeds = guide.reverse_speed_slope_per_s * left + guide.reverse_speed_offset_mps
        speeds = np.minimum(speeds, guide.reverse_speed_max_mps)
    slow = speeds < speed
    return float(np.sum(0.05 / speeds[slow]) - np.sum(slow) * 0.05 / speed)


def time_there(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> float:
    """Time until it hovers before the target, s, if the first approach succeeds; infinite: never."""
    way = sum(leg_time(mission, i) for i in range(len(mission.legs)))
    end, point = mission.legs[-1].to_ned_m, mission.target.observation_point_ned_m
    heading = math.radians(mission.target.heading_deg)
    short = (point[0] - end[0]) * math.cos(heading) + (point[1] - end[1]) * math.sin(heading)
    way += max(short, 0.0) / mission.legs[-1].speed_mps
    turns, around = turns_time(mission, parameters), round_time(mission, vehicle, parameters)
    return way + turns + around + approach_time(parameters, mission)


def check_time(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Is the way flown within the duration, with the approach and the hold?"""
    way = sum(leg_time(mission, i) for i in range(len(mission.legs)))
    hold = mission.end.hover_hold_s or DOCKED.hold_s
    total, most = time_there(mission, vehicle, parameters) + hold, mission.duration_s
    if not math.isfinite(way):
        return
    allow = math.ceil(total / 10.0) * 10.0
    needed, mends = f"Allow {allow:.0f} s.", (Mend("duration_s", allow, f"Allow {allow:.0f} s"),)
    if way > most:
        text = f"The legs alone take {way:.0f} s, the mission ends after {most:g} s."
        yield Finding(HARD, "too_far", "duration_s", text, needed, mends)
    elif total > most:
        text = f"Legs, approach and {hold:g} s of hover take about {total:.0f} s of {most:g} s."
        yield Finding(SOFT, "short_of_time", "duration_s", text, needed, mends)
    else:
        around = (f(mission, vehicle, parameters) for f in (longest_round_time, round_time))
        yield from _any_side(mission, total + next(around) - next(around))


def _any_side(mission: Mission, longest: float) -> Iterator[Finding]:
    """In still water a target that leaves the heading open may have to be approached from any side."""
    if longest <= mission.duration_s:
        return
    allow = math.ceil(longest / 10.0) * 10.0
    text = (
        "In hardly any current the vehicle may turn to any heading that the target allows: with the way "
        f"round it may take {longest:.0f} s of {mission.duration_s:g} s."
    )
    mend = Mend("duration_s", allow, f"Allow {allow:.0f} s")
    yield Finding(SOFT, "short_of_time", "duration_s", text, f"Allow {allow:.0f} s.", (mend,))


def check_hold(mission: Mission, parameters: Parameters) -> Iterator[Finding]:
    """Does the mission last until it has docked?"""
    hold, docked = mission.end.hover_hold_s, DOCKED.hold_s
    if hold is None or hold >= docked or mission.target.dock or parameters.guidance.speed_min_mps > 0.0:
        return
    field = "end.hover_hold_s"
    text = f"It ends after {hold:g} s of hover: docked means {docked:g} s in place, so it can only be held."
    mend = Mend(field, docked, f"End after {docked:g} s of hover")
    yield Finding(SOFT, "hold_too_short", field, text, f"Hold {docked:g} s or longer.", (mend,))


def check_end(mission: Mission) -> Iterator[Finding]:
    """Does the last leg lead to the target?"""
    end, point = mission.legs[-1].to_ned_m, mission.target.observation_point_ned_m
    aside, deeper = math.dist(end[:2], point[:2]), point[2] - end[2]
    field = f"legs[{len(mission.legs) - 1}].to_ned_m"
    if aside > _ASIDE_M:
        text = f"The last leg ends {aside:.1f} m from the observation point."
        place = tuple(round(x, 1) for x in point)
        what = f"End it at [{place[0]:g}, {place[1]:g}, {place[2]:g}]."
        mend = Mend(field, place, "End the last leg at the observation point")
        yield Finding(SOFT, "target_not_on_path", field, text, what, (mend,))
    if abs(deeper) > _DEEPER_M:
        side = "below" if deeper > 0.0 else "above"
        text = f"The target lies {abs(deeper):.1f} m {side} the end of the last leg: is its depth mistyped?"
        north, east, _ = mission.target.position_ned_m
        mends = (
            Mend("target.position_ned_m", (north, east, end[2]), f"Target at {end[2]:g} m"),
            Mend(field, (end[0], end[1], point[2]), f"End the last leg at {point[2]:g} m"),
        )
        what = f"Put the target at {end[2]:g} m, or let the leg end at {point[2]:g} m."
        yield Finding(SOFT, "target_depth", "target.position_ned_m", text, what, mends)
