"""What a cut of the link swallowed is asked for afterwards; what nobody has any more is counted exactly."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager

import zenoh

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.messages import stamp_of
from bumpless.contract.session import session_config
from bumpless.node.publisher import BusWriter
from bumpless_server.live.bus import Bus
from bumpless_server.live.sample import Sample
from bumpless_server.live.speaker import Speaker
from bumpless_server.live.tally import Tally
from tests.node.cut import Cut, cuttable
from tests.ports import free_port
from tests.server.serving import PATIENCE_S


class Ear:
    """A server's bus and what it heard."""

    def __init__(self, endpoint: str) -> None:
        self.heard: list[Sample] = []
        self.alive: list[bool] = []
        self._changed = threading.Condition()
        self.tally = Tally()
        self.bus = Bus("ts100", (endpoint,), (), self._hear, self._live, Speaker(), self.tally)

    def _hear(self, sample: Sample) -> None:
        with self._changed:
            self.heard.append(sample)
            self._changed.notify_all()

    def _live(self, alive: bool) -> None:
        with self._changed:
            self.alive.append(alive)
            self._changed.notify_all()

    def until(self, true) -> None:
        with self._changed:
            assert self._changed.wait_for(true, PATIENCE_S), "it did not come"

    def cycles(self, topic: str) -> list[int]:
        stamps = [stamp_of(sample.payload) for sample in self.heard if sample.topic == topic]
        return [stamp.cycle for stamp in stamps if stamp is not None]


class Voice:
    """A vehicle that says navigation and events, numbered by cycle."""

    def __init__(self, session: zenoh.Session) -> None:
        self.writer, self.session = BusWriter(session, "ts100", wait=True), session
        self.token = session.liveliness().declare_token(keys.alive("ts100"))
        self.cycle = 0

    def say(self, cycles: int) -> None:
        for _ in range(cycles):
            stamp = pb.Stamp(time_ns=1 + self.cycle, cycle=self.cycle)
            self.writer.put("tlm/navigation", pb.Navigation(stamp=stamp))
            if self.cycle % 10 == 0:
                self.writer.put("event", pb.Event(stamp=stamp, code="counted"))
            self.cycle += 1


@contextmanager
def linked() -> Iterator[tuple[Ear, Voice, Cut]]:
    port = free_port()
    ear = Ear(f"tcp/127.0.0.1:{port}")
    ear.bus.open()
    try:
        with cuttable(port) as link:
            config = session_config("peer", [f"tcp/127.0.0.1:{link.port}"], timestamps=True)
            with zenoh.open(config) as session:
                voice = Voice(session)
                ear.until(lambda: ear.alive)
                yield ear, voice, link
    finally:
        ear.bus.close()


def test_a_cut_leaves_no_gap() -> None:
    """Protects: what a vehicle says while its link is cut must be in the log and on the screen, in order."""
    with linked() as (ear, voice, link):
        voice.say(20)
        ear.until(lambda: len(ear.cycles("tlm/navigation")) == 20)
        for _ in range(2):
            link.cut()
            ear.until(lambda: ear.alive[-1] is False)
            voice.say(300)
            link.join()
            ear.until(lambda: ear.alive[-1] is True)
            voice.say(20)
            ear.until(lambda: len(ear.cycles("tlm/navigation")) == voice.cycle)
            ear.until(lambda: len(ear.cycles("event")) == voice.cycle // 10)  # a topic of its own
        assert ear.cycles("tlm/navigation") == list(range(voice.cycle))
        assert ear.cycles("event") == list(range(0, voice.cycle, 10))
        assert ear.tally.of("missed") == 0


def test_what_is_lost_for_good_is_counted_exactly() -> None:
    """Protects: a gap that can't be filled must not look like a flight without one."""
    kept = round(keys.FILLED_S / 0.05)
    with linked() as (ear, voice, link):
        voice.say(10)
        ear.until(lambda: len(ear.cycles("tlm/navigation")) == 10)
        link.cut()
        ear.until(lambda: ear.alive[-1] is False)
        voice.say(kept + 500)
        link.join()
        ear.until(lambda: ear.alive[-1] is True)
        voice.say(10)
        ear.until(lambda: voice.cycle - 1 in ear.cycles("tlm/navigation"))
        heard = ear.cycles("tlm/navigation")
        assert heard == sorted(set(heard))
        assert ear.tally.of("missed") == voice.cycle - len(heard) > 0
