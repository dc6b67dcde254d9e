"""What the recorder writes is true whatever clocks, links and other speakers do meanwhile."""

from itertools import pairwise
from pathlib import Path

import pytest
from mcap.reader import make_reader

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless.runs.summary import summarise
from bumpless_server.live.sample import Sample
from bumpless_server.runs.recorder import Recorder
from tests.server.runs.clock import Clock

NOW_NS = 1_800_000_000_000_000_000
HOUR_NS = 3_600 * 10**9


class Bench:
    """A recorder on a folder, fed by hand; the vehicle's clock is off by `offset_ns`."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, offset_ns: int = 0) -> None:
        self.clock, self.offset_ns = Clock(monkeypatch), offset_ns
        self.closed: list[Path] = []
        self.recorder = Recorder(folder, lambda *_: None, self.closed.append)

    def hear(self, topic: str, cycle: int, session: str = "a", at_ns: int | None = None, **fields) -> None:
        at_ns = NOW_NS + cycle * 50_000_000 if at_ns is None else at_ns
        message = TOPICS[topic].message(**fields)
        message.stamp.time_ns, message.stamp.cycle = at_ns + self.offset_ns, cycle  # type: ignore[attr-defined]
        payload = message.SerializeToString()
        sample = Sample(f"tlm/{topic}", TOPICS[topic].schema, payload, at_ns, session=session)
        self.recorder._worker._handle(sample)

    def status(self, cycle: int, phase: int, elapsed: float = 0.0, **more) -> None:
        self.hear("mission", cycle, phase=phase, run_id="run-1", elapsed_s=elapsed, **more)

    def times(self) -> list[int]:
        with self.closed[-1].open("rb") as file:
            return [m.log_time for _, _, m in make_reader(file).iter_messages(log_time_order=False)]


@pytest.mark.parametrize("offset_ns", [HOUR_NS, -HOUR_NS, 10 * 365 * 24 * HOUR_NS])
def test_log_times_are_the_servers_and_go_one_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, offset_ns: int
) -> None:
    """Protects: a vehicle's clock an hour off, or a reconnect, made 4,756 errors of the official doctor."""
    bench = Bench(tmp_path, monkeypatch, offset_ns)
    for topic in ("description", "parameters", "plan"):
        bench.hear(topic, 1, at_ns=NOW_NS - HOUR_NS)  # heard long before, kept as context
    for cycle in range(10, 14):
        bench.hear("navigation", cycle)
    bench.status(12, pb.MISSION_PHASE_RUNNING, elapsed=0.1)
    for cycle in (15, 14, 16):
        bench.hear("navigation", cycle)
    bench.hear("navigation", 17, at_ns=NOW_NS - 5 * 10**9)  # the server's clock was set back
    bench.status(18, pb.MISSION_PHASE_COMPLETED, elapsed=0.4)
    bench.recorder._close()
    times = bench.times()
    assert len(times) > 8
    assert all(before <= after for before, after in pairwise(times))
    assert NOW_NS - 10**9 < times[0] and times[-1] < NOW_NS + 10**9


def test_an_ousted_nodes_run_is_not_listed_as_complete(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a flight that another node took over is no success of the first, and gets no end from it."""
    bench = Bench(tmp_path, monkeypatch)
    bench.status(1, pb.MISSION_PHASE_RUNNING)
    bench.hear("navigation", 2)
    bench.hear("mission", 3, session="b", phase=pb.MISSION_PHASE_COMPLETED, run_id="run-1")
    bench.recorder._close()
    run = summarise(bench.closed[0])
    assert (run.state, run.end_reason) == ("interrupted", "another session speaks for the vehicle")
