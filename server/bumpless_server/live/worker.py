"""A thread that works off a queue, and what is due meanwhile; whoever feeds it never waits."""

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

from bumpless_server.live.boxes import BoundedQueue

T = TypeVar("T")


class Worker(Generic[T]):
    """Hands each item of `queue` to `handle`; calls `on_time` after each lot, or after `wait_s()` without.

    All three run on this thread, and so does `at_end` when the queue has been closed and emptied.
    """

    def __init__(
        self,
        name: str,
        queue: BoundedQueue[T],
        handle: Callable[[T], None],
        on_time: Callable[[], None],
        wait_s: Callable[[], float | None],
        at_end: Callable[[], None] = lambda: None,
    ) -> None:
        self._queue, self._handle, self._on_time = queue, handle, on_time
        self._wait_s, self._at_end = wait_s, at_end
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        """Begin to work off the queue."""
        self._thread.start()

    def stop(self) -> None:
        """Work off what is queued and end."""
        self._queue.close()
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        while not self._queue.closed:
            for item in self._queue.take(self._wait_s()):
                self._handle(item)
            self._on_time()
        self._at_end()
