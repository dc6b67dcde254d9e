"""Rows to messages to the bus, on a thread that may wait as long as it likes."""

import gc
import math
import sys
import threading
import time

import zenoh
import zenoh.ext
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.ring import Cycle, Ring
from bumpless.telemetry import Teller

EVENT_CACHE = 200  # events a late joiner can still ask for
COLLECT_EVERY_NS = 1_000_000_000
# numbers alone: the next message tells of those that are missing
NUMBERED = zenoh.ext.MissDetectionConfig(heartbeat=None, sporadic_heartbeat=None)


class BusWriter:
    """One Zenoh publisher per topic. Telemetry is dropped under congestion, events wait for their place.

    What was said in the last `keys.FILLED_S` is kept and numbered, so that who misses some of it can ask.
    """

    def __init__(
        self, session: zenoh.Session, vehicle: str, wait: bool = False, period_s: float = 0.05
    ) -> None:
        congestion = zenoh.CongestionControl.BLOCK if wait else zenoh.CongestionControl.DROP
        self._topics: dict[str, zenoh.Publisher | zenoh.ext.AdvancedPublisher] = {
            f"tlm/{name}": _publisher(session, keys.telemetry(vehicle, name), topic, congestion, period_s)
            for name, topic in keys.TOPICS.items()
        }
        self._topics["truth/state"] = session.declare_publisher(
            keys.truth(vehicle), encoding=keys.encoding_of(pb.TruthState), congestion_control=congestion
        )
        self._topics["event"] = zenoh.ext.declare_advanced_publisher(
            session,
            keys.event(vehicle),
            encoding=keys.encoding_of(pb.Event),
            congestion_control=zenoh.CongestionControl.BLOCK,
            cache=zenoh.ext.CacheConfig(max_samples=EVENT_CACHE),
            sample_miss_detection=NUMBERED,
            publisher_detection=True,
        )

    def watch(self, joined: threading.Event) -> None:
        """Set `joined` whenever a first listener to the description appears."""
        publisher = self._topics["tlm/description"]
        assert isinstance(publisher, zenoh.Publisher)

        def changed(status: zenoh.MatchingStatus) -> None:
            if status.matching:
                joined.set()

        self._listener = publisher.declare_matching_listener(changed)

    def put(self, topic: str, message: Message) -> None:
        """Say one message. The same message always gives the same bytes."""
        self._topics[topic].put(message.SerializeToString(deterministic=True))


def _publisher(
    session: zenoh.Session, key: str, topic: keys.Topic, congestion: zenoh.CongestionControl, period_s: float
) -> "zenoh.Publisher | zenoh.ext.AdvancedPublisher":
    encoding = keys.encoding_of(topic.message)
    if not topic.filled:
        return session.declare_publisher(key, encoding=encoding, congestion_control=congestion)
    kept = max(2, math.ceil(keys.FILLED_S * topic.nominal_rate_hz(period_s)))
    return zenoh.ext.declare_advanced_publisher(
        session,
        key,
        encoding=encoding,
        congestion_control=congestion,
        cache=zenoh.ext.CacheConfig(max_samples=kept),
        sample_miss_detection=NUMBERED,
    )


class Publisher:
    """Empties the ring into the bus until the ring is closed."""

    def __init__(self, ring: Ring, teller: Teller, writer: BusWriter) -> None:
        self._ring = ring
        self._teller = teller
        self._writer = writer
        self._joined = threading.Event()
        self._collected = time.monotonic_ns()
        self._complained = False
        self._thread = threading.Thread(target=self._run, name="publisher", daemon=True)

    def start(self) -> None:
        """Begin to publish."""
        self._writer.watch(self._joined)
        self._thread.start()

    def join(self) -> None:
        """Wait until everything in the closed ring has been said."""
        self._thread.join()

    def _run(self) -> None:
        while self._ring.take_all(self._say):
            # The loop sleeps now for most of a period: the moment at which a collection disturbs least.
            if time.monotonic_ns() - self._collected > COLLECT_EVERY_NS:
                gc.collect()
                self._collected = time.monotonic_ns()

    def _say(self, cycle: Cycle) -> None:
        if self._joined.is_set():
            self._joined.clear()
            self._teller.repeat()
        try:
            told = self._teller.tell(cycle.row, cycle.state, cycle.events, cycle.time_ns, cycle.number)
            for topic, message in told:
                self._writer.put(topic, message)
        except Exception as fault:  # the vehicle flies on, heard or not
            if not self._complained:
                print(f"bumpless vehicle: cannot publish: {type(fault).__name__}: {fault}", file=sys.stderr)
                self._complained = True
