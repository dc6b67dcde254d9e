"""Saved sets of tunable parameters, one JSON file each: bumpless.Parameters with its proto names."""

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from bumpless_server.data_dir import write_whole
from bumpless_server.files import BadName, checked_name


class Presets:
    """Presets by name in one folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def all(self) -> list[dict[str, Any]]:
        """Every preset by name, its parameters included; files that are no JSON are left out."""
        presets = (self.get(path.stem) for path in sorted(self._folder.glob("*.json")))
        return [preset for preset in presets if preset is not None]

    def get(self, name: str) -> dict[str, Any] | None:
        """One preset, or None."""
        try:
            path = self._path(name)
            parameters = json.loads(path.read_text(encoding="utf-8"))
            modified = datetime.fromtimestamp(path.stat().st_mtime, UTC).isoformat(timespec="seconds")
        except (BadName, OSError, ValueError):
            return None
        return {"name": path.stem, "modified": modified, "parameters": parameters}

    def save(self, name: str, parameters: dict[str, Any]) -> None:
        """Keep or replace a preset. Raises BadName."""
        write_whole(self._path(name), json.dumps(parameters, indent=1).encode())

    def delete(self, name: str) -> bool:
        """Remove a preset; False when there is none."""
        try:
            self._path(name).unlink()
        except (BadName, FileNotFoundError):
            return False
        return True

    def _path(self, name: str) -> Path:
        return self._folder / f"{checked_name(name, '.json')}.json"
