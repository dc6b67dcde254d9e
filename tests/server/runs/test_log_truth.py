"""What the recorder writes is true whatever clocks, links and other speakers do meanwhile."""

from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from mcap.reader import make_reader

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import FILLED_S, TOPICS
from bumpless.runs.summary import summarise
from bumpless_server.live.sample import Sample
from bumpless_server.runs.recorder import Recorder, _LinkLost
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

    def status(self, cycle: int, phase: Any, elapsed: float = 0.0, **more) -> None:
        self.hear("mission", cycle, phase=phase, run_id="run-1", elapsed_s=elapsed, **more)

    def lose(self) -> None:
        self.recorder._worker._handle(_LinkLost())

    def wait(self, seconds: float) -> None:
        self.clock.now += seconds
        self.recorder._worker._on_time()

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


def test_a_cut_of_the_link_cuts_no_log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: one flight whose link was cut for a while is one file, with what came late in its place."""
    bench = Bench(tmp_path, monkeypatch)
    bench.status(1, pb.MISSION_PHASE_RUNNING)
    bench.hear("navigation", 2)
    bench.lose()
    bench.wait(FILLED_S / 2)
    for cycle in (3, 4, 5):
        bench.hear("navigation", cycle, at_ns=NOW_NS + 30 * 10**9)
    bench.wait(FILLED_S)
    assert bench.closed == []
    bench.status(6, pb.MISSION_PHASE_COMPLETED, elapsed=0.3, end_reason="done")
    bench.recorder._close()
    (path,) = bench.closed
    assert summarise(path).state == "complete"
    with path.open("rb") as file:
        cycles = [
            pb.Navigation.FromString(m.data).stamp.cycle
            for _, channel, m in make_reader(file).iter_messages()
            if channel.topic == "tlm/navigation"
        ]
    assert cycles == [2, 3, 4, 5]


def test_who_stays_away_ends_the_log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: a vehicle that is lost for good leaves a closed log, and so does one that starts anew."""
    bench = Bench(tmp_path, monkeypatch)
    bench.status(1, pb.MISSION_PHASE_RUNNING)
    bench.lose()
    bench.wait(FILLED_S + 1.0)
    assert summarise(bench.closed[0]).end_reason == "link to the vehicle lost"
    bench.status(2, pb.MISSION_PHASE_RUNNING)
    bench.lose()
    bench.status(1, pb.MISSION_PHASE_RUNNING, session="b")
    assert summarise(bench.closed[1]).end_reason == "link to the vehicle lost"
    bench.recorder._close()


@pytest.mark.parametrize("elapsed", [float("nan"), float("inf"), -1e300, 1e300])
def test_a_mission_time_that_is_none_ends_no_recording(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, elapsed: float
) -> None:
    """Protects: a vehicle that says NaN for its mission's time was not recorded at all."""
    bench = Bench(tmp_path, monkeypatch)
    bench.hear("navigation", 1)
    bench.status(1, pb.MISSION_PHASE_RUNNING, elapsed=elapsed)
    bench.hear("navigation", 2)
    bench.status(3, pb.MISSION_PHASE_COMPLETED, elapsed=elapsed, end_reason="done")
    bench.recorder._close()
    run = summarise(bench.closed[0])
    assert (run.state, run.end_reason) == ("complete", "done") and run.started_ns > 0
    assert bench.recorder.trouble == ""
