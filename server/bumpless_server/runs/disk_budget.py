"""How much of the disk runs may take: asked before a run is recorded, and with each flush while it is.

Without room nothing is recorded, and the operator is told. Runs are deleted only where the settings say so,
and then for the budget of runs alone: what else fills the disk is not made up for with runs.
"""

import contextlib
import shutil
from collections.abc import Callable
from pathlib import Path

from bumpless.runs.names import ENDING

Prune = Callable[[], bool]  # deletes the oldest complete run; False when there is none


def _never() -> bool:
    return False


class DiskBudget:
    """Room for runs in `folder`. 0 bytes: no such limit."""

    def __init__(
        self, folder: Path, max_bytes: int = 0, min_free_bytes: int = 0, prune: Prune = _never
    ) -> None:
        self._folder, self._prune = folder, prune
        self._max_bytes, self._min_free_bytes = max_bytes, min_free_bytes

    def lack(self) -> str:
        """Why there is no room; "" when there is. Prunes first, where it may."""
        free = shutil.disk_usage(self._folder).free
        if free < self._min_free_bytes:
            return f"{_mb(free)} are free on the disk, fewer than {_mb(self._min_free_bytes)}"
        while self._max_bytes and (taken := self._taken()) >= self._max_bytes:
            if not self._prune():
                return f"runs take {_mb(taken)} of the {_mb(self._max_bytes)} they may"
        return ""

    def _taken(self) -> int:
        taken = 0
        for path in self._folder.glob(f"*{ENDING}"):
            with contextlib.suppress(OSError):  # a link to itself, a file that has just gone
                taken += path.stat().st_size
        return taken


def _mb(count: int) -> str:
    return f"{count * 1e-6:.1f} MB" if count < 10_000_000 else f"{count * 1e-6:.0f} MB"
