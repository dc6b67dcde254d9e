"""Saved sets of tunable parameters, one JSON file each: bumpless.Parameters with its proto names."""

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from google.protobuf.json_format import ParseDict, ParseError

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.data_dir import write_whole
from bumpless_server.files import BadName, checked_name, why_no_file
from bumpless_server.live.tally import printable

MOST_BYTES = 1_000_000


class Presets:
    """Presets by name in one folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._left_out: dict[str, str] = {}

    def all(self) -> list[dict[str, Any]]:
        """Every preset by name, its parameters included; what can't be read is left out, see `left_out`."""
        found, left_out = [], {}
        for path in sorted(self._folder.glob("*.json")):
            try:
                reason = why_no_file(path, most_bytes=MOST_BYTES)
                if not reason:
                    found.append(self._read(path))
            except FileNotFoundError:
                continue
            except (OSError, ValueError, OverflowError, RecursionError, ParseError) as error:
                reason = str(error) or type(error).__name__
            if reason:
                left_out[printable(path.name)] = printable(reason)
        self._left_out = left_out
        return found

    def left_out(self) -> dict[str, str]:
        """Entries of the folder that are no presets, with the reason."""
        self.all()
        return dict(self._left_out)

    def get(self, name: str) -> dict[str, Any] | None:
        """One preset, or None."""
        try:
            path = self._path(name)
            return None if why_no_file(path, most_bytes=MOST_BYTES) else self._read(path)
        except (BadName, OSError, ValueError, OverflowError, RecursionError, ParseError):
            return None

    def _read(self, path: Path) -> dict[str, Any]:
        parameters = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(parameters, dict):
            raise ValueError("it holds no set of parameters")
        ParseDict(parameters, pb.Parameters(), ignore_unknown_fields=True)
        modified = datetime.fromtimestamp(path.stat().st_mtime, UTC).isoformat(timespec="seconds")
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
