"""The thread that hears everything, keeps the book of alarms and tells the browsers of each change."""

import logging
import math
import shutil
import threading
import time
from collections.abc import Callable
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.alarms.book import Alarm, Book
from bumpless_server.alarms.conditions import Conditions
from bumpless_server.alarms.limits import Limits
from bumpless_server.live.boxes import BoundedQueue
from bumpless_server.live.sample import ALARMS, Sample
from bumpless_server.live.worker import Worker

log = logging.getLogger(__name__)

WATCHED = frozenset(
    {"event", "server/status"}
    | {
        f"tlm/{topic}"
        for topic in (
            "description",
            "parameters",
            "navigation",
            "guidance",
            "supervisor",
            "control",
            "actuators",
        )
    }
)


class Watch:
    """`offer` takes every sample and never waits; `feed` is given what is to be told."""

    def __init__(
        self, limits: Callable[[], Limits], path: Path, feed: Callable[[Sample], None], disk: Path
    ) -> None:
        self._read_limits, self._path, self._feed, self._disk = limits, path, feed, disk
        self.limits = Limits()  # those in force; read at the start
        self._queue: BoundedQueue[Sample] = BoundedQueue(
            4000,
            16_000_000,
            size=lambda sample: len(sample.payload),
            keep=lambda sample: sample.topic == "event",
        )
        self._worker = Worker("alarms", self._queue, self._handle, self._on_time, lambda: None)
        self._lock = threading.Lock()
        self._book = Book()
        self._conditions: Conditions | None = None
        self._news = True

    def start(self) -> None:
        """Read what is kept and begin to listen."""
        self._book = Book(self._path)
        self.limits = self._read_limits()
        self._conditions = Conditions(self.limits, self._free_bytes)
        self._tell()
        self._worker.start()

    def _free_bytes(self) -> float:
        try:
            return shutil.disk_usage(self._disk).free
        except OSError:
            return math.inf  # what cannot be asked is for the recorder to find out

    def stop(self) -> None:
        """End; what is open is kept for the next start."""
        self._worker.stop()

    def offer(self, sample: Sample) -> None:
        """Take in a sample; callable from any thread."""
        if sample.topic in WATCHED:
            self._queue.put(sample)

    def acknowledge(self, alarm_id: str, by: str) -> bool:
        """Somebody has seen an alarm."""
        with self._lock:
            done = self._book.acknowledge(alarm_id, by, time.time_ns())
        self._tell()
        return done

    def shelve(self, alarm_id: str, seconds: float, by: str) -> bool:
        """Keep an alarm out of the way for a time."""
        with self._lock:
            done = self._book.shelve(alarm_id, time.time_ns() + round(seconds * 1e9), by)
        self._tell()
        return done

    def open(self) -> list[Alarm]:
        """Those not over."""
        with self._lock:
            return self._book.open()

    def history(self) -> list[Alarm]:
        """Those that are over, newest first."""
        with self._lock:
            return self._book.history()

    def _handle(self, sample: Sample) -> None:
        message = sample.decode()
        if message is None or self._conditions is None:
            return
        try:
            with self._lock:
                for code, cause in self._conditions.hear(sample.topic, message, sample.receive_ns):
                    if cause is None:
                        self._news |= self._book.return_(code, sample.receive_ns)
                    else:
                        self._news |= self._book.raise_(code, *cause, sample.receive_ns)
        except Exception:
            log.exception("an alarm could not be judged")

    def _on_time(self) -> None:
        if self._news:
            self._tell()

    def _tell(self) -> None:
        with self._lock:
            self._news = False
            told = pb.Alarms(alarms=[alarm.message() for alarm in self._book.open()])
        self._feed(Sample(ALARMS, told.DESCRIPTOR.full_name, told.SerializeToString(), from_vehicle=False))
