"""The last value of every topic, with its age: what the scene, the stream and the routes read.

One thread (live.dispatch) writes; any thread reads. Listeners are called on the writing thread and
must only enqueue: a listener that blocks would hold up every other one.
"""

import logging
import threading
import time
from collections import deque
from collections.abc import Callable

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.link import Link
from bumpless_server.live.sample import EVENT, Sample, telemetry_topic

log = logging.getLogger(__name__)

EVENT_HISTORY = 500
EVENT_BYTES = 2_000_000  # of all of them together
Listener = Callable[[Sample], None]


class State:
    """What the server knows of one vehicle.

    Topics are "tlm/<name>" (or just "<name>"), "event" and "server/status".
    """

    def __init__(self, vehicle_id: str) -> None:
        self.vehicle_id = vehicle_id
        self._lock = threading.Lock()
        self._last: dict[str, Sample] = {}
        self._decoded: dict[str, tuple[Sample, Message | None]] = {}
        self._events: deque[Sample] = deque()
        self._event_bytes = 0
        self._listeners: tuple[Listener, ...] = ()
        self._link = Link()
        self._lost_s = 0.0

    def latest(self, topic: str) -> Message | None:
        """The newest message of a topic, decoded once and shared: do not change it. None before the first."""
        topic = telemetry_topic(topic)
        with self._lock:
            sample = self._last.get(topic)
            cached = self._decoded.get(topic)
        if sample is None:
            return None
        if cached is not None and cached[0] is sample:
            return cached[1]
        message = sample.decode()
        with self._lock:
            self._decoded[topic] = (sample, message)
        return message

    def sample(self, topic: str) -> Sample | None:
        """The newest message of a topic as bytes."""
        with self._lock:
            return self._last.get(telemetry_topic(topic))

    def samples(self) -> list[Sample]:
        """The newest message of every topic but events."""
        with self._lock:
            return list(self._last.values())

    def events(self) -> list[Sample]:
        """The last events, oldest first."""
        with self._lock:
            return list(self._events)

    def age_s(self, topic: str) -> float:
        """Seconds since the newest message of a topic arrived; infinite when there was none."""
        sample = self.sample(topic)
        return float("inf") if sample is None else max(0.0, time.monotonic() - sample.received_s)

    @property
    def link(self) -> pb.LinkState:
        """WAITING, LIVE, STALE or LOST at this instant."""
        with self._lock:
            return self._link.state(time.monotonic())

    @property
    def telemetry_age_s(self) -> float:
        """Seconds since any telemetry arrived; infinite when there was none."""
        with self._lock:
            return self._link.age_s(time.monotonic())

    def next_link_change_s(self) -> float | None:
        """Seconds until silence alone would change `link`; None when only a message can."""
        with self._lock:
            return self._link.next_change_s(time.monotonic())

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Call `listener(sample)` for each message, on the dispatcher's thread; returns how to stop it."""
        with self._lock:
            self._listeners = (*self._listeners, listener)

        def unsubscribe() -> None:
            with self._lock:
                self._listeners = tuple(other for other in self._listeners if other is not listener)

        return unsubscribe

    def feed(self, sample: Sample) -> None:
        """Take in one message and hand it to every listener."""
        with self._lock:
            if sample.topic == EVENT:
                self._keep_event(sample)
            else:
                self._last[sample.topic] = sample
            if sample.from_vehicle and sample.topic != EVENT:
                self._link.heard(time.monotonic())
            listeners = self._listeners
        self._tell(listeners, sample)

    @staticmethod
    def _tell(listeners: tuple[Listener, ...], sample: Sample) -> None:
        for listener in listeners:
            try:
                listener(sample)
            except Exception:
                log.exception("a listener failed on %s", sample.topic)

    def set_stale_after(self, seconds: float) -> None:
        """How long this vehicle may be silent before it is late."""
        with self._lock:
            self._link.stale_after_s = seconds

    def _keep_event(self, sample: Sample) -> None:
        self._events.append(sample)
        self._event_bytes += len(sample.payload)
        while len(self._events) > EVENT_HISTORY or self._event_bytes > EVENT_BYTES:
            self._event_bytes -= len(self._events.popleft().payload)

    def set_alive(self, alive: bool) -> None:
        """The liveliness token appeared or went. A returning vehicle's older values are forgotten."""
        with self._lock:
            if not alive and self._link.alive:
                self._lost_s = time.monotonic()
            if alive and not self._link.alive and self._lost_s:
                for topic, sample in list(self._last.items()):
                    if sample.from_vehicle and sample.received_s <= self._lost_s:
                        del self._last[topic]
            self._link.token(alive)
