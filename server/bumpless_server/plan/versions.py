"""Every saved version of a file with its time: bytes as they were, the newest so many of them."""

import hashlib
import re
import time
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from bumpless_server.data_dir import write_whole

MOST = 100
_STAMPED = re.compile(r"(\d{19})-([0-9a-f]{12})\.yaml")


@dataclass(frozen=True)
class Version:
    """One kept state of a file."""

    id: str  # part of an address
    saved: datetime
    size: int
    sha256: str


class Versions:
    """A folder with one folder of versions for each name."""

    def __init__(self, folder: Path, most: int = MOST) -> None:
        self._folder, self._most = folder, most

    def keep(self, name: str, data: bytes, time_ns: int | None = None) -> None:
        """Add a version, unless the newest one is the same; the oldest beyond the bound are forgotten."""
        sha, present = hashlib.sha256(data).hexdigest(), self._paths(name)
        if present and present[-1].stem.endswith(sha[:12]) and present[-1].read_bytes() == data:
            return
        newest = int(present[-1].stem[:19]) if present else 0
        stamp = max(time.time_ns() if time_ns is None else time_ns, newest + 1)  # a clock may step back
        folder = self._folder / name
        folder.mkdir(parents=True, exist_ok=True)
        write_whole(folder / f"{stamp:019d}-{sha[:12]}.yaml", data)
        for path in self._paths(name)[: -self._most]:
            path.unlink(missing_ok=True)

    def all(self, name: str) -> list[Version]:
        """The versions of a name, newest first."""
        return [_version(path) for path in reversed(self._paths(name))]

    def read(self, name: str, version: str) -> bytes | None:
        """The bytes of one version; None when there is none of that id."""
        path = self._folder / name / f"{version}.yaml"
        return path.read_bytes() if _STAMPED.fullmatch(path.name) and path.is_file() else None

    def rename(self, name: str, to: str) -> None:
        """Take a name's versions along to another name; what that one had before stays with it."""
        target = self._folder / to
        for path in self._paths(name):
            target.mkdir(parents=True, exist_ok=True)
            path.replace(target / path.name)

    def _paths(self, name: str) -> list[Path]:
        """Oldest first."""
        return sorted(p for p in (self._folder / name).glob("*.yaml") if _STAMPED.fullmatch(p.name))


def _version(path: Path) -> Version:
    data = path.read_bytes()
    saved = datetime.fromtimestamp(int(path.stem[:19]) // 1_000_000 * 1e-3, UTC)
    return Version(path.stem, saved, len(data), hashlib.sha256(data).hexdigest())
