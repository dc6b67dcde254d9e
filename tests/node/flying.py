"""A control loop whose every cycle a test permits, and requests to hand to it."""

import threading
from pathlib import Path

from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.node.commands import Commander
from bumpless.node.flight import Flight
from bumpless.node.loop import ControlLoop, Handoff
from bumpless.node.ring import Cycle, Ring
from tests.node.light import LightTwin

MISSIONS = Path(__file__).parents[2] / "missions"
START_NS = 1_800_000_000_000_000_000


class GatedClock:
    """`fly(n)` lets n cycles through and returns when they are over; each takes a period."""

    def __init__(self) -> None:
        self.missed = 0
        self._changed = threading.Condition()
        self._permitted = 0
        self._at_gate = False
        self._cycles = 0

    def start(self) -> None:
        pass

    def allow(self, cycles: int = 1) -> None:
        with self._changed:
            self._permitted += cycles
            self._changed.notify_all()

    def fly(self, cycles: int = 1) -> None:
        self.allow(cycles)
        with self._changed:
            assert self._changed.wait_for(lambda: self._at_gate and not self._permitted, timeout=60)

    def wait(self, hurry: bool = False) -> int:
        with self._changed:
            self._at_gate = True
            self._changed.notify_all()
            self._changed.wait_for(lambda: self._permitted > 0)
            self._permitted -= 1
            self._at_gate = False
        self._cycles += 1
        return 1000 * self._cycles

    def time_ns(self) -> int:
        return START_NS + self._cycles * 50_000_000


class Flying:
    """A light vehicle on a gated loop with a commander, without any bus."""

    def __init__(self, capacity: int = 256) -> None:
        self.vehicle = load_vehicle("ts100")
        self.twin = LightTwin(self.vehicle)
        self.clock = GatedClock()
        self.ring = Ring(capacity)
        self.flight = Flight(self.twin)
        self.loop = ControlLoop(self.flight, self.clock, self.ring)  # pyright: ignore[reportArgumentType]
        self.stopped: list[str] = []
        self.commander = Commander(
            "ts100", self.vehicle, self.flight, self.loop, self.clock.time_ns, self.stopped.append
        )
        self.ended = threading.Event()
        self._thread = threading.Thread(target=self.loop.run, args=(self.ended.set,))
        self._thread.start()
        self.submit = self.loop.submit
        self.loop.submit = self._submit_and_fly  # whoever asks gets the cycle that answers

    def _submit_and_fly(self, handoff: Handoff) -> Handoff:
        self.submit(handoff)
        self.clock.fly()
        return handoff

    def ask(self, verb: str, request: bytes = b"") -> pb.CommandReply:
        """The reply to a request; the cycle that carried it out is over."""
        return self.commander.answer(verb, request)

    def start(self, name: str = "docking.yaml", text: str | None = None) -> pb.CommandReply:
        """Ask for a mission of the missions folder, or of `text`."""
        yaml = (MISSIONS / name).read_text() if text is None else text
        return self.ask("start", pb.StartMission(file_name=name, mission_yaml=yaml).SerializeToString())

    def end(self) -> list[Cycle]:
        """Stop the loop; every cycle that is still in the ring, rows copied."""
        self.loop.stop("test over")
        self.clock.allow(2)
        self._thread.join()
        cycles: list[Cycle] = []
        self.ring.take_all(lambda cycle: cycles.append(cycle._replace(row=cycle.row.copy())))
        return cycles
