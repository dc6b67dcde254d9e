"""Flights that are being looked at: a few stay open, the one not looked at for longest is closed."""

import threading
from collections import OrderedDict
from collections.abc import Sequence
from pathlib import Path

from bumpless.runs.flight_replay import FlightReplay

KEPT = 6


class Replays:
    """Opens logs as they are asked for. Usable from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._open: OrderedDict[tuple[tuple[Path, int, int], ...], FlightReplay] = OrderedDict()

    def of(self, pieces: Sequence[Path]) -> FlightReplay:
        """The flight in these files as they are now. Raises bumpless.runs.replay.NoReplay."""
        key = tuple((path, found.st_mtime_ns, found.st_size) for path in pieces for found in [path.stat()])
        with self._lock:
            replay = self._open.pop(key, None) or FlightReplay(pieces)
            self._open[key] = replay
            while len(self._open) > KEPT:
                self._open.popitem(last=False)[1].close()
            return replay

    def close(self) -> None:
        """Close all."""
        with self._lock:
            while self._open:
                self._open.popitem()[1].close()
