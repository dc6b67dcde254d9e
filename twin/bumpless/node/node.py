"""The node's threads put together: who feeds whom, and in which order they begin and end."""

import gc
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import zenoh

from bumpless.config.vehicle.failsafe import Failsafe, Reaction
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.enums import FLYING
from bumpless.contract.exits import FAILED, TAKEN
from bumpless.contract.messages import descriptor_set
from bumpless.contract.version import software_version
from bumpless.node.claim import Claim, TakenError
from bumpless.node.come_back import come_back
from bumpless.node.commands import Commander
from bumpless.node.failsafe import ClockWatch
from bumpless.node.flight import Flight, TwinLike
from bumpless.node.health import HealthReport
from bumpless.node.heartbeat import Heartbeat
from bumpless.node.loop import ControlLoop, Handoff
from bumpless.node.memory import Memory
from bumpless.node.pacing import FreeClock, WallClock
from bumpless.node.publisher import BusWriter, Publisher
from bumpless.node.ring import Ring
from bumpless.node.stop import Stop
from bumpless.telemetry import Teller

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

LOOK_S = 0.25  # between looks at who else claims the vehicle


class Node:
    """One vehicle on one open session. `name` is its id on the bus."""

    def __init__(
        self,
        session: zenoh.Session,
        name: str,
        vehicle: "Vehicle",
        twin: TwinLike,
        stop: Stop,
        realtime: bool = True,
        memory: Memory | None = None,
    ) -> None:
        period_ns = round(vehicle.control_period_s * 1e9)
        self._session, self._name, self._stop = session, name, stop
        clock = WallClock(period_ns) if realtime else FreeClock(period_ns)
        ring = Ring(lossless=not realtime)
        self._failsafe, self._vehicle = vehicle.failsafe, vehicle
        self._flight = flight = Flight(twin, vehicle.failsafe, vehicle.control_period_s)
        self._told_of_rival, self._speaks = False, False
        self._memory = memory or Memory(None)
        # in virtual time seconds mean nothing to a console, and no clock is followed
        self._heartbeat = Heartbeat(vehicle.failsafe if realtime else Failsafe())
        jump_s = vehicle.failsafe.clock_jump_s if realtime else 0.0
        self._clock_watch = ClockWatch(jump_s, time.time_ns, time.monotonic_ns)
        self._loop = ControlLoop(flight, clock, ring)
        self._held: list[zenoh.Queryable[None] | zenoh.Subscriber[None]] = []
        teller = Teller(
            replace(vehicle, id=name),
            flight.chosen,
            software_version(),
            str(session.zid()),
            health=HealthReport(self._loop, ring, lambda: twin.condition),
        )
        self._publisher = Publisher(
            ring, teller, BusWriter(session, name, not realtime, vehicle.control_period_s)
        )
        self._commander = Commander(
            name,
            vehicle,
            flight,
            self._loop,
            clock.time_ns,
            stop,
            str(session.zid()),
            clock.time_ns if realtime else None,
        )

    def run(
        self, claim: Claim, first: pb.StartMission | None, say: Callable[[str], None]
    ) -> Exception | None:
        """Fly until told to stop; `first` is a mission to begin with. Returns why the loop failed, if so.

        The order at the end: the loop flies its last cycle, all rows are said, requests are answered.
        """
        thread = threading.Thread(target=self._loop.run, args=(self._ended,), name="control", daemon=True)
        self._commander.start()
        gc.collect()
        gc.freeze()  # what is loaded stays; later collections look only at what came after
        gc.disable()  # and happen when the publisher says so
        thread.start()
        if claim.settled:
            self._speak(claim, say)
        else:
            say(f"{self._name} is ready, and says nothing before it has found its bus")
        left = self._memory.left()
        if left is not None:
            say(come_back(left, self._vehicle, self._flight, self._loop))
        if first is not None:
            reply = self._commander.answer("start", first.SerializeToString())
            say(reply.reason)
            for problem in reply.problems:
                say(f"{problem.file}:{problem.line}: {problem.field}: {problem.rule}")
        while not self._stop.event.wait(LOOK_S):
            self._look_at(claim, say)
        self._loop.stop(self._stop.reason)
        thread.join()
        if self._speaks:
            self._publisher.join()
        self._memory.forget()
        for one in self._held:
            one.undeclare()
        self._commander.close()
        return self._loop.fault

    def _speak(self, claim: Claim, say: Callable[[str], None]) -> None:
        """From now on it is heard and can be asked: nobody else is the vehicle."""
        self._speaks = True
        self._publisher.start()
        self._held = self._serve()
        claim.declare_alive()
        say(f"{self._name} is alive")

    def _settle(self, claim: Claim, say: Callable[[str], None]) -> None:
        """The bus was not there at the start. Once it is, ask before a word is said."""
        if not claim.linked():
            return
        try:
            claim.confirm()
        except TakenError as error:
            if self._flight.twin.phase in FLYING:  # a mission that began without any bus is flown to its end
                return
            self._stop(str(error), TAKEN)
            return
        self._speak(claim, say)

    def _look_at(self, claim: Claim, say: Callable[[str], None]) -> None:
        """What the loop must not wait for: the disk, the clock, who is gone, other nodes."""
        phase = self._flight.twin.phase
        self._memory.note(phase, self._flight.state, self._flight.place)
        for lost in self._heartbeat.lost(phase):
            self._react(*lost)
        jump_s = self._clock_watch.jump_s()
        if jump_s is not None:
            self._react("clock_jump", f"Its clock has jumped by {jump_s:+.1f} s", self._failsafe.clock_jump)
        if self._speaks:
            self._look_for_rivals(claim)
        else:
            self._settle(claim, say)

    def _react(self, cause: str, what: str, reaction: Reaction) -> None:
        self._loop.submit(Handoff("failsafe", lambda flight: flight.react(cause, what, reaction)))

    def _look_for_rivals(self, claim: Claim) -> None:
        """Give way to an older node, but never in flight: then it is said, and settled afterwards."""
        reason = claim.contested()
        if reason is None:
            self._told_of_rival = False
        elif self._flight.twin.phase not in FLYING:
            self._stop(reason, TAKEN)
        elif not self._told_of_rival:
            self._told_of_rival = True
            self._loop.submit(Handoff("claim", lambda flight: flight.warn_of_rival(reason)))

    def _ended(self) -> None:
        self._stop("the control loop has ended", FAILED)

    def _serve(self) -> "list[zenoh.Queryable[None] | zenoh.Subscriber[None]]":
        schema_key, contract = keys.schema(self._name), descriptor_set(pb.Stamp)

        def tell_schema(query: zenoh.Query) -> None:
            with query:
                query.reply(schema_key, contract, encoding=SCHEMA_ENCODING)

        return [
            self._session.declare_queryable(schema_key, tell_schema, complete=True),
            self._session.declare_subscriber(
                keys.heartbeat(self._name), lambda sample: self._heartbeat.beat(sample.payload.to_bytes())
            ),
            self._session.declare_queryable(
                keys.command(self._name, "*"), self._commander.enqueue, complete=True
            ),
        ]


SCHEMA_ENCODING = "application/protobuf;google.protobuf.FileDescriptorSet"
