"""What was changed on the vehicle from this console, to read and to go back to: lines that are only added."""

import json
import logging
import threading
from collections import deque
from datetime import datetime
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

log = logging.getLogger(__name__)

KEPT = 200


class Revision(BaseModel):
    """One change that the vehicle accepted."""

    revision: int  # as the vehicle's node counted it
    session: str  # of that node: another one counts from the beginning
    at: datetime
    author: str
    reason: str
    changes: dict[str, list[Any]]  # path: [from, to]
    parameters: dict[str, Any]  # all that was set, as `PUT /api/parameters` takes it


class Revisions:
    """A file of JSON lines. A disk that takes no more costs the line its file, and nothing else."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._lock = threading.Lock()
        self._kept: deque[Revision] = deque(maxlen=KEPT)

    def open(self) -> None:
        """Read what was written before; a line that is none is passed over."""
        try:
            lines = self._path.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            return
        for line in lines[-KEPT:]:
            try:
                self._kept.append(Revision.model_validate_json(line))
            except ValidationError:
                log.warning("%s: a line is no revision", self._path.name)

    def add(self, revision: Revision) -> None:
        """Write one down."""
        line = json.dumps(revision.model_dump(mode="json"), ensure_ascii=False)
        with self._lock:
            self._kept.append(revision)
            try:
                with self._path.open("a", encoding="utf-8") as file:
                    file.write(line + "\n")
            except OSError:
                log.exception("%s cannot be written", self._path)

    def all(self) -> list[Revision]:
        """Newest first."""
        with self._lock:
            return list(reversed(self._kept))
