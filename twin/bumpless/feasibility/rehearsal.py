"""The beginning of a mission, flown a few times: does the hull come into the dock?

Next to a dock a metre, or a few degrees of the bow, decide whether a turn leads past it, and no rule of a
line or two tells. So the very autopilot and plant that fly are asked: with the plan as it is, and with the
target and the current a little off it, as far as a careful operator leaves them open.
"""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.metrics.dock import body_of, is_inside

LASTS_S = 20.0  # those who ran into a dock that they started before did within 12 s
FLIGHTS = 16
_OFF_M, _FLOW_MPS = 0.3, 0.015  # one deviation and a half of target and current, each way
_ASIDE = ((0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.7, 0.7), (-0.7, -0.7), (0.7, -0.7))


@dataclass(frozen=True)
class Rehearsed:
    """What became of the flights."""

    struck: int  # in how many a part of the hull was in the dock
    when_s: float  # the earliest time; infinite: never


def rehearse(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Rehearsed:
    """Fly the beginning of a mission FLIGHTS times; always the same for the same mission."""
    from bumpless.sim.twin import Twin, new_log

    twin, log = Twin(vehicle, parameters), new_log(round(LASTS_S / vehicle.control_period_s))
    first: list[float] = []
    for number, off in enumerate(_ASIDE * (FLIGHTS // len(_ASIDE))):
        twin.start(_moved(mission, off), mission.seed + number, parameters)
        flown = log[: twin.fly(log)]
        twin.drain_events()
        inside = _in_dock(flown, mission, vehicle)
        first.append(float(flown["time"][np.argmax(inside)]) if inside.any() else math.inf)
    return Rehearsed(sum(map(math.isfinite, first)), min(first))


def _moved(mission: Mission, off: tuple[float, float]) -> Mission:
    """The mission with its true target and its current a deviation off, north and east."""
    north, east = off
    target, sea = mission.target, mission.environment
    o, c = target.true_offset_ned_m, sea.current_ned_mps
    place = (o[0] + _OFF_M * north, o[1] + _OFF_M * east, o[2])
    flow = (c[0] - _FLOW_MPS * east, c[1] + _FLOW_MPS * north, c[2])
    return replace(
        mission,
        target=replace(target, true_offset_ned_m=place),
        environment=replace(sea, current_ned_mps=flow),
    )


def _in_dock(log: np.ndarray, mission: Mission, vehicle: Vehicle) -> np.ndarray:
    """(n,) whether the hull is in the dock, by the truth: as `metrics.dock.clearance_of` judges a run."""
    body, eta = body_of(mission.target), np.ascontiguousarray(log["eta"])
    from_marker: Any = eta[:, :3] - log["target_true"]
    inside = is_inside(eta, from_marker, log["approach"], vehicle, body)
    return (
        inside if body.heading is None else inside | is_inside(eta, from_marker, body.heading, vehicle, body)
    )
