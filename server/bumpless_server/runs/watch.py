"""Notices logs that somebody puts into the folder of runs while the server runs.

A file counts once it has stood still for one look: what is still being copied is left alone.
"""

import logging
import threading
from collections.abc import Callable
from pathlib import Path

from bumpless.runs.names import ENDING

log = logging.getLogger(__name__)

EVERY_S = 2.0
Seen = dict[str, tuple[int, int]]  # name: size and time of the last change


class FolderWatch(threading.Thread):
    """Calls `changed(names)` when files have come, gone or changed, and stand still since the look before."""

    def __init__(self, folder: Path, changed: Callable[[set[str]], None], every_s: float = EVERY_S) -> None:
        super().__init__(name="runs-watch", daemon=True)
        self._folder, self._changed, self._every_s = folder, changed, every_s
        self._stopping = threading.Event()
        self._known: Seen = {}  # as last told of
        self._before: Seen = {}  # at the last look

    def stop(self) -> None:
        """End the thread and wait for it."""
        self._stopping.set()
        if self.is_alive():
            self.join()

    def run(self) -> None:
        """Look now and then until stopped. What is there at the beginning is known."""
        self._known = self._before = self._seen()
        while not self._stopping.wait(self._every_s):
            self.look()

    def look(self) -> None:
        """One look."""
        now = self._seen()
        still = {name: mark for name, mark in now.items() if self._before.get(name) == mark}
        gone = self._known.keys() - now.keys()
        news = {name for name, mark in still.items() if self._known.get(name) != mark} | gone
        self._before = now
        if not news:
            return
        self._known = {name: mark for name, mark in self._known.items() if name in now} | still
        try:
            self._changed(news)
        except Exception:
            log.exception("the folder of runs has changed and could not be read")

    def _seen(self) -> Seen:
        found: Seen = {}
        for path in self._folder.glob(f"*{ENDING}"):
            try:
                state = path.stat()
            except OSError:
                continue
            found[path.name] = (state.st_size, state.st_mtime_ns)
        return found
