"""A queue between threads that never grows beyond its bounds: it drops its oldest items and counts."""

import threading
from collections import deque
from collections.abc import Callable
from typing import Generic, TypeVar

T = TypeVar("T")

MAX_KEPT = 64


class BoundedQueue(Generic[T]):
    """First in, first out, bounded in items and bytes; `put` never waits.

    `keep` names items that carry decisions ("the run has ended") and are not lost when the queue
    overflows: the last 64 of them come out first, in order. They are older than all that is left.
    """

    def __init__(
        self,
        max_items: int,
        max_bytes: int,
        size: Callable[[T], int],
        keep: Callable[[T], bool] | None = None,
    ) -> None:
        self._max_items = max_items
        self._max_bytes = max_bytes
        self._size = size
        self._keep = keep or (lambda _item: False)
        self._items: deque[T] = deque()
        self._kept: deque[T] = deque(maxlen=MAX_KEPT)
        self._bytes = 0
        self._closed = False
        self._ready = threading.Condition()
        self.dropped = 0

    def put(self, item: T) -> None:
        """Add an item; when that overflows the queue, its oldest go."""
        with self._ready:
            self._items.append(item)
            self._bytes += self._size(item)
            while len(self._items) > 1 and (
                len(self._items) > self._max_items or self._bytes > self._max_bytes
            ):
                oldest = self._items.popleft()
                self._bytes -= self._size(oldest)
                if self._keep(oldest):
                    self._kept.append(oldest)
                else:
                    self.dropped += 1
            self._ready.notify()

    def take(self, timeout_s: float | None) -> list[T]:
        """All items there are, oldest first; waits for the first one at most `timeout_s`."""
        with self._ready:
            self._ready.wait_for(lambda: self._items or self._kept or self._closed, timeout_s)
            items = [*self._kept, *self._items]
            self._kept.clear()
            self._items.clear()
            self._bytes = 0
            return items

    def close(self) -> None:
        """Wake whoever waits; what is in the queue can still be taken."""
        with self._ready:
            self._closed = True
            self._ready.notify_all()

    @property
    def closed(self) -> bool:
        """True once closed and emptied: nothing more will come."""
        with self._ready:
            return self._closed and not self._items and not self._kept

    def __len__(self) -> int:
        with self._ready:
            return len(self._items) + len(self._kept)
