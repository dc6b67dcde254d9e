"""A thread that works off a short queue: who comes when it is full is told so at once."""

import threading
from collections.abc import Callable
from queue import Full, Queue
from typing import Generic, TypeVar

T = TypeVar("T")


class Lane(Generic[T]):
    """Hands each item to `work`, one after the other; at most `most` wait."""

    def __init__(self, name: str, most: int, work: Callable[[T], None]) -> None:
        self._waiting: Queue[T | None] = Queue(most)
        self._work = work
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        """Begin to work."""
        self._thread.start()

    def offer(self, item: T) -> bool:
        """Take in an item; False when too many wait already. Never blocks."""
        try:
            self._waiting.put_nowait(item)
        except Full:
            return False
        return True

    def close(self) -> None:
        """Work off what waits, then end."""
        self._waiting.put(None)
        self._thread.join()

    def _run(self) -> None:
        while (item := self._waiting.get()) is not None:
            self._work(item)
