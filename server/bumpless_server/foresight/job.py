"""One request on its way: what of it is still to be done, and what its fan has found so far."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from pydantic import TypeAdapter

from bumpless.campaign.summary import share_of
from bumpless.config.vehicle import Vehicle
from bumpless_server.foresight.tasks import Task
from bumpless_server.foresight.told import ForesightChance, ForesightFan, ForesightFlight
from bumpless_server.foresight.wanted import ForesightRequest

FIRST, CHUNK = 5, 10  # flights a task: the first ones are told early
DOCKED = "docked"
_FLIGHTS = TypeAdapter(list[ForesightFlight])


@dataclass(frozen=True)
class Present:
    """The vehicle on the bus as it is now, which a mission of its name will be flown by."""

    vehicle: Vehicle | None = None  # None: it has not described itself
    tuned: bytes = b""  # what the operator tuned it with, a bumpless.Parameters; b"": nothing

    @property
    def toml(self) -> str:
        """The vehicle's file."""
        return self.vehicle.text if self.vehicle is not None else ""


class Job:
    """A request and its tasks, in the order in which they are done: nominal, findings, then the fan."""

    def __init__(self, request: ForesightRequest, present: Present, numbers: Iterator[int]) -> None:
        self.request = request
        self._present, self._numbers = present, numbers
        self._next = 0  # flight to ask for
        self._begun: set[str] = set()
        self._open = 0  # tasks that are being done
        self._counts: Counter[str] = Counter()
        self.refused = False  # the text can't be read: nothing more is to be done

    def task(self, urgent: bool) -> Task | None:
        """The next task, None when none is left to begin; urgent: no drawn flights."""
        if self.refused:
            return None
        for kind in ("nominal", "findings"):
            if kind not in self._begun:
                self._begun.add(kind)
                return self._task(kind)
        left = self.request.flights - self._next
        if urgent or left <= 0:
            return None
        count = min(left, FIRST if self._next < 4 * FIRST else CHUNK)
        first, self._next = self._next, self._next + count
        return self._task("fan", first=first, count=count)

    def finished(self) -> None:
        """One of its tasks is done."""
        self._open -= 1

    @property
    def done(self) -> bool:
        """Whether nothing is left to do or being done."""
        begun = self.refused or (len(self._begun) == 2 and self._next >= self.request.flights)
        return begun and self._open == 0

    def fan(self, flights: bytes) -> ForesightFan:
        """Take a task's flights in and tell them with the chance so far."""
        found = _FLIGHTS.validate_json(flights)
        self._counts.update(flight.outcome for flight in found)
        done = self._counts.total()
        share = share_of(self._counts[DOCKED], done)
        chance = ForesightChance(
            docked=share.count, of=done, low=share.low, high=share.high, counts=dict(self._counts)
        )
        return ForesightFan(
            id=self.request.id, flights=found, done=done, of=self.request.flights, chance=chance
        )

    def _task(self, kind: str, **more: int) -> Task:
        self._open += 1
        told = {"number": next(self._numbers), "kind": kind, "request": self.request}
        present = {"present": self._present.toml, "tuned": self._present.tuned.hex()}
        return Task.model_validate({**told, **present, **more})
