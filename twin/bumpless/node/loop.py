"""The control loop: one thread that wakes at each deadline, flies one cycle and passes its row on."""

import threading
import time
from collections.abc import Callable
from queue import Empty, SimpleQueue

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import MOVING, RUNNING
from bumpless.node.flight import Flight
from bumpless.node.histogram import Histogram
from bumpless.node.pacing import Clock
from bumpless.node.priority import raise_thread
from bumpless.node.ring import Ring


class Handoff:
    """A checked request on its way to the loop, and the reply on its way back.

    Whoever claims it first decides: the loop applies it, or the waiting side withdraws it. So a refusal
    for silence can never be followed by the command being carried out after all.
    """

    def __init__(self, verb: str, apply: Callable[[Flight], pb.CommandReply]) -> None:
        self._verb = verb
        self._apply = apply
        self._claim = threading.Lock()
        self._done = threading.Event()
        self._reply = pb.CommandReply()

    def run(self, flight: Flight) -> None:
        """On the loop, between two cycles."""
        if self._claim.acquire(blocking=False):
            try:
                self._reply = self._apply(flight)
            except Exception as fault:  # one bad request must not stop the vehicle
                self._reply = flight.refuse(self._verb, f"{type(fault).__name__}: {fault}")
            self._done.set()

    def reply(self, timeout_s: float) -> pb.CommandReply:
        """Wait for the loop's answer, elsewhere than on the loop."""
        if not self._done.wait(timeout_s) and self._claim.acquire(blocking=False):
            return pb.CommandReply(reason=f"the control loop did not answer within {timeout_s:g} s")
        self._done.wait()
        return self._reply


class ControlLoop:
    """Paces `flight` by `clock` and puts every row into `ring`. It waits for nothing but its deadline."""

    def __init__(self, flight: Flight, clock: Clock, ring: Ring) -> None:
        self.lateness = Histogram()  # from deadline to start of the cycle
        self.cycle_time = Histogram()  # of a cycle's work
        self.cycles = 0
        self.fault: Exception | None = None  # why it ended by itself
        self._flight = flight
        self._clock = clock
        self._ring = ring
        self._inbox: SimpleQueue[Handoff] = SimpleQueue()
        self._stop_reason = ""

    @property
    def missed(self) -> int:
        """Deadlines that passed without a cycle."""
        return self._clock.missed

    def submit(self, handoff: Handoff) -> Handoff:
        """Have it applied before the next cycle."""
        self._inbox.put(handoff)
        return handoff

    def stop(self, reason: str) -> None:
        """End after the next cycle, in which a mission being flown is aborted for this reason."""
        self._stop_reason = reason

    def run(self, on_end: Callable[[], None]) -> None:
        """The thread's body; calls `on_end` however it ends."""
        raise_thread()
        try:
            self._clock.start()
            while not self._stop_reason:
                self._cycle()
            if self._flight.twin.phase in MOVING:
                self._flight.abort(self._stop_reason)
                self._cycle()
        except Exception as fault:  # reported by the main thread, which ends the process
            self.fault = fault
        finally:
            self._ring.close()
            on_end()

    def _cycle(self) -> None:
        flight, clock = self._flight, self._clock
        late = clock.wait(hurry=flight.twin.phase == RUNNING)
        began = time.monotonic_ns()
        while not self._inbox.empty():
            try:
                self._inbox.get_nowait().run(flight)
            except Empty:
                break
        row, happened = flight.step()
        self._ring.put(row, clock.time_ns(), flight.state, happened)
        self.lateness.add(late)
        self.cycle_time.add(time.monotonic_ns() - began)
        self.cycles += 1
