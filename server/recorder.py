"""Records every run by itself: begins when the vehicle says RUNNING, ends when it says it has ended.

Works on its own thread behind a bounded queue. A slow disk fills the queue, which then drops its
oldest messages and counts them; the bus, the web and the vehicle never wait.
"""

import logging
import threading
import time
from collections import deque
from collections.abc import Callable
from pathlib import Path

from server.boxes import BoundedQueue
from server.run_file import RunFile
from server.run_summary import COMPLETE, INTERRUPTED
from server.sample import EVENT, Sample, stamp_of
from twin.contract import bumpless_pb2 as pb

log = logging.getLogger(__name__)

FLUSH_S = 1.0
PRE_ROLL = 1000  # messages kept while idle: a run's first cycles may precede its mission status
SETTLE_S = 0.5  # after the end, for the rest of the last cycle
RETRY_S = 5.0  # after a failing disk
MISSION = "tlm/mission"
CONTEXT = ("tlm/description", "tlm/parameters", "tlm/plan")
_ACTIVE = (pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED)
_REASONS = {pb.MISSION_PHASE_COMPLETED: "completed", pb.MISSION_PHASE_ABORTED: "aborted"}

Say = Callable[[pb.Severity, str, str, dict[str, str]], None]


class _LinkLost:
    """Marks the place in the queue where the vehicle was lost."""


class Recorder:
    """Writes runs into `folder`. `closed(path)` is called after each file's end, on this thread."""

    def __init__(
        self,
        folder: Path,
        version: str,
        say: Say,
        closed: Callable[[Path], None],
        queue_messages: int = 20_000,
        queue_bytes: int = 64_000_000,
    ) -> None:
        self._folder, self._version, self._say, self._closed = folder, version, say, closed
        self._queue: BoundedQueue[Sample | _LinkLost] = BoundedQueue(
            queue_messages,
            queue_bytes,
            size=lambda item: len(item.payload) if isinstance(item, Sample) else 0,
            keep=lambda item: isinstance(item, _LinkLost) or item.topic == MISSION,
        )
        self._context: dict[str, Sample] = {}
        self._recent: deque[Sample] = deque(maxlen=PRE_ROLL)
        self._run: RunFile | None = None
        self._dropped_before = 0
        self._end: tuple[pb.MissionStatus, float] | None = None  # last status and when to close
        self._flush_at = 0.0
        self._retry_at = 0.0
        self._thread = threading.Thread(target=self._work, name="recorder", daemon=True)

    def start(self) -> None:
        """Begin to listen for runs."""
        self._thread.start()

    def stop(self) -> None:
        """Write what is queued, close the file of a run still going on and end."""
        self._queue.close()
        if self._thread.is_alive():
            self._thread.join()

    def offer(self, sample: Sample) -> None:
        """Take in a message; callable from any thread, never waits."""
        if sample.from_vehicle:
            self._queue.put(sample)

    def link_lost(self) -> None:
        """The vehicle is gone: the run's file is closed."""
        self._queue.put(_LinkLost())

    @property
    def recording(self) -> RunFile | None:
        """The run being written now; read its id, path and flushed_bytes only."""
        return self._run

    @property
    def dropped(self) -> int:
        """Messages that the disk was too slow for, since the server's start."""
        return self._queue.dropped

    def _work(self) -> None:
        while not self._queue.closed:
            for item in self._queue.take(self._wait_s()):
                self._guard(self._handle, item)
            self._guard(self._on_time)
        self._guard(self._finish_ended)
        self._guard(self._finish, INTERRUPTED, "the server was stopped")

    def _guard(self, action: Callable[..., None], *arguments: object) -> None:
        """A failing disk ends a file, not the recorder."""
        try:
            action(*arguments)
        except Exception as error:
            log.exception("the recorder failed")
            run, self._end = self._run, None
            self._retry_at = time.monotonic() + RETRY_S
            name = "the run" if run is None else run.id
            self._say(pb.SEVERITY_ALARM, "recorder_failed", f"Recording of {name} failed: {error}", {})
            if run is not None:
                run.abandon()
                self._closed(run.path)
            self._run = None

    def _wait_s(self) -> float | None:
        if self._run is None:
            return None
        due = self._flush_at if self._end is None else min(self._flush_at, self._end[1])
        return max(0.0, due - time.monotonic())

    def _on_time(self) -> None:
        now = time.monotonic()
        if self._end is not None and now >= self._end[1]:
            self._finish_ended()
        if self._run is not None and now >= self._flush_at:
            self._run.flush()
            self._flush_at = now + FLUSH_S

    def _handle(self, item: Sample | _LinkLost) -> None:
        if isinstance(item, _LinkLost):
            if self._end is not None:
                self._finish_ended()
            self._finish(INTERRUPTED, "link to the vehicle lost")
            self._context.clear()
            self._recent.clear()
            return
        if self._end is not None and _cycle(item) > self._end[0].stamp.cycle:
            self._finish_ended()
        if item.topic in CONTEXT:
            self._context[item.topic] = item
        self._recent.append(item)
        status = item.decode() if item.topic == MISSION else None
        if isinstance(status, pb.MissionStatus) and self._on_status(status):
            return
        if self._run is not None:
            self._run.write(item)

    def _on_status(self, status: pb.MissionStatus) -> bool:
        """Begin or end a file as the vehicle says; True when the status itself was written by that."""
        run = self._run
        if status.phase in _ACTIVE and status.run_id:
            if run is not None and run.run_id == status.run_id:
                run.status = status
                return False
            self._finish(INTERRUPTED, f"run {status.run_id} began")
            if time.monotonic() >= self._retry_at:
                self._begin(status)
            return self._run is not None
        if run is not None and self._end is None:
            if status.run_id == run.run_id:
                run.status = status
            self._end = (status, time.monotonic() + SETTLE_S)
        return False

    def _begin(self, status: pb.MissionStatus) -> None:
        self._dropped_before = self._queue.dropped
        self._run = run = RunFile(self._folder, status, dict(self._context), self._version)
        for sample in self._recent:
            if sample.topic not in CONTEXT and self._belongs(sample, status):
                run.write(sample)
        self._flush_at = time.monotonic() + FLUSH_S
        log.info("recording %s", run.path)

    def _belongs(self, sample: Sample, status: pb.MissionStatus) -> bool:
        """Was this said in a cycle of the mission whose first heard status is `status`?"""
        stamp, period = stamp_of(sample.payload), self._period_s()
        slack = 0.25 * period if status.elapsed_s > 0 else 0.0  # cycles are paced, not exact
        began_ns = status.stamp.time_ns - round((status.elapsed_s + slack) * 1e9)
        first = status.stamp.cycle - round(status.elapsed_s / period)
        return stamp is not None and stamp.cycle >= first and stamp.time_ns >= began_ns

    def _finish_ended(self) -> None:
        if self._end is None:
            return
        status = self._end[0]
        state = COMPLETE if status.phase in _REASONS else INTERRUPTED
        self._finish(state, status.end_reason or _REASONS.get(status.phase, "the vehicle is idle"))

    def _finish(self, state: str, reason: str) -> None:
        run, self._end = self._run, None
        if run is None:
            return
        try:
            run.finish(state, reason, self._queue.dropped - self._dropped_before)
        finally:
            self._closed(run.path)
            self._run = None  # only now: a run is always either being recorded or in the catalogue
        log.info("closed %s (%s: %s)", run.path, state, reason)

    def _period_s(self) -> float:
        description = self._context.get("tlm/description")
        message = description.decode() if description else None
        period = message.control_period_s if isinstance(message, pb.VehicleDescription) else 0.0
        return period or 0.05


def _cycle(sample: Sample) -> int:
    """Control cycle a message belongs to; 0 when it does not say."""
    stamp = stamp_of(sample.payload) if sample.topic.startswith("tlm/") or sample.topic == EVENT else None
    return 0 if stamp is None else stamp.cycle
