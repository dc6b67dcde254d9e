"""Deleted missions, until they are restored or the bin is full."""

import re
import time
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from bumpless_server.data_dir import write_whole

MOST = 200
_BINNED = re.compile(r"(\d{19})-(.+)\.yaml")


@dataclass(frozen=True)
class Binned:
    """One deleted mission."""

    id: str  # part of an address
    name: str
    deleted: datetime
    size: int


class Bin:
    """A folder of deleted files, the newest `most` of them."""

    def __init__(self, folder: Path, most: int = MOST) -> None:
        self._folder, self._most = folder, most

    def put(self, name: str, data: bytes) -> Binned:
        """Keep a file that is being deleted."""
        newest = max((int(one.id[:19]) for one in self.all()), default=0)
        path = self._folder / f"{max(time.time_ns(), newest + 1):019d}-{name}.yaml"
        write_whole(path, data)
        for old in self.all()[self._most :]:
            self.forget(old.id)
        return _binned(path)

    def all(self) -> list[Binned]:
        """What was deleted, newest first."""
        found = [_binned(p) for p in self._folder.glob("*.yaml") if _BINNED.fullmatch(p.name)]
        return sorted(found, key=lambda one: one.id, reverse=True)

    def read(self, binned: str) -> tuple[str, bytes] | None:
        """(name, bytes) of one; None when there is none of that id."""
        found, path = _BINNED.fullmatch(f"{binned}.yaml"), self._folder / f"{binned}.yaml"
        if found is None or path.parent != self._folder or not path.is_file():
            return None
        return found.group(2), path.read_bytes()

    def forget(self, binned: str) -> None:
        """Remove one for good."""
        if self.read(binned) is not None:
            (self._folder / f"{binned}.yaml").unlink(missing_ok=True)


def _binned(path: Path) -> Binned:
    deleted = datetime.fromtimestamp(int(path.stem[:19]) // 1_000_000 * 1e-3, UTC)
    return Binned(path.stem, path.stem[20:], deleted, path.stat().st_size)
