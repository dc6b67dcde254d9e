"""Records every run by itself: begins when the vehicle says RUNNING, ends when it says it has ended.

A vehicle that holds station after its mission still moves its actuators: that goes on in a file of its own,
one cycle a second, until it is told to stop or to fly again.

Works on its own thread behind a bounded queue. A slow disk fills the queue, which then drops its
oldest messages and counts them; the bus, the web and the vehicle never wait. A disk without room is not
written to, and one that fails is tried again after longer and longer pauses; the operator is told of both.
"""

import logging
import time
from collections import deque
from collections.abc import Callable, Sequence
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import COMPLETED, FLYING
from bumpless.contract.keys import FILLED_S, TOPICS
from bumpless.contract.messages import stamp_of
from bumpless.contract.names import RUN
from bumpless.runs.info import elapsed_ns, ending_of
from bumpless.runs.names import COMPLETE, CONTEXT, DESCRIPTION, ENDING, EVENT, INTERRUPTED, MISSION, PLAN
from bumpless.runs.pieces import piece_name
from bumpless.runs.view import View
from bumpless.runs.writer import Beside, RunWriter
from bumpless_server.live.boxes import BoundedQueue
from bumpless_server.live.sample import Sample
from bumpless_server.live.told import Say
from bumpless_server.live.worker import Worker
from bumpless_server.runs.disk_budget import DiskBudget

log = logging.getLogger(__name__)

FLUSH_S = 0.5
PRE_ROLL = 1000  # messages kept while idle: a run's first cycles may precede its mission status
PRE_ROLL_BYTES = 4_000_000
MOST_DEEDS, DEEDS_NS = 50, 10_000_000_000  # of the audit, kept for a run that begins within ten seconds
HELD_EVERY_S = 1.0  # of a hold after a mission one cycle is kept in so long
SETTLE_S = 0.5  # after the end, for the rest of the last cycle
RETRY_S = 5.0  # after a disk without room, and the first time after a failing one
MAX_RETRY_S = 300.0  # each try may leave a part of the run behind: twice as long each time, up to this

LOST = "link to the vehicle lost"


class _LinkLost:
    """Marks the place in the queue where the vehicle was lost."""


class Recorder:
    """Writes runs into `folder`. `closed(path)` is called after each file's end, on this thread.

    `views()` makes the converters for one run; `depths` finds the depth grid that its plan names.
    """

    def __init__(
        self,
        folder: Path,
        say: Say,
        closed: Callable[[Path], None],
        views: Callable[[], Sequence[View]] = tuple,
        queue_messages: int = 20_000,
        queue_bytes: int = 64_000_000,
        budget: DiskBudget | None = None,
        patience_s: float = FILLED_S,
        depths: Beside = lambda plan: None,
    ) -> None:
        self._folder, self._say, self._closed, self._views = folder, say, closed, views
        self._depths = depths
        self._queue: BoundedQueue[Sample | _LinkLost] = BoundedQueue(
            queue_messages,
            queue_bytes,
            size=lambda item: len(item.payload) if isinstance(item, Sample) else 0,
            keep=lambda item: isinstance(item, _LinkLost) or item.topic == MISSION,
        )
        self._context: dict[str, Sample] = {}
        self._recent: deque[Sample] = deque()
        self._recent_bytes = 0
        self._deeds: deque[Sample] = deque(maxlen=MOST_DEEDS)  # of the audit
        self._speaker = ""  # the session whose run is recorded
        self._run: RunWriter | None = None
        self._dropped_before = 0
        self._end: tuple[pb.MissionStatus, float] | None = None  # last status and when to close
        self._flush_at = 0.0
        self._patience_s = patience_s  # for a lost vehicle, which may come back with what was missed
        self._lost_until: float | None = None
        self._holds = False  # what is recorded is a hold after a mission
        self._budget = budget or DiskBudget(folder)
        self._lack = ""  # of room on the disk
        self._failure = ""  # of the last write
        self._told: set[tuple[str, str]] = set()  # what was said of which run
        self._tried = ""  # the run that was recorded last, or should have been
        self._retry_at = 0.0
        self._retry_s = RETRY_S
        self._worker = Worker(
            "recorder",
            self._queue,
            lambda item: self._guard(self._handle, item),
            lambda: self._guard(self._on_time),
            self._wait_s,
            self._close,
        )

    def start(self) -> None:
        """Begin to listen for runs."""
        self._worker.start()

    def stop(self) -> None:
        """Write what is queued, close the file of a run still going on and end."""
        self._worker.stop()

    def offer(self, sample: Sample) -> None:
        """Take in a message; callable from any thread, never waits."""
        if sample.from_vehicle:
            self._queue.put(sample)

    def note(self, sample: Sample) -> None:
        """Take in what was done here, for the log of a run that goes on or begins just now."""
        self._queue.put(sample)

    def link_lost(self) -> None:
        """The vehicle is gone: the run's file waits for it for a while and is closed then."""
        self._queue.put(_LinkLost())

    @property
    def recording(self) -> RunWriter | None:
        """The run being written now; read its id, path and flushed_bytes only."""
        return self._run

    @property
    def trouble(self) -> str:
        """Why a run is not or would not be recorded, for the operator; "" when all is well."""
        return self._failure or self._lack

    @property
    def dropped(self) -> int:
        """Messages that the disk was too slow for, since the server's start."""
        return self._queue.dropped

    def _close(self) -> None:
        self._guard(self._finish_ended)
        self._guard(self._finish, INTERRUPTED, "the server was stopped")

    def _guard(self, action: Callable[..., None], *arguments: object) -> None:
        """A failing disk ends a file, not the recorder."""
        try:
            action(*arguments)
        except Exception as error:
            log.exception("the recorder failed")
            run, self._end = self._run, None
            self._failure = f"writing failed: {error}"
            self._retry_at = time.monotonic() + self._retry_s
            self._retry_s = min(2 * self._retry_s, MAX_RETRY_S)
            self._complain("recorder_failed", self._tried)
            if run is not None:
                run.abandon()
                if run.path.exists():
                    self._closed(run.path)
            self._run = None

    def _complain(self, code: str, run_id: str) -> None:
        """Say once of each run why it is not recorded, and of none why it would not be."""
        if (code, run_id) in self._told:
            return
        self._told.add((code, run_id))
        severity = pb.SEVERITY_ALARM if run_id else pb.SEVERITY_WARNING
        what = f"Run {run_id} is not being recorded" if run_id else "Runs cannot be recorded"
        self._say(severity, code, f"{what}: {self.trouble}", {"run": run_id})

    def _has_room(self, run_id: str) -> bool:
        """Is there room for this run, or for any ("")?"""
        self._lack = self._budget.lack()
        if self._lack:
            self._retry_at = time.monotonic() + RETRY_S
            self._complain("no_room_to_record", run_id)
        return not self._lack

    def _wait_s(self) -> float | None:
        if self._run is None:
            return None
        ends = (self._flush_at, self._end and self._end[1], self._lost_until)
        return max(0.0, min(due for due in ends if due is not None) - time.monotonic())

    def _on_time(self) -> None:
        now = time.monotonic()
        if self._end is not None and now >= self._end[1]:
            self._finish_ended()
        if self._lost_until is not None and now >= self._lost_until:
            self._finish(INTERRUPTED, LOST)
        if self._run is not None and now >= self._flush_at:
            self._run.flush()
            self._flush_at, self._failure = now + FLUSH_S, ""
            if self._end is None and not self._has_room(self._run.run_id):
                self._finish(INTERRUPTED, self._lack)

    def _handle(self, item: Sample | _LinkLost) -> None:
        if isinstance(item, Sample) and not item.from_vehicle:
            self._deeds.append(item)
            if self._run is not None:
                self._write(item)
            return
        if isinstance(item, _LinkLost):
            if self._end is not None:
                self._finish_ended()
            if self._run is not None and self._speaker:
                self._lost_until = time.monotonic() + self._patience_s
            else:  # nobody will know whether it is the same vehicle that comes back
                self._finish(INTERRUPTED, LOST)
            self._forget()
            return
        if self._run is not None and item.session != self._speaker:
            # the file ends as nobody's success: what the other says belongs to its own run
            self._end = None
            lost = self._lost_until is not None
            self._finish(INTERRUPTED, LOST if lost else "another session speaks for the vehicle")
            self._forget()
        self._lost_until = None
        if item.topic == MISSION and self._is_after_end(item):
            self._finish_ended()
        if item.topic in CONTEXT:
            self._context[item.topic] = item
        self._remember(item)
        status = item.decode() if item.topic == MISSION else None
        if isinstance(status, pb.MissionStatus) and self._on_status(status, item):
            return
        if self._run is not None and not self._is_after_end(item) and not self._passed_over(item):
            self._write(item)

    def _is_after_end(self, item: Sample) -> bool:
        """Whether this is of a later cycle than the run's last, of which some may still be on their way."""
        return self._end is not None and _cycle(item) > self._end[0].stamp.cycle

    def _passed_over(self, item: Sample) -> bool:
        """Whether this is one of the many like cycles of a hold."""
        name = item.topic.removeprefix("tlm/")
        per_cycle = name in TOPICS and TOPICS[name].rate_hz is None
        every = max(1, round(HELD_EVERY_S / self._period_s()))
        return self._holds and per_cycle and _cycle(item) % every != 0

    def _remember(self, item: Sample) -> None:
        self._recent.append(item)
        self._recent_bytes += len(item.payload)
        while len(self._recent) > PRE_ROLL or self._recent_bytes > PRE_ROLL_BYTES:
            self._recent_bytes -= len(self._recent.popleft().payload)

    def _forget(self) -> None:
        self._context.clear()
        self._recent.clear()
        self._recent_bytes = 0

    def _on_status(self, status: pb.MissionStatus, told: Sample) -> bool:
        """Begin or end a file as the vehicle says; True when the status itself was written by that."""
        run = self._run
        if status.phase in FLYING and status.run_id:
            if run is not None and run.run_id == status.run_id:
                run.status = status
                return False
            self._finish(COMPLETE if self._holds else INTERRUPTED, f"run {status.run_id} began")
            if status.run_id != self._tried or time.monotonic() >= self._retry_at:
                self._tried = status.run_id
                if self._has_room(status.run_id):
                    self._begin(status, told)
            return self._run is not None
        if self._holds and run is not None and status.phase == COMPLETED and status.run_id == run.run_id:
            run.status = status
            return False
        if run is None and status.phase == COMPLETED and status.run_id and time.monotonic() >= self._retry_at:
            if self._has_room(status.run_id):
                self._begin(status, told, holds=True)
            return self._run is not None
        if run is None and time.monotonic() >= self._retry_at:
            self._retry_at = time.monotonic() + RETRY_S
            self._has_room("")
        elif run is not None and self._end is None:
            if status.run_id == run.run_id:
                run.status = status
            self._end = (status, time.monotonic() + SETTLE_S)
        return False

    def _begin(self, status: pb.MissionStatus, told: Sample, holds: bool = False) -> None:
        self._holds = holds
        self._dropped_before = self._queue.dropped
        self._speaker = told.session
        name = free_id(self._folder, status.run_id)
        self._run = run = RunWriter(
            self._folder / f"{name}{ENDING}", status, name, self._views(), depths=self._depths
        )
        # by our clock, which all log times are told by; the vehicle's own may be hours off
        began_ns = told.receive_ns - elapsed_ns(status)
        for sample in self._context.values():
            if not _is_other_plan(sample, status):
                self._write(sample, max(sample.receive_ns, began_ns))
        for sample in self._recent:
            if not holds and sample.topic not in CONTEXT and self._belongs(sample, status):
                self._write(sample)
        for sample in self._deeds:  # the command that began it was answered before it began
            if sample.receive_ns >= began_ns - DEEDS_NS:
                self._write(sample, max(sample.receive_ns, began_ns))
        self._flush_at = time.monotonic() + FLUSH_S
        if any(run_id == status.run_id for _, run_id in self._told):
            what = f"Run {status.run_id} is being recorded again, as {run.id}"
            self._say(pb.SEVERITY_INFO, "recording_again", what, {"run": run.id})
        log.info("recording %s", run.path)

    def _write(self, sample: Sample, log_ns: int | None = None) -> None:
        assert self._run is not None
        at = sample.receive_ns if log_ns is None else log_ns
        self._run.write(sample.topic, sample.schema, sample.payload, at)

    def _belongs(self, sample: Sample, status: pb.MissionStatus) -> bool:
        """Was this said in a cycle of the mission whose first heard status is `status`?"""
        stamp, period = stamp_of(sample.payload), self._period_s()
        flown_ns = elapsed_ns(status)
        slack_ns = round(0.25e9 * period) if flown_ns else 0  # cycles are paced, not exact
        began_ns = status.stamp.time_ns - flown_ns - slack_ns
        first = status.stamp.cycle - round(flown_ns * 1e-9 / period)
        return stamp is not None and stamp.cycle >= first and stamp.time_ns >= began_ns

    def _finish_ended(self) -> None:
        if self._end is None:
            return
        self._finish(*ending_of(self._end[0]))

    def _finish(self, state: str, reason: str) -> None:
        run, self._end, self._lost_until = self._run, None, None
        if run is None:
            return
        try:
            run.finish(state, reason, self._queue.dropped - self._dropped_before)
            if state == COMPLETE:
                self._retry_s, self._failure = RETRY_S, ""
                self._told.clear()
        finally:
            self._closed(run.path)
            self._run = None  # only now: a run is always either being recorded or in the catalogue
        log.info("closed %s (%s: %s)", run.path, state, reason)
        if run.outcome is not None:
            told = run.outcome
            self._say(told.severity, told.code, told.text, {**told.details, "run": run.id})

    def _period_s(self) -> float:
        description = self._context.get(DESCRIPTION)
        message = description.decode() if description else None
        period = message.control_period_s if isinstance(message, pb.VehicleDescription) else 0.0
        return period or 0.05


def free_id(folder: Path, run_id: str) -> str:
    """`run_id`, or `run_id.2`, `.3` ... when an earlier part of the same run is there already."""
    name, part = RUN.check(run_id, "run id"), 1
    while (folder / f"{name}{ENDING}").exists():
        part += 1
        name = piece_name(run_id, part)
    return name


def _is_other_plan(sample: Sample, status: pb.MissionStatus) -> bool:
    plan = sample.decode() if sample.topic == PLAN else None
    return isinstance(plan, pb.Plan) and plan.sha256 != status.mission_sha256


def _cycle(sample: Sample) -> int:
    """Control cycle a message belongs to; 0 when it does not say."""
    stamp = stamp_of(sample.payload) if sample.topic.startswith("tlm/") or sample.topic == EVENT else None
    return 0 if stamp is None else stamp.cycle
