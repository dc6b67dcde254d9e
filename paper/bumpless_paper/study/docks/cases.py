"""A docking mission by number: where the dock is, how the vehicle comes to it, what sea, plant and faults.

The vehicle begins 28 to 45 m off within 60 deg of the approach, the dock is up to 0.5 m from its planned
place, and the plant is one of `study.plants` with its fins' slew and lift and its thrust drawn as well, so
that the allocator's map is never exact.
"""

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Literal

import numpy as np

from bumpless.config.mission.model import End, Fault, Leg, Mission, Start, Target
from bumpless.config.mission.sea import CurrentVariation, Environment
from bumpless.config.mission.sensing import Outage, Sensors
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless_paper.study.plants import Plant, draw

HELD_OUT = 1_000_000
Kind = Literal["normal", "still", "camera_dead", "lost", "fault", "any"]
KINDS: tuple[Kind, ...] = ("normal", "still", "camera_dead", "lost", "fault", "any")
Heading = Literal["", "fixed", "some", "into"]  # how free the approach heading is; "": drawn
SPEED_MPS, STANDOFF_M, DURATION_S, HOLD_S = 0.7, 1.5, 600.0, 12.0


@dataclass(frozen=True)
class Case:
    """One drawn mission with its truth. Callable as `alter` of `simulate`."""

    number: int
    kind: Kind
    mission: Mission
    plant: Plant

    def __call__(self, model: Any, truth: Any) -> None:
        """Change the records of the true plant and of the flight's truth in place."""
        self.plant(model, truth)


@cache
def vehicle() -> Vehicle:
    """Who docks."""
    return load_vehicle("ts100")


def draw_case(number: int, kind: Kind = "normal", heading: Heading = "") -> Case:
    """Case `number` of a kind.

    normal: a current of up to 0.15 m/s from any side, with slow changes; still: none; camera_dead: as normal,
    and the target is never seen; lost: it is lost for a while; fault: an actuator loses effect; any: a fault
    and a loss.
    """
    r = np.random.Generator(np.random.PCG64([77, number]))
    target, point, toward = _dock(r, heading)
    start, legs = _path(r, point, toward)
    environment = _sea(r, kind)
    faults, outages = _trouble(r, kind)
    mission = Mission(
        version=1, name=f"case{number}", vehicle="ts100", duration_s=DURATION_S, start=start, legs=legs,
        target=target, seed=number % 2**31, environment=environment, sensors=Sensors(outages=outages),
        faults=faults, end=End(HOLD_S),
    )  # fmt: skip
    plant = replace(
        draw(number), current_along=0.0, current_across=0.0, fault_time=None, fault_effectiveness=None,
        thrust=float(r.uniform(0.85, 1.15)), fin_lift=float(r.uniform(0.6, 1.15)),
        fin_slew=float(2.0 ** r.uniform(-1.0, 1.0)),
    )  # fmt: skip
    return Case(number, kind, mission, plant)


def _dock(r: np.random.Generator, heading: Heading) -> tuple[Target, np.ndarray, float]:
    """The target, its observation point NED and the approach heading, rad."""
    toward = r.uniform(0.0, 360.0)
    free = heading or ("fixed", "some", "into")[int(r.integers(3))]
    tolerance = {"fixed": 0.0, "some": float(r.uniform(10.0, 60.0)), "into": 180.0}[free]
    marker = np.array([*r.uniform(-5.0, 5.0, 2), r.uniform(2.0, 6.0)])
    north, east = map(float, r.uniform(-0.5, 0.5, 2))
    offset = (north, east, float(r.uniform(-0.25, 0.25)))
    target = Target(_place(marker), toward, STANDOFF_M, offset, tolerance)
    psi = math.radians(toward)
    return target, marker - STANDOFF_M * np.array([math.cos(psi), math.sin(psi), 0.0]), psi


def _path(r: np.random.Generator, point: np.ndarray, toward: float) -> tuple[Start, tuple[Leg, ...]]:
    bearing, far = toward + math.radians(r.uniform(-60.0, 60.0)), r.uniform(28.0, 45.0)
    start = point - far * np.array([math.cos(bearing), math.sin(bearing), 0.0])
    start[2] = min(max(point[2] + r.uniform(-0.8, 0.8), 1.0), 10.0)
    before = r.uniform(14.0, 20.0) * np.array([math.cos(toward), math.sin(toward), 0.0])
    turn = point - before + np.array([*r.uniform(-2.0, 2.0, 2), 0.0])
    course = math.degrees(math.atan2(turn[1] - start[1], turn[0] - start[0]))
    legs = (Leg(_place(turn), SPEED_MPS), Leg(_place(point), SPEED_MPS))
    return Start(_place(start), course, SPEED_MPS), legs


def _sea(r: np.random.Generator, kind: Kind) -> Environment:
    speed, way = r.uniform(0.0, 0.15), r.uniform(0.0, 2.0 * math.pi)
    change = CurrentVariation(float(r.uniform(0.001, 0.006)), float(r.uniform(20.0, 60.0)))
    if kind == "still":
        return Environment()
    return Environment((float(speed * math.cos(way)), float(speed * math.sin(way)), 0.0), change)


def _trouble(r: np.random.Generator, kind: Kind) -> tuple[tuple[Fault, ...], tuple[Outage, ...]]:
    names = [actuator.name for actuator in vehicle().actuators]
    which = int(r.integers(len(names) + 3))  # the screw of S5 to S7 more often than the others
    name = names[which] if which < len(names) else "n_p"
    left = float(r.uniform(0.2 if name == "n_p" else 0.0, 0.7))
    fault = Fault(name, float(r.uniform(20.0, 120.0)), left, 1.0)
    lost = float(r.uniform(40.0, 150.0))
    outage = Outage(lost, float(lost + r.uniform(5.0, 200.0)))
    if kind == "camera_dead":
        outage = Outage(0.0, 1e4)
    faults = (fault,) if kind in ("fault", "any") else ()
    return faults, (outage,) if kind in ("lost", "any", "camera_dead") else ()


def _place(x: np.ndarray) -> tuple[float, float, float]:
    return float(x[0]), float(x[1]), float(x[2])
