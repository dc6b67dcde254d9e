"""How TS-100 answers a step of depth or heading in F, starts, holds station for long, and bears a load.

Plants are drawn by number. Every function flies one and says what the table of outcomes wants of it.
"""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from bumpless.config.mission import End, Mission, parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.contract.enums import APPROACH, HOVER
from bumpless.feasibility import check_mission
from bumpless.metrics.outcome import DOCKED
from bumpless.sim.twin import Twin, new_log, parameters_for, simulate
from bumpless_paper.study.docks.cases import Case, draw_case, vehicle
from bumpless_paper.study.docks.judge import judge
from bumpless_paper.study.docks.many import fly_case
from bumpless_paper.study.plants import Plant, draw

STRAIGHT = """
version: 1
name: straight
vehicle: ts100
duration_s: 400
seed: 1
start: {position_ned_m: [0, 0, 2.0], heading_deg: 0, speed_mps: 0.7}
legs: [{to_ned_m: [200, 0, 2.0], speed_mps: 0.7}]
target: {position_ned_m: [201.5, 0, 2.0], heading_deg: 0, standoff_m: 1.5}
"""
FAR_SIGHTED = "parameters: {guidance: {look_ahead_m: 150}}\n"  # so that heading is what is followed
PERIOD_S, BEFORE, AFTER, LAST = 0.05, 600, 800, 100  # cycles
DEPTH_M, TURN_DEG = 0.5, 20.0
STAY_S = 600.0
BALLAST_SHARE, BALLAST_WAY_M = 0.01, 0.05
OFF_BOW_RAD = math.radians(10.0)
ABOUT_STATION = ("current_not_holdable", "current_hard_to_hold", "long_hover")  # findings


@dataclass(frozen=True)
class Step:
    """A step response: when it stays within 5 % for good, and how far it goes beyond."""

    settled_s: float
    overshoot: float  # share of the step


def still_plant(number: int) -> Plant:
    """The plant of this number in still water."""
    return replace(draw(number), current_along=0.0, current_across=0.0, fault_time=None)


def depth_step(number: int) -> Step:
    """0.5 m down in F, at cruise."""
    twin = _begun(STRAIGHT, number)
    before = _rows(twin, BEFORE)["eta"][-LAST:, 2].mean()
    twin.onboard["plan"]["waypoint"][:2, 2] += DEPTH_M
    deep = twin.onboard["plan"]["target"][2] + DEPTH_M
    twin.onboard["plan"]["target"][2] = twin.onboard["state"]["navigation"]["target"][2] = deep
    return _step(_rows(twin, AFTER)["eta"][:, 2] - before)


def heading_step(number: int) -> Step:
    """20 deg to starboard in F, at cruise."""
    twin = _begun(STRAIGHT + FAR_SIGHTED, number)
    before = _rows(twin, BEFORE)["eta"][-LAST:, 5].mean()
    plan, state = twin.onboard["plan"], twin.onboard["state"]
    turn, here = np.radians(TURN_DEG), state["navigation"]["eta"][:2].copy()
    ahead = np.array([np.cos(turn), np.sin(turn)])
    plan["waypoint"][0, :2], plan["waypoint"][1, :2] = here, here + 200.0 * ahead
    plan["target"][:2] = state["navigation"]["target"][:2] = here + 201.5 * ahead
    plan["target"][3] = state["docking"]["heading"] = turn
    return _step(_rows(twin, AFTER)["eta"][:, 5] - before)


def start_dip(number: int) -> float:
    """Largest loss of speed in the first 15 s, m/s."""
    mission = replace(_mission(STRAIGHT), duration_s=15.0)
    speed = simulate(mission, vehicle(), alter=still_plant(number)).log["nu"][:, 0]
    return float(max(0.0, speed[0] - speed.min()))


@dataclass(frozen=True)
class Stay:
    """Ten minutes after a docking, in the current that it was docked in. NaN where nothing was flown."""

    accepted: bool  # the mission's check has nothing to say about its current; else it isn't flown
    held: bool  # docked, then in H at the observation point all the time
    within: float  # share of that time within docked's limits, by the truth
    wander_deg: float  # deviation of the heading from the approach heading, which follows the current


def stay_case(number: int) -> Case:
    """Every other draw is free to turn; the others keep their heading, in a current within 10 deg of it."""
    if number % 2 == 0:
        return draw_case(number, "normal", "into")
    case = draw_case(number, "normal", "fixed")
    sea, heading = case.mission.environment, math.radians(case.mission.target.heading_deg)
    speed = math.hypot(*sea.current_ned_mps[:2])
    off = np.random.Generator(np.random.PCG64([78, number])).uniform(-OFF_BOW_RAD, OFF_BOW_RAD)
    flow = (-speed * math.cos(heading + off), -speed * math.sin(heading + off), 0.0)
    return replace(case, mission=replace(case.mission, environment=replace(sea, current_ned_mps=flow)))


def stay(number: int) -> Stay:
    """Ask for ten minutes; where that is accepted, dock and go on for ten minutes."""
    case = stay_case(number)
    asked = replace(case.mission, end=End(STAY_S))
    if any(found.code in ABOUT_STATION for found in check_mission(asked, vehicle())):
        return Stay(False, False, math.nan, math.nan)
    mission = replace(case.mission, end=End(), duration_s=case.mission.duration_s + STAY_S)
    log = simulate(mission, vehicle(), default_parameters(vehicle()), mission.seed, alter=case).log
    in_place = np.flatnonzero(log["held"] >= 10.0)
    if not len(in_place):
        return Stay(True, False, 0.0, math.nan)
    then = log[in_place[0] : in_place[0] + round(STAY_S / PERIOD_S)]
    hovers = (then["mode"] == HOVER) & (then["stage"] == APPROACH)
    off = np.angle(np.exp(1j * (then["eta"][:, 5] - then["approach"])))
    within = hovers & (then["range_true"] <= DOCKED.position_m)
    within &= np.abs(np.degrees(off)) <= DOCKED.heading_deg
    return Stay(True, bool(hovers.all()), float(within.mean()), float(np.degrees(np.std(off[hovers]))))


def loaded(number: int, load_n: float) -> bool:
    """Whether a vehicle so much too light (N) docks in still water; its screws push as the file says."""
    case = draw_case(number, "still")
    case = replace(case, plant=replace(case.plant, net_buoyancy=load_n, thrust=1.0))
    return judge(case, fly_case(case)).outcome == "docked"


def shifted(number: int) -> bool:
    """Whether a vehicle docks in still water with 1 % of its mass moved by 5 cm, ahead on even draws, else
    astern: that moves the centre of gravity by 0.5 mm and pitches the hull by 2.9 deg."""
    case, ahead = draw_case(number, "still"), -1.0 if number % 2 else 1.0
    trim = -ahead * BALLAST_SHARE * BALLAST_WAY_M  # the centre of buoyancy seen from the one of gravity
    case = replace(case, plant=replace(case.plant, trim_x=trim))
    return judge(case, fly_case(case)).outcome == "docked"


def _mission(text: str) -> Mission:
    return parse_mission(text, "straight.yaml", vehicle())


def _begun(text: str, number: int) -> Twin:
    twin, mission = Twin(vehicle()), _mission(text)
    twin.start(mission, number, parameters_for(vehicle(), mission), still_plant(number))
    return twin


def _rows(twin: Twin, cycles: int) -> Any:
    log = new_log(cycles)
    return log[: twin.fly(log)]


def _step(moved: np.ndarray) -> Step:
    """From where it was and where it ends; a second's mean, for the hull also shakes with noise."""
    n = round(1.0 / PERIOD_S)
    padded = np.pad(moved, (n // 2, n - 1 - n // 2), "edge")
    smooth = np.convolve(padded, np.ones(n) / n, "valid") / moved[-LAST:].mean()
    out = np.flatnonzero(np.abs(smooth - 1.0) > 0.05)
    return Step(PERIOD_S * (int(out[-1]) + 1) if len(out) else 0.0, float(max(0.0, smooth.max() - 1.0)))
