"""Fly one number of a campaign and keep one row of it. A worker holds one twin and its room, used again."""

import platform
from collections.abc import Sequence
from functools import cache
from typing import Any

from bumpless.campaign.drawn import OF_SENSORS, drawn_mission, drawn_vehicle, relative_current
from bumpless.campaign.figures import figures
from bumpless.campaign.gathered import Gatherer
from bumpless.campaign.plant import Alteration
from bumpless.campaign.prepared import Prepared, software
from bumpless.campaign.ready import ready
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.metrics import figures_of
from bumpless.sim.twin import Twin

Row = dict[str, Any]


class FlightError(RuntimeError):
    """A flight that could not be flown to its end, which is a fault of the software."""

    def __init__(self, number: int, error: str) -> None:
        super().__init__(number, error)  # so that it comes back whole from a worker

    def __str__(self) -> str:
        number, error = self.args
        return f"flight {number} could not be flown: {error}; `bumpless run FILE --draw {number}` shows where"


class Hangar:
    """The twin of one worker thread, and the room for its flights."""

    def __init__(self) -> None:
        self._of: tuple[Any, ...] = ()
        self._twin: Twin | None = None
        self.gatherer = Gatherer()

    def twin(self, vehicle: Vehicle, parameters: Parameters, values: Row) -> Twin:
        """A twin of the vehicle as drawn; the last one when it was the same vehicle with the same sensors."""
        of = (vehicle, *(values.get(name) for name in OF_SENSORS))
        if self._twin is None or self._of[0] is not vehicle or self._of[1:] != of[1:]:
            self._of, self._twin = of, Twin(drawn_vehicle(vehicle, values), parameters)
        return self._twin


class OtherSoftware(RuntimeError):
    """A worker would fly something else than who sent it the campaign."""


@cache
def _here() -> str:
    return software()  # which reads all sources


class FlyNumbers:
    """Flights of a campaign by their numbers: the work of one chunk, picklable.

    It knows the software it was made by: a flight of another one is none of this campaign. Raises
    OtherSoftware.
    """

    def __init__(self, prepared: Prepared) -> None:
        self.prepared = prepared
        self.software = software()

    def __call__(self, numbers: Sequence[int]) -> list[Row]:
        """One row per number. Raises OtherSoftware, FlightError."""
        if self.software != _here():
            raise OtherSoftware(f"{platform.node()} has Bumpless {_here()}, this program {self.software}")
        ready()
        hangar, rows = Hangar(), list[Row]()
        for number in numbers:
            try:
                rows.append(fly_number(self.prepared, number, hangar))
            except Exception as error:
                raise FlightError(number, f"{type(error).__name__}: {error}") from error
        return rows


def fly_number(prepared: Prepared, number: int, hangar: Hangar) -> Row:
    """The row of flight `number`, judged as every run is."""
    setup, values, seed = prepared.setup(number), prepared.values(number), prepared.seed(number)
    mission = drawn_mission(setup.mission, values)
    twin = hangar.twin(setup.vehicle, setup.parameters, values)
    vehicle = twin.vehicle
    twin.start(mission, seed, setup.parameters, Alteration.of(values))
    columns = hangar.gatherer.fly(twin).as_told([c.unit for c in vehicle.commands])
    twin.drain_events()
    limits = prepared.campaign.docked.limits
    metrics, outcome = figures_of(columns, vehicle, mission, "completed", limits=limits, checks=False)
    speed, toward = relative_current(mission)
    return {
        "number": number,
        "seed": seed,
        "mission": mission.name,
        "outcome": outcome.ending.value,
        "why": outcome.why,
        "reason": outcome.reason,
        "current_mps": speed,
        "current_relative_deg": toward,
        **figures(metrics, outcome),
        **{f"draw_{name}": value for name, value in values.items()},
    }
