"""kill -9 of the recorder at random: how much of what it had heard is lost, and can the rest be read?

Each round forks a process that records a vehicle at 20 Hz with ten topics; it is killed at a random moment
between 1.2 s and 4 s. What it had been handed is told through a pipe before the recorder gets it.
"""

import os
import random
import signal
import struct
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from mcap.reader import make_reader

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless.runs.repair import repair
from bumpless_server.live.sample import Sample
from bumpless_server.runs.recorder import Recorder
from tests.trust.figure import Figure, at_most, exactly

PERIOD_S = 0.05
TOLD = struct.Struct("<Q")


def figures(count: int, seed: int = 12) -> Iterator[Figure]:
    """Kill it `count` times."""
    draw = random.Random(seed)
    lost, unread, headless = [], 0, 0
    for _ in range(count):
        with tempfile.TemporaryDirectory() as folder:
            told = _killed(Path(folder), draw.uniform(1.2, 4.0))
            (path,) = Path(folder).glob("*.mcap")
            try:
                repair(path)
                times = _read(path)
            except Exception:  # whatever the reader says: it counts
                unread += 1
                continue
            lost.append((told[-1] - times[-1]) * 1e-9)
            headless += times[0] - told[0] > 10**9
    yield exactly("recorder", f"files of {count} killed recorders that can't be read", unread, "", 0)
    yield at_most("recorder", "most that one lost", max(lost, default=99.0), "s", 1.0)
    yield exactly("recorder", "files without their first second", headless, "", 0)


def _killed(folder: Path, after_s: float) -> list[int]:
    """Record until killed; the times of all that the recorder was handed."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        try:
            _record(folder, writing)
        finally:
            os._exit(1)
    os.close(writing)
    told = b""
    until = time.monotonic() + after_s
    while time.monotonic() < until:
        told += os.read(reading, 4096)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    while more := os.read(reading, 65536):
        told += more
    os.close(reading)
    whole = len(told) - len(told) % TOLD.size
    return [at for (at,) in TOLD.iter_unpack(told[:whole])]


def _record(folder: Path, told: int) -> None:
    recorder = Recorder(folder, lambda *_: None, lambda _: None)
    recorder.start()
    for cycle in range(1, 10**6):
        time.sleep(PERIOD_S)
        now = time.time_ns()
        os.write(told, TOLD.pack(now))
        for name, topic in TOPICS.items():
            message = topic.message()
            if isinstance(message, pb.MissionStatus):
                message.phase, message.run_id = pb.MISSION_PHASE_RUNNING, "run-1"
                message.elapsed_s = cycle * PERIOD_S
            message.stamp.time_ns, message.stamp.cycle = now, cycle  # type: ignore[attr-defined]
            recorder.offer(Sample(f"tlm/{name}", topic.schema, message.SerializeToString(), now, session="a"))


def _read(path: Path) -> list[int]:
    """Log times by the official reader, check sums and order held against it."""
    with path.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        if reader.get_summary() is None:
            raise ValueError("no summary")
        times = [message.log_time for _, _, message in reader.iter_messages(log_time_order=False)]
    if times != sorted(times) or not times:
        raise ValueError("out of order")
    return times
