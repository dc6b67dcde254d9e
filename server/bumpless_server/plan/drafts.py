"""Work in progress, saved by itself: any text, valid or not, so that a reload or a crash costs nothing."""

import hashlib
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from bumpless_server.data_dir import write_whole
from bumpless_server.files import checked_name

MOST = 200


@dataclass(frozen=True)
class Draft:
    """A text that differs from the mission of its name, or has none yet."""

    name: str
    saved: datetime
    data: bytes

    @property
    def sha256(self) -> str:
        """Hash of its bytes."""
        return hashlib.sha256(self.data).hexdigest()


class TooManyDrafts(Exception):
    """Some have to be saved or dropped first."""


class Drafts:
    """A folder with one draft for each name."""

    def __init__(self, folder: Path, most: int = MOST) -> None:
        self._folder, self._most = folder, most

    def put(self, name: str, data: bytes) -> Draft:
        """Keep a draft in place of the one before. Raises BadName or TooManyDrafts."""
        path = self._path(name)
        if not path.exists() and len(list(self._folder.glob("*.yaml"))) >= self._most:
            raise TooManyDrafts(f"there are {self._most} drafts; save or drop some first")
        write_whole(path, data)
        return _draft(path)

    def get(self, name: str) -> Draft | None:
        """The draft of a name, or None. Raises BadName."""
        path = self._path(name)
        return _draft(path) if path.is_file() else None

    def drop(self, name: str) -> bool:
        """Forget a draft; False when there is none. Raises BadName."""
        path, there = self._path(name), self._path(name).is_file()
        path.unlink(missing_ok=True)
        return there

    def all(self) -> list[Draft]:
        """Every draft by name."""
        return [_draft(path) for path in sorted(self._folder.glob("*.yaml")) if path.name[0] != "."]

    def _path(self, name: str) -> Path:
        return self._folder / f"{checked_name(name, '.yaml', '.yml')}.yaml"


def _draft(path: Path) -> Draft:
    saved = datetime.fromtimestamp(path.stat().st_mtime_ns // 1_000_000 * 1e-3, UTC)
    return Draft(path.stem, saved, path.read_bytes())
