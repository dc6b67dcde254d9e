"""What is flown: the twin, the state around it, and the rules of who may change it when.

Everything here runs on the control loop, between two cycles; requests arrive already parsed and checked.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from bumpless.config.vehicle.failsafe import REACTIONS, WORDS, Failsafe, Reaction
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import ALARM, FLYING, MOVING, PAUSED, RUNNING, WARNING
from bumpless.node.failsafe import Watch, told
from bumpless.sim.condition import Condition
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
    def surface(self) -> None: ...
    def wave_off(self) -> bool: ...
    @property
    def condition(self) -> Condition: ...
    def set_parameters(self, parameters: "Parameters") -> None: ...
    def step(self) -> Any: ...
    def drain_events(self) -> list[TwinEvent]: ...


class Flight:
    """One vehicle's twin and what it flies with. Every request gives a CommandReply."""

    def __init__(self, twin: TwinLike, declared: Failsafe | None = None, period_s: float = 0.05) -> None:
        self.twin = twin
        self.place: np.ndarray | None = None  # [x y z phi theta psi] of the last cycle, m and rad
        self._watch = Watch(declared or Failsafe(), period_s)
        self._in_force: Reaction = "none"
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
        self._watch.begin(mission)
        self._in_force = "none"
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
        self._in_force = "none"
        return self._done("mission resumed")

    def surface(self) -> pb.CommandReply:
        """Hold at the surface, the mission at rest; also where it is over and station is held."""
        if self.twin.phase not in MOVING:
            return self.refuse("surface", f"nothing is flown; the phase is {phase_name(self.twin.phase)}")
        self.twin.surface()
        return self._done("holding at the surface")

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

    def react(self, cause: str, what: str, reaction: Reaction) -> pb.CommandReply:
        """Do what the vehicle's file declares for a cause, and put it on record; no less than is in force."""
        if reaction == "none" or self.twin.phase not in MOVING:
            return self._done("nothing is to be done")
        details = {"cause": cause, "reaction": reaction}
        if REACTIONS.index(reaction) <= REACTIONS.index(self._in_force):
            text = f"{what}: the vehicle {WORDS[self._in_force]} already."
            self._events.append(TwinEvent(ALARM, "failsafe", text, details, self._time_s))
            return self._done(text)
        self._events.append(TwinEvent(ALARM, "failsafe", told(what, reaction), details, self._time_s))
        self._in_force = reaction
        if reaction == "abort":
            return self.abort(what)
        if reaction == "surface":
            self.twin.surface()
        elif self.twin.phase == RUNNING and not (reaction == "wave_off" and self.twin.wave_off()):
            self.twin.pause()
        return self._done(WORDS[reaction])

    def come_back(
        self, mission: "Mission", seed: int, parameters: "Parameters", run_id: str, reaction: Reaction
    ) -> pb.CommandReply:
        """After a crash in flight: do what the file declares, in the run that was flown."""
        what = f"Its program crashed in run {run_id}"
        if reaction == "abort":
            text = told(what, reaction)
            details = {"cause": "after_crash", "reaction": reaction}
            self._events.append(TwinEvent(ALARM, "failsafe", text, details, self._time_s))
            return self._done(text)
        self.start(mission, seed, parameters, run_id)
        return self.react("after_crash", what, reaction)

    def warn_of_rival(self, reason: str) -> pb.CommandReply:
        """Put on record that another node speaks for this vehicle while it flies."""
        text = f"Another node claims this vehicle; this one flies on: {reason}."
        self._events.append(TwinEvent(ALARM, "second_speaker", text, {"reason": reason}, self._time_s))
        return self._done(reason)

    def step(self) -> tuple[np.void, list[TwinEvent]]:
        """One control cycle: its row (valid until the next) and what happened since the last."""
        row = self.twin.step()
        self._time_s = float(row["time"])
        self.place = row["eta_hat"]
        phase = self.twin.phase
        if phase in MOVING:
            for cause in self._watch.look(row, phase, self.twin.condition):
                self.react(*cause)
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
