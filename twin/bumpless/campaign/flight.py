"""Fly one number of a campaign and keep one row of it. A worker holds one log and one twin, used again."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from bumpless.campaign.drawn import OF_SENSORS, drawn_mission, drawn_vehicle, relative_current
from bumpless.campaign.geometry import believed_errors, nose_clearance, true_errors
from bumpless.campaign.outcome import Decided, Judge
from bumpless.campaign.plant import Alteration
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.ready import ready
from bumpless.campaign.tracking import cost, tracking
from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.sim.twin import Twin, new_log

BLOCK = 200  # cycles between two looks at whether the flight is decided

Row = dict[str, Any]


class Hangar:
    """The twins and the log of one worker thread."""

    def __init__(self) -> None:
        self._of: tuple[Any, ...] = ()
        self._twin: Twin | None = None
        self._log = new_log(0)

    def twin(self, vehicle: Vehicle, parameters: Parameters, values: Row) -> Twin:
        """A twin of the vehicle as drawn; the last one when it was the same vehicle with the same sensors."""
        of = (vehicle, *(values.get(name) for name in OF_SENSORS))
        if self._twin is None or self._of[0] is not vehicle or self._of[1:] != of[1:]:
            self._of, self._twin = of, Twin(drawn_vehicle(vehicle, values), parameters)
        return self._twin

    def log(self, cycles: int) -> np.ndarray:
        """Rows to write to; what they hold is old."""
        if len(self._log) < cycles:
            self._log = new_log(cycles)
        return self._log[:cycles]


class FlyNumbers:
    """Flights of a campaign by their numbers: the work of one chunk, picklable."""

    def __init__(self, prepared: Prepared) -> None:
        self.prepared = prepared

    def __call__(self, numbers: Sequence[int]) -> list[Row]:
        """One row per number."""
        ready()
        hangar = Hangar()
        return [fly_number(self.prepared, number, hangar) for number in numbers]


def fly_number(prepared: Prepared, number: int, hangar: Hangar) -> Row:
    """The row of flight `number`."""
    setup, values, seed = prepared.setup(number), prepared.values(number), prepared.seed(number)
    mission = drawn_mission(setup.mission, values)
    twin = hangar.twin(setup.vehicle, setup.parameters, values)
    vehicle = twin.vehicle
    twin.start(mission, seed, setup.parameters, Alteration.of(values))
    judge = Judge(mission, vehicle, prepared.campaign.docked)
    log, decided = _flown(twin, judge, hangar.log(twin.cycles))
    twin.drain_events()
    speed, toward = relative_current(mission)
    return {
        "number": number,
        "seed": seed,
        "mission": mission.name,
        "outcome": decided.outcome.value,
        "reason": decided.reason,
        "current_mps": speed,
        "current_relative_deg": toward,
        **_ending(log, mission, vehicle),
        **tracking(log),
        **cost(log, vehicle),
        **{f"draw_{name}": value for name, value in values.items()},
    }


def _flown(twin: Twin, judge: Judge, log: np.ndarray) -> tuple[np.ndarray, Decided]:
    """The rows up to where the flight is decided, or to its end."""
    begun, filled = twin.phase, 0
    while filled < len(log) and twin.phase == begun:
        filled += twin.fly(log[filled : filled + BLOCK])
        decided = judge.look(log[:filled])
        if decided is not None:
            return log[: decided.rows], decided
    return log[:filled], judge.over(log[:filled])


ENDING = (
    "time_s", "closest_m", "nose_clearance_m",
    "end_range_m", "end_depth_m", "end_heading_deg", "end_speed_mps",
    "believed_range_m", "believed_depth_m", "believed_heading_deg", "believed_speed_mps",
)  # fmt: skip


def _ending(log: np.ndarray, mission: Mission, vehicle: Vehicle) -> Row:
    """When it ended, how close it came, and its true and believed errors there."""
    true = true_errors(log, mission)
    believed = believed_errors(log[-1:], mission)
    values = [float(log["time"][-1]), float(true.range.min())]
    values.append(float(nose_clearance(log, mission, vehicle).min()))
    for errors in (true, believed):
        values += [
            float(errors.range[-1]),
            float(errors.depth[-1]),
            float(np.degrees(errors.heading[-1])),
            float(errors.speed[-1]),
        ]
    return dict(zip(ENDING, values, strict=True))
