"""What people note of missions beside their files: tags, and whether one is put away.

They are the library's, not the mission's: a tag changes no bytes and so no hash.
"""

import json
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from bumpless_server.data_dir import write_whole


@dataclass(frozen=True)
class Mark:
    """Of one mission."""

    tags: tuple[str, ...] = ()
    archived: bool = False


class Marks:
    """All marks, in one JSON file; one that cannot be read counts as empty, for missions matter more."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def of(self, name: str) -> Mark:
        """The mark of one mission."""
        return self._read().get(name, Mark())

    def all(self) -> dict[str, Mark]:
        """Every mark that says anything, by name."""
        return self._read()

    def set(self, name: str, **changes: Any) -> Mark:
        """Change a mission's mark."""
        found = self._read()
        found[name] = replace(found.get(name, Mark()), **changes)
        self._write(found)
        return found[name]

    def move(self, name: str, to: str | None) -> None:
        """Take a mark along to another name; None: forget it."""
        found = self._read()
        mark = found.pop(name, None)
        if to is not None and mark is not None:
            found[to] = mark
        self._write(found)

    def _read(self) -> dict[str, Mark]:
        try:
            told = json.loads(self._path.read_bytes())
            return {
                str(name): Mark(tuple(map(str, one.get("tags", ()))), bool(one.get("archived", False)))
                for name, one in told.items()
            }
        except (OSError, ValueError, AttributeError, TypeError):
            return {}

    def _write(self, marks: dict[str, Mark]) -> None:
        kept = {name: asdict(mark) for name, mark in sorted(marks.items()) if mark != Mark()}
        write_whole(self._path, json.dumps(kept, indent=1, ensure_ascii=False).encode())
