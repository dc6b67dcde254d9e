"""The thread between bus and server: takes what the bus enqueued, feeds the state, says the status.

It stands apart from the web's event loop, so a stalled page or a slow request delays neither the
link's state nor the recorder, and it never waits for anything but its queue.
"""

import logging
import time
from collections.abc import Callable

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.boxes import BoundedQueue
from bumpless_server.live.freshness import stale_after_s
from bumpless_server.live.intake import Intake
from bumpless_server.live.sample import STATUS, Sample
from bumpless_server.live.state import State
from bumpless_server.live.worker import Worker

log = logging.getLogger(__name__)

MAX_ITEMS = 20_000
MAX_BYTES = 32_000_000
STATUS_PERIOD_S = 0.5

Item = Sample | bool  # a message, or the liveliness token's presence
LinkListener = Callable[[pb.LinkState], None]


class Dispatcher:
    """Single writer of a State; `intake` says what is taken.

    `status` builds a fresh ServerStatus, `on_link` hears each change of the link, `late` gets messages older
    than what is shown.
    """

    def __init__(
        self,
        state: State,
        status: Callable[[], pb.ServerStatus],
        on_link: LinkListener,
        intake: Intake,
        late: Callable[[Sample], None],
    ) -> None:
        self._state = state
        self._intake, self._late = intake, late
        self._status = status
        self._on_link = on_link
        self._queue: BoundedQueue[Item] = BoundedQueue(
            MAX_ITEMS,
            MAX_BYTES,
            size=lambda item: len(item.payload) if isinstance(item, Sample) else 0,
            keep=lambda item: isinstance(item, bool),
        )
        self._worker = Worker("dispatch", self._queue, self._handle, self._on_time, self._wait_s)
        self._link = state.link
        self._said: pb.ServerStatus | None = None
        self._next_status = 0.0

    def start(self) -> None:
        """Begin to work off the queue."""
        self._link = self._state.link
        self._worker.start()

    def stop(self) -> None:
        """Work off what is queued and end."""
        self._worker.stop()

    def sample(self, sample: Sample) -> None:
        """Enqueue a message; callable from any thread, never waits."""
        self._queue.put(sample)

    def alive(self, alive: bool) -> None:
        """Enqueue that the liveliness token appeared or went."""
        self._queue.put(alive)

    @property
    def dropped(self) -> int:
        """Messages lost because this thread was not given time to run."""
        return self._queue.dropped

    def _handle(self, item: Item) -> None:
        if isinstance(item, bool):
            self._state.set_alive(item)
            self._note_link()
        elif not item.from_vehicle:
            self._state.feed(item)
        else:
            try:
                self._take(item)
            except Exception:  # one odd message must not end the thread that hears all others
                log.exception("a message on %s could not be taken in", item.topic)

    def _take(self, sample: Sample) -> None:
        message = self._intake.take(sample)
        if message is None:
            return
        if not self._intake.is_in_order(sample, message):
            self._late(sample)
            return
        if isinstance(message, pb.VehicleDescription):
            self._state.set_stale_after(stale_after_s(message.control_period_s))
        self._state.feed(sample)

    def _on_time(self) -> None:
        self._note_link()
        self._say_status()

    def _wait_s(self) -> float:
        waits = [self._next_status - time.monotonic(), self._state.next_link_change_s()]
        return max(0.0, min(wait for wait in waits if wait is not None))

    def _note_link(self) -> None:
        now = self._state.link
        if now != self._link:
            self._link = now
            self._on_link(now)

    def _say_status(self) -> None:
        """Feed a ServerStatus each half second, and at once when something but time and age changed."""
        status = self._status()
        now = time.monotonic()
        if self._said is not None and now < self._next_status and _same(status, self._said):
            return
        self._said = status
        self._next_status = now + STATUS_PERIOD_S
        payload = status.SerializeToString()
        self._state.feed(Sample(STATUS, status.DESCRIPTOR.full_name, payload, from_vehicle=False))


def _same(one: pb.ServerStatus, other: pb.ServerStatus) -> bool:
    """Equal in all that is worth a message of its own."""
    return all(
        getattr(one, name) == getattr(other, name)
        for name in (
            "link",
            "recording",
            "recording_run_id",
            "recorder_trouble",
            "node_restarts",
            "stream_clients",
            "bus_notice",
        )
    )
