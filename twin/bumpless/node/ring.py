"""The way out of the control loop: a ring of LOG rows that the loop fills without ever waiting."""

import threading
from collections import deque
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from bumpless.sim.events import TwinEvent
from bumpless.sim.log import LOG
from bumpless.telemetry import FlightState

CAPACITY = 256  # rows; 12.8 s at 20 Hz
EVENT_CAPACITY = 4096


class Cycle(NamedTuple):
    """What one control cycle left behind."""

    row: np.void  # a copy of the reader's own
    time_ns: int  # UNIX time
    state: FlightState
    number: int  # control cycles since the node started, from 0
    events: list[TwinEvent]


class Ring:
    """One writer, one reader. A reader that falls behind loses the oldest rows, counted in `dropped`.

    Events are few and matter more than rows: they survive the loss of their row. With `lossless` (only
    for virtual time) the writer waits for a free place instead.
    """

    def __init__(self, capacity: int = CAPACITY, lossless: bool = False) -> None:
        self._capacity = capacity
        self._rows = np.zeros(capacity, LOG)
        self._times = [0] * capacity
        self._states: list[FlightState | None] = [None] * capacity
        self._events: deque[tuple[int, TwinEvent]] = deque(maxlen=EVENT_CAPACITY)
        self._taken = np.zeros(1, LOG)
        self._head = 0  # rows ever put
        self._tail = 0  # rows ever taken or dropped
        self._places = threading.Semaphore(capacity) if lossless else None
        self._filled = threading.Lock()  # released: there is something to take
        self._filled.acquire()
        self._closed = False
        self.dropped = 0

    def put(self, row: np.void, time_ns: int, state: FlightState, events: list[TwinEvent]) -> None:
        """Copy a row in. Never blocks unless the ring is lossless."""
        if self._places is not None:
            self._places.acquire()
        at = self._head % self._capacity
        self._rows[at] = row
        self._times[at] = time_ns
        self._states[at] = state
        for one in events:
            self._events.append((self._head, one))
        self._head += 1
        self._wake()

    def close(self) -> None:
        """No more rows will come; called by the writer."""
        self._closed = True
        self._wake()

    def take_all(self, consume: Callable[[Cycle], None]) -> bool:
        """Wait for rows and hand over each of them; False when the ring is closed and empty.

        The `row` handed over is valid until the next one.
        """
        self._filled.acquire()
        while (cycle := self._take()) is not None:
            consume(cycle)
            if self._places is not None:
                self._places.release()
        return not (self._closed and self._tail == self._head)

    def _wake(self) -> None:
        if self._filled.locked():  # only the writer releases, so nobody can come in between
            self._filled.release()

    def _take(self) -> Cycle | None:
        while self._tail < self._head:
            if self._head - self._tail > self._capacity:
                self._drop(self._head - self._tail - self._capacity)
            at = self._tail % self._capacity
            self._taken[0] = self._rows[at]
            time_ns, state = self._times[at], self._states[at]
            if self._head - self._tail >= self._capacity and self._places is None:
                self._drop(1)  # the writer may have been writing into this very place
                continue
            events = []
            while self._events and self._events[0][0] <= self._tail:
                events.append(self._events.popleft()[1])
            number, self._tail = self._tail, self._tail + 1
            if state is not None:
                return Cycle(self._taken[0], time_ns, state, number, events)
        return None

    def _drop(self, count: int) -> None:
        self._tail += count
        self.dropped += count
