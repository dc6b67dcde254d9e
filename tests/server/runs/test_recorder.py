"""The recorder against a disk that is slow, full or gone: it loses old messages, counts them, and goes on."""

import threading
from itertools import pairwise
from pathlib import Path

import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless.runs import writer
from bumpless.runs.mcap_file import McapFile
from bumpless.runs.read import log_messages
from bumpless.runs.summary import summarise
from bumpless_server.live.sample import Sample
from bumpless_server.runs.disk_budget import DiskBudget
from bumpless_server.runs.recorder import Recorder
from tests.server.runs.clock import Clock


def sample(topic: str, cycle: int, **fields) -> Sample:
    message = TOPICS[topic].message(**fields)
    message.stamp.time_ns, message.stamp.cycle = 10**18 + cycle * 50_000_000, cycle  # type: ignore[attr-defined]
    schema = TOPICS[topic].schema
    return Sample(f"tlm/{topic}", schema, message.SerializeToString(), 10**18 + cycle * 50_000_000)


def status(cycle: int, phase: int, run: str = "run-1", elapsed: float = 0.0, reason: str = "") -> Sample:
    return sample("mission", cycle, phase=phase, run_id=run, elapsed_s=elapsed, end_reason=reason)


class Disk:
    """A recorder on a folder, and what it said and closed."""

    def __init__(self, folder: Path, queue_messages: int = 1000, budget: DiskBudget | None = None) -> None:
        self.folder, self.said, self.closed = folder, [], []
        self.file_closed, self.told = threading.Event(), threading.Event()
        self.recorder = Recorder(folder, self._say, self._close, queue_messages=queue_messages, budget=budget)
        self.recorder.start()

    def _say(self, _severity: int, code: str, _text: str, _details: dict) -> None:
        self.said.append(code)
        self.told.set()

    def _close(self, path: Path) -> None:
        self.closed.append(path)
        self.file_closed.set()

    def finished(self) -> list:
        self.recorder.stop()
        return [summarise(path) for path in self.closed]


def test_an_overflowing_queue_drops_the_oldest_counts_them_and_keeps_begin_and_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """While the disk hangs, memory is bounded; when it returns, the run still has its end."""
    hangs, returns = threading.Event(), threading.Event()

    class Hanging(McapFile):
        def flush(self) -> None:
            hangs.set()
            assert returns.wait(30)
            super().flush()

    monkeypatch.setattr(writer, "McapFile", Hanging)
    disk = Disk(tmp_path, queue_messages=50)
    disk.recorder.offer(status(1, pb.MISSION_PHASE_RUNNING))
    assert hangs.wait(30)
    for cycle in range(2, 502):
        disk.recorder.offer(sample("navigation", cycle))
    disk.recorder.offer(status(502, pb.MISSION_PHASE_COMPLETED, reason="done"))
    for cycle in range(502, 602):
        disk.recorder.offer(sample("navigation", cycle))
    assert disk.recorder.dropped == 550
    returns.set()
    (run,) = disk.finished()
    assert (run.state, run.end_reason, run.dropped) == ("complete", "done", 550)


def test_a_failing_disk_is_told_and_the_next_run_is_recorded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A full disk ends one file, not the recorder."""

    class Full(McapFile):
        def message(self, topic: str, *rest) -> None:
            if topic == "tlm/navigation":
                raise OSError(28, "No space left on device")
            super().message(topic, *rest)

    monkeypatch.setattr(writer, "McapFile", Full)
    disk = Disk(tmp_path)
    disk.recorder.offer(status(1, pb.MISSION_PHASE_RUNNING))
    for topic in ("description", "parameters", "plan"):  # then the file begins
        disk.recorder.offer(sample(topic, 1))
    disk.recorder.offer(sample("navigation", 2))
    assert disk.file_closed.wait(30)
    disk.recorder.offer(status(5, pb.MISSION_PHASE_RUNNING, "run-2"))
    disk.recorder.offer(status(9, pb.MISSION_PHASE_COMPLETED, "run-2"))
    runs = {run.id: run.state for run in disk.finished()}
    assert disk.said == ["recorder_failed"]
    assert runs == {"run-1": "interrupted", "run-2": "complete"}


def test_cycles_around_begin_and_end_belong_to_the_run_by_their_number(tmp_path: Path) -> None:
    """A status may come before or after the other words of its cycle; what counts is the cycle."""
    disk = Disk(tmp_path)
    for cycle in (8, 9, 10):  # flown from cycle 9, told with cycle 10
        disk.recorder.offer(sample("navigation", cycle))
    disk.recorder.offer(status(10, pb.MISSION_PHASE_RUNNING, elapsed=0.05))
    disk.recorder.offer(status(11, pb.MISSION_PHASE_COMPLETED))
    disk.recorder.offer(sample("navigation", 11))
    disk.recorder.offer(sample("navigation", 12))
    disk.finished()
    cycles = [
        pb.Navigation.FromString(record.data).stamp.cycle
        for _, record in log_messages(disk.closed[0], {"tlm/navigation"})
    ]
    assert cycles == [9, 10, 11]


def test_the_same_run_heard_again_becomes_a_second_part(tmp_path: Path) -> None:
    """A link that comes back, or a restarted server, never writes over what is there."""
    disk = Disk(tmp_path)
    disk.recorder.offer(status(1, pb.MISSION_PHASE_RUNNING))
    disk.recorder.link_lost()
    disk.recorder.offer(status(50, pb.MISSION_PHASE_PAUSED, elapsed=2.5))
    disk.recorder.offer(status(60, pb.MISSION_PHASE_ABORTED, elapsed=3.0))
    first, second = disk.finished()
    assert (first.id, first.state) == ("run-1", "interrupted")
    assert (second.id, second.run_id, second.state) == ("run-1.2", "run-1", "complete")
    assert second.end_reason == "aborted"


def test_stopping_the_server_closes_the_run(tmp_path: Path) -> None:
    """A file is never left without its end by a stop that was asked for."""
    disk = Disk(tmp_path)
    disk.recorder.offer(status(1, pb.MISSION_PHASE_RUNNING))
    (run,) = disk.finished()
    assert (run.state, run.end_reason) == ("interrupted", "the server was stopped")


def test_a_disk_that_keeps_failing_is_tried_after_longer_and_longer_pauses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a full disk got a new file every five seconds for ever, and an alarm with each."""
    tries: list[float] = []

    class Full(McapFile):
        def flush(self) -> None:
            tries.append(clock.now)
            raise OSError(28, "No space left on device")

    clock = Clock(monkeypatch)
    monkeypatch.setattr(writer, "McapFile", Full)
    disk = Disk(tmp_path)
    worker = disk.recorder._worker
    for half_second in range(2400):  # twenty minutes of a vehicle saying that it flies
        clock.now = 1000.0 + 0.5 * half_second
        worker._handle(status(half_second, pb.MISSION_PHASE_RUNNING, elapsed=0.5 * half_second))
    pauses = [later - earlier for earlier, later in pairwise(tries)]
    assert pauses == [5, 10, 20, 40, 80, 160, 300, 300]
    assert disk.said == ["recorder_failed"]
    assert disk.recorder.trouble == "writing failed: [Errno 28] No space left on device"
    assert not list(tmp_path.iterdir())


def test_without_room_nothing_is_written_and_recording_goes_on_when_there_is_some(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: what is on the disk is left alone; the operator is told once, and again when all is well."""

    class Room(DiskBudget):
        there = False

        def lack(self) -> str:
            return "" if self.there else "runs take 20 MB of the 20 MB they may"

    clock, room = Clock(monkeypatch), Room(tmp_path)
    disk = Disk(tmp_path, budget=room)
    handle = disk.recorder._worker._handle
    for second in range(60):
        clock.now += 1.0
        handle(status(20 * second, pb.MISSION_PHASE_RUNNING, elapsed=float(second)))
    assert disk.said == ["no_room_to_record"] and not list(tmp_path.iterdir())
    assert disk.recorder.trouble == "runs take 20 MB of the 20 MB they may"
    room.there = True
    clock.now += 5.0
    handle(status(1300, pb.MISSION_PHASE_RUNNING, elapsed=65.0))
    assert disk.said == ["no_room_to_record", "recording_again"] and disk.recorder.trouble == ""
    room.there = False
    clock.now += 1.0
    disk.recorder._worker._on_time()
    assert disk.recorder.recording is None
    (run,) = disk.finished()
    assert (run.state, run.end_reason) == ("interrupted", "runs take 20 MB of the 20 MB they may")


def test_a_hold_after_the_mission_is_a_piece_of_its_own_one_cycle_a_second(tmp_path: Path) -> None:
    """Protects: after "Completed" thrusters ran on, unrecorded. The run has its end at once; the hold goes on
    until the vehicle is stopped, without filling the disk."""
    disk = Disk(tmp_path)
    offer = disk.recorder.offer
    offer(status(1, pb.MISSION_PHASE_RUNNING))
    for cycle in range(2, 42):
        offer(sample("navigation", cycle))
    offer(status(41, pb.MISSION_PHASE_COMPLETED, elapsed=2.0, reason="over"))
    for cycle in range(42, 442):
        offer(sample("navigation", cycle))
        if cycle % 10 == 0:
            offer(status(cycle, pb.MISSION_PHASE_COMPLETED, elapsed=2.0, reason="over"))
    offer(status(442, pb.MISSION_PHASE_ABORTED, elapsed=2.0, reason="stopped"))
    run, hold = disk.finished()
    assert (run.id, run.state, run.end_reason) == ("run-1", "complete", "over")
    assert (hold.id, hold.run_id, hold.state) == ("run-1.2", "run-1", "complete")
    kept = [r for _, r in log_messages(tmp_path / "run-1.2.mcap", {"tlm/navigation"})]
    whole = [r for _, r in log_messages(tmp_path / "run-1.mcap", {"tlm/navigation"})]
    assert len(whole) == 40 and 18 <= len(kept) <= 21
