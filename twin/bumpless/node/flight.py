"""What is flown: the twin, the state around it, and the rules of who may change it when.

Everything here runs on the control loop, between two cycles; requests arrive already parsed and checked.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import ALARM, FLYING, MOVING, PAUSED, RUNNING, WARNING
from bumpless.sim.events import TwinEvent
from bumpless.telemetry import FlightState

if TYPE_CHECKING:
    from bumpless.config.mission import Mission
    from bumpless.config.parameters import Parameters


class TwinLike(Protocol):
    """What the node needs of `bumpless.sim.twin.Twin`; a real vehicle's control stack offers the same."""

    @property
    def phase(self) -> int: ...
    @property
    def parameters(self) -> "Parameters": ...
    def start(
        self, mission: "Mission", seed: int | None = None, parameters: "Parameters | None" = None
    ) -> None: ...
    def pause(self) -> None: ...
    def resume(self) -> None: ...
    def abort(self, reason: str) -> None: ...
    def set_parameters(self, parameters: "Parameters") -> None: ...
    def step(self) -> Any: ...
    def drain_events(self) -> list[TwinEvent]: ...


class Flight:
    """One vehicle's twin and what it flies with. Every request gives a CommandReply."""

    def __init__(self, twin: TwinLike) -> None:
        self.twin = twin
        self.state = FlightState(twin.parameters)
        self.chosen = twin.parameters  # the operator's; a mission's overrides lie over them while it flies
        self._events: list[TwinEvent] = []
        self._time_s = 0.0

    def start(
        self, mission: "Mission", seed: int | None, parameters: "Parameters", run_id: str
    ) -> pb.CommandReply:
        """Begin a mission, unless one is being flown."""
        if self.twin.phase in FLYING:
            return self.refuse("start", f"run {self.state.run_id} is being flown; abort it first")
        self.twin.start(mission, seed, parameters)
        flown_seed = mission.seed if seed is None else seed
        self.state = replace(self.state, mission=mission, run_id=run_id, seed=flown_seed)
        self._adopt(parameters)
        return self._done(f"flying {mission.name}")

    def pause(self) -> pb.CommandReply:
        """Hold station."""
        if self.twin.phase != RUNNING:
            return self.refuse("pause", f"no mission is running; the phase is {phase_name(self.twin.phase)}")
        self.twin.pause()
        return self._done("mission paused; holding station")

    def resume(self) -> pb.CommandReply:
        """Go on with a paused mission."""
        if self.twin.phase != PAUSED:
            return self.refuse("resume", f"no mission is paused; the phase is {phase_name(self.twin.phase)}")
        self.twin.resume()
        return self._done("mission resumed")

    def abort(self, reason: str = "aborted by the operator") -> pb.CommandReply:
        """Stop all actuators at once: while one may move, this is not refused."""
        if self.twin.phase not in MOVING:
            return self.refuse("abort", f"nothing is flown; the phase is {phase_name(self.twin.phase)}")
        self.twin.abort(reason)
        return self._done(reason)

    def abort_or_stay(self) -> pb.CommandReply:
        """Abort while a start waits that this abort has made void: nothing flown is as good as ended."""
        if self.twin.phase in FLYING:
            return self.abort()
        return self._done("nothing is flown, and the start that waited is refused")

    def set_parameters(
        self, active: "Parameters", chosen: "Parameters", seen: int | None = None
    ) -> pb.CommandReply:
        """Fly with `active` from the next cycle on (the twin blends them in), later runs with `chosen`.

        `seen` is the revision that the change was made from; another one in force refuses it.
        """
        if seen is not None and seen != self.state.revision:
            reason = f"they were made from revision {seen}, and revision {self.state.revision} is in force"
            return self.refuse("set_parameters", reason, cause=pb.REFUSAL_CAUSE_STALE_REVISION)
        self.twin.set_parameters(active)
        self.chosen = chosen
        self.state = replace(self.state, parameters=active, revision=self.state.revision + 1)
        return self._done(f"parameters are in force as revision {self.state.revision}")

    def refuse(
        self,
        verb: str,
        reason: str,
        problems: Sequence[pb.Problem] = (),
        cause: pb.RefusalCause = pb.REFUSAL_CAUSE_UNSPECIFIED,
    ) -> pb.CommandReply:
        """Say no, and put it on record as an event."""
        details = {"verb": verb, "reason": reason}
        text = f"Command {verb} refused: {reason}."
        self._events.append(TwinEvent(WARNING, "command_refused", text, details, self._time_s))
        return pb.CommandReply(
            accepted=False, reason=reason, problems=problems, revision=self.state.revision, cause=cause
        )

    def lose_heartbeat(self, silent_s: float, reaction: str) -> pb.CommandReply:
        """No console for so long: do what the vehicle's file declares, and put it on record."""
        if self.twin.phase != RUNNING:
            return self._done("no mission is running")
        does = "holds station" if reaction == "hold" else "aborts its mission"
        text = f"No word from the console for {silent_s:.1f} s: the vehicle {does}, as its file declares."
        details = {"silent_s": f"{silent_s:.1f}", "reaction": reaction}
        self._events.append(TwinEvent(ALARM, "failsafe", text, details, self._time_s))
        return self.pause() if reaction == "hold" else self.abort("the console's heartbeat was lost")

    def warn_of_rival(self, reason: str) -> pb.CommandReply:
        """Put on record that another node speaks for this vehicle while it flies."""
        text = f"Another node claims this vehicle; this one flies on: {reason}."
        self._events.append(TwinEvent(ALARM, "second_speaker", text, {"reason": reason}, self._time_s))
        return self._done(reason)

    def step(self) -> tuple[np.void, list[TwinEvent]]:
        """One control cycle: its row (valid until the next) and what happened since the last."""
        row = self.twin.step()
        self._time_s = float(row["time"])
        happened = self.twin.drain_events()
        if self._events:
            happened, self._events = [*self._events, *happened], []
        return row, happened

    def _adopt(self, parameters: "Parameters") -> None:
        if parameters != self.state.parameters:
            self.state = replace(self.state, parameters=parameters, revision=self.state.revision + 1)

    def _done(self, reason: str) -> pb.CommandReply:
        return pb.CommandReply(
            accepted=True, reason=reason, run_id=self.state.run_id, revision=self.state.revision
        )


def phase_name(phase: int) -> str:
    """ "RUNNING" for MISSION_PHASE_RUNNING."""
    return pb.MissionPhase.Name(phase).removeprefix("MISSION_PHASE_")  # type: ignore[arg-type]
