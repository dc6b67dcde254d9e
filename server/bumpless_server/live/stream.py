"""Fan-out to browsers: each has its own latest-wins buffer, so a slow one costs nobody else anything.

The dispatcher's thread fills the buffers and never waits; one task per browser empties its buffer at
no more than 25 frames a second. A browser that keeps up gets every message, also when a frame comes a little
late; what a frozen one has not read is bounded: a few messages per topic, the last events, and what the
socket's own buffer holds.
"""

import asyncio
import threading
import time
from collections import deque
from collections.abc import Awaitable, Callable

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.sample import EVENT, Sample
from bumpless_server.live.state import State

FRAME_PERIOD_S = 0.04
KEPT = 3  # messages of a topic that may wait: frames jitter, cycles shall not be lost for that
PAST_EVERY = 5  # control cycles: what a new browser's plots begin with is coarser, without gaps
PAST_FRAMES = 480  # two minutes at 20 Hz
PLOTTED = tuple(
    f"tlm/{topic}" for topic in ("navigation", "guidance", "supervisor", "control", "allocation", "actuators")
)
GATHER_S = 0.004  # the topics of one control cycle arrive within this time of each other
MAX_EVENTS = 500
EVENT_BYTES = 1_000_000  # of the events that wait for one browser


class ClientBuffer:
    """What one browser has not been sent yet: the newest few of each topic, every event."""

    def __init__(self, loop: asyncio.AbstractEventLoop, first: list[Sample]) -> None:
        self._loop = loop
        self._lock = threading.Lock()
        self._newest: dict[str, deque[Sample]] = {}
        self._events: deque[Sample] = deque()
        self._event_bytes = 0
        self._filled = asyncio.Event()
        self._woken = bool(first)
        if first:
            self._filled.set()
        self.replaced = 0  # messages that a newer one of their topic took the place of
        for sample in first:
            self._keep(sample)

    def offer(self, sample: Sample) -> None:
        """Take in a message; callable from any thread, never waits."""
        with self._lock:
            self._keep(sample)
            if self._woken:
                return
            self._woken = True
        try:
            self._loop.call_soon_threadsafe(self._filled.set)
        except RuntimeError:  # the loop has just ended
            return

    def take(self) -> list[Sample]:
        """All that waits: topics in order of arrival, events in between."""
        with self._lock:
            samples = [sample for kept in self._newest.values() for sample in kept]
            samples += self._events
            self._newest.clear()
            self._events.clear()
            self._event_bytes = 0
            self._filled.clear()
            self._woken = False
        return sorted(samples, key=lambda sample: sample.receive_ns)

    def _keep(self, sample: Sample) -> None:
        if sample.topic != EVENT:
            kept = self._newest.setdefault(sample.topic, deque(maxlen=KEPT))
            self.replaced += len(kept) == KEPT
            kept.append(sample)
            return
        self._events.append(sample)
        self._event_bytes += len(sample.payload)
        while len(self._events) > MAX_EVENTS or self._event_bytes > EVENT_BYTES:
            self._event_bytes -= len(self._events.popleft().payload)

    async def wait(self) -> None:
        """Until there is something to take."""
        await self._filled.wait()


def frame_of(samples: list[Sample], past: bool = False) -> bytes:
    """A StreamFrame with the samples' own bytes."""
    frame = pb.StreamFrame(server_time_ns=time.time_ns(), past=past)
    for sample in samples:
        frame.messages.add(
            topic=sample.topic,
            schema=sample.schema,
            payload=sample.payload,
            receive_time_ns=sample.receive_ns,
        )
    return frame.SerializeToString()


class Stream:
    """All connected browsers of one state."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._clients: tuple[ClientBuffer, ...] = ()
        self._lock = threading.Lock()
        self._cycles = 0
        self._past: deque[list[Sample]] = deque(maxlen=PAST_FRAMES)
        state.subscribe(self._offer)

    def __len__(self) -> int:
        return len(self._clients)

    def _offer(self, sample: Sample) -> None:
        if sample.topic == PLOTTED[-1]:
            self._remember()
        for client in self._clients:
            client.offer(sample)

    def _remember(self) -> None:
        """Keep one cycle's plotted messages now and then; on the dispatcher's thread."""
        self._cycles += 1
        if self._cycles % PAST_EVERY:
            return
        cycle = [self._state.sample(topic) for topic in PLOTTED]
        with self._lock:
            self._past.append([sample for sample in cycle if sample is not None])

    def past(self, after_ns: int = 0, before_ns: int | None = None) -> list[list[Sample]]:
        """Cycles of the last two minutes, oldest first, received between two server times."""
        with self._lock:
            return [
                cycle
                for cycle in self._past
                if cycle
                and cycle[0].receive_ns > after_ns
                and (before_ns is None or cycle[0].receive_ns < before_ns)
            ]

    def join(self) -> ClientBuffer:
        """A buffer for a new browser, holding the last value of every topic and the last events."""
        first = [*self._state.samples(), *self._state.events()]
        client = ClientBuffer(asyncio.get_running_loop(), first)
        with self._lock:
            self._clients = (*self._clients, client)
        return client

    def leave(self, client: ClientBuffer) -> None:
        """Forget a browser."""
        with self._lock:
            self._clients = tuple(other for other in self._clients if other is not client)

    async def serve(self, send: Callable[[bytes], Awaitable[None]]) -> None:
        """Send frames until `send` fails or this task is cancelled. A slow `send` slows only itself."""
        client = self.join()
        loop = asyncio.get_running_loop()
        try:
            for cycle in self.past():
                await send(frame_of(cycle, past=True))
            sent = loop.time() - FRAME_PERIOD_S
            told_ns, replaced = 0, 0
            while True:
                # after the news, not by a clock of our own: two clocks drift, and every drift costs a cycle
                await client.wait()
                await asyncio.sleep(max(GATHER_S, sent + FRAME_PERIOD_S - loop.time()))
                sent = loop.time()
                samples = client.take()
                paced = [sample.receive_ns for sample in samples if sample.topic == PLOTTED[0]]
                if client.replaced > replaced and paced and told_ns:
                    # it was late, or this process was: its plots are filled as a new browser's are
                    for cycle in self.past(told_ns, paced[0]):
                        await send(frame_of(cycle, past=True))
                replaced, told_ns = client.replaced, max([told_ns, *paced])
                if samples:
                    await send(frame_of(samples))
        finally:
            self.leave(client)
