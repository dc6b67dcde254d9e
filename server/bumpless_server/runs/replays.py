"""Logs that are being looked at: a few stay open, the one not looked at for longest is closed."""

import threading
from collections import OrderedDict
from pathlib import Path

from bumpless.runs.replay import Replay

KEPT = 6


class Replays:
    """Opens logs as they are asked for. Usable from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._open: OrderedDict[tuple[Path, int, int], Replay] = OrderedDict()

    def of(self, path: Path) -> Replay:
        """The log at `path` as it is now. Raises bumpless.runs.replay.NoReplay."""
        found = path.stat()
        key = (path, found.st_mtime_ns, found.st_size)
        with self._lock:
            replay = self._open.pop(key, None) or Replay(path)
            self._open[key] = replay
            while len(self._open) > KEPT:
                self._open.popitem(last=False)[1].close()
            return replay

    def close(self) -> None:
        """Close all."""
        with self._lock:
            while self._open:
                self._open.popitem()[1].close()
