"""Everything a vehicle has to say in one cycle, in the order of the bus: the node and the log share it."""

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import ENDED, PAUSED
from bumpless.contract.keys import TOPICS
from bumpless.telemetry import status
from bumpless.telemetry.context import make_context
from bumpless.telemetry.cycle import messages
from bumpless.telemetry.exits import exits

if TYPE_CHECKING:
    from bumpless.config.parameters import Parameters
    from bumpless.config.vehicle import Vehicle
    from bumpless.sim.events import TwinEvent

SLOW = ("mission", "plan", "parameters", "description", "health")  # said of the flight, not of a row
END_EVENTS = ("mission_completed", "mission_aborted")  # their text is the run's end reason


class Teller:
    """Fed with every cycle in turn; says the slow topics when they are due or have changed.

    A new run is announced before its first cycle, and its end only after its last, so that whoever
    records from the one to the other misses nothing. `health` is asked for when its topic is due.
    """

    def __init__(
        self,
        vehicle: "Vehicle",
        defaults: "Parameters",
        software_version: str = "",
        session_id: str = "",
        start_time_ns: int = 0,
        health: Callable[[pb.Stamp], pb.Health] | None = None,
    ) -> None:
        self._vehicle = vehicle
        self._defaults = defaults
        self._identity = (software_version, session_id)
        self._health = health
        self._context = make_context(vehicle, defaults, start_time_ns)
        self._every = {
            name: max(1, round(1.0 / (topic.rate_hz * vehicle.control_period_s)))
            for name, topic in TOPICS.items()
            if topic.rate_hz is not None
        }
        self._told = 0
        self._stamp: pb.Stamp | None = None  # of the last cycle
        self._state: status.FlightState | None = None
        self._phase = pb.MISSION_PHASE_UNSPECIFIED
        self._end_reason = ""
        self._ended_s = 0.0  # mission time at which the run was over
        self._time_s = 0.0  # mission time of the last cycle
        self._held_s = 0.0  # length of the run's pauses, by which its longest duration grows

    def repeat(self) -> None:
        """Say every slow topic with the next cycle: somebody new may be listening."""
        self._told = 0

    def tell(
        self,
        row: np.void,
        state: status.FlightState,
        happened: "Iterable[TwinEvent]" = (),
        time_ns: int | None = None,
        cycle: int | None = None,
    ) -> Iterator[tuple[str, Message]]:
        """The messages of one cycle as (topic, message); see `messages` for the other arguments.

        `happened` are the twin's events since the last cycle.
        """
        if self._state is None or state.parameters is not self._state.parameters:
            self._context = self._context.with_parameters(state.parameters)
        own = messages(row, self._context, time_ns, cycle)
        stamp: pb.Stamp = own[0][1].stamp  # type: ignore[attr-defined]
        own = [one for one in own if self._due(one[0].removeprefix("tlm/"))]
        if self._due("exits"):
            own.append(("tlm/exits", exits(row, self._context, stamp)))
        self._stamp = stamp
        phase = int(row["phase"])
        events = [("event", self._event(stamp, one)) for one in happened]
        new_run = self._state is None or state.run_id != self._state.run_id
        if new_run:
            self._end_reason, self._held_s = "", 0.0
        elif phase == PAUSED:
            self._held_s += max(0.0, stamp.mission_time_s - self._time_s)
        self._time_s = stamp.mission_time_s
        for _, message in events:
            if message.code in END_EVENTS:
                self._end_reason = message.text
        slow = list(self._slow(stamp, state, phase))
        self._state, self._phase = state, phase
        self._told += 1
        yield from [*slow, *events, *own] if new_run else [*events, *own, *slow]

    def ended(self, state: status.FlightState, phase: int) -> Message:
        """The status that says with which phase the run has ended, for one without a cycle after its last."""
        assert self._stamp is not None
        message = self._slow_message("mission", self._stamp, state, phase)
        assert message is not None
        return message

    def _due(self, name: str) -> bool:
        """Whether this cycle says the topic, as far as its rate goes."""
        return self._told % self._every.get(name, 1) == 0

    def _slow(self, stamp: pb.Stamp, state: status.FlightState, phase: int) -> Iterator[tuple[str, Message]]:
        before = self._state
        changed = {
            "mission": before is None or phase != self._phase or state.run_id != before.run_id,
            "plan": before is None or state.mission is not before.mission,
            "parameters": before is None or state.revision != before.revision,
        }
        for name in SLOW:
            if not self._due(name) and not changed.get(name, False):
                continue
            message = self._slow_message(name, stamp, state, phase)
            if message is not None:
                yield f"tlm/{name}", message

    def _slow_message(
        self, name: str, stamp: pb.Stamp, state: status.FlightState, phase: int
    ) -> Message | None:
        if name == "mission":
            if phase not in ENDED:
                return status.mission_status(stamp, state, phase, held_s=self._held_s)
            if self._phase not in ENDED:
                self._ended_s = stamp.mission_time_s
            message = status.mission_status(stamp, state, phase, self._end_reason, self._held_s)
            message.elapsed_s = self._ended_s
            return message
        if name == "plan":
            return None if state.mission is None else status.plan(stamp, state.mission)
        if name == "parameters":
            return status.parameters_status(stamp, state, self._defaults)
        if name == "description":
            return status.description(stamp, self._vehicle, *self._identity)
        return None if self._health is None else self._health(stamp)

    @staticmethod
    def _event(stamp: pb.Stamp, happened: "TwinEvent") -> pb.Event:
        at = pb.Stamp(time_ns=stamp.time_ns, mission_time_s=stamp.mission_time_s, cycle=stamp.cycle)
        return status.event(at, happened)
