"""Who asked the vehicle for what, and what came of it: lines that are only ever added."""

import json
import logging
import os
import secrets
import threading
from collections import deque
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Protocol

log = logging.getLogger(__name__)

SHOWN = 1000  # of the newest lines
TAIL_BYTES = 2_000_000  # read for them


class Asked(Protocol):
    """What an audit's line needs of a command."""

    @property
    def id(self) -> str: ...
    @property
    def verb(self) -> str: ...
    @property
    def author(self) -> str: ...
    @property
    def address(self) -> str: ...
    @property
    def details(self) -> Mapping[str, object]: ...


class Answered(Protocol):
    """And of its answer."""

    @property
    def accepted(self) -> bool: ...


class Audit:
    """A file of JSON lines, brought to the disk with each. It is read again after a restart.

    A disk that takes no more does not stop a command: `trouble` says so, and the newest lines stay in memory.
    """

    def __init__(self, path: Path, heard: Callable[[dict[str, Any]], None] = lambda entry: None) -> None:
        self.path, self._heard = path, heard
        self.trouble = ""
        self._lock = threading.Lock()
        self._recent: deque[dict[str, Any]] = deque(maxlen=SHOWN)

    def open(self) -> None:
        """Read what was written before."""
        try:
            with self.path.open("rb") as file:
                size = file.seek(0, os.SEEK_END)
                file.seek(max(0, size - TAIL_BYTES))
                lines = file.read().splitlines()
        except OSError:
            return
        for line in lines[-SHOWN:]:
            try:
                entry = json.loads(line)
            except ValueError:  # the line that a power cut left half, or the tail's first
                continue
            if isinstance(entry, dict):
                self._recent.append(entry)

    def note(
        self,
        verb: str,
        author: str,
        address: str,
        details: Mapping[str, object],
        refused: str | None = None,
    ) -> None:
        """Note what was done here, without the vehicle: a log-in, a mission, a preset. `refused`: why not."""
        self._keep(
            {
                "id": secrets.token_urlsafe(12),
                "verb": verb,
                "author": author,
                "address": address,
                "details": dict(details),
                "answer": "accepted" if refused is None else "refused",
                "said": refused or "",
                "took_s": 0.0,
            }
        )

    def add(self, asked: Asked, answer: Answered | None, said: str, took_s: float) -> None:
        """Note one command. `answer` is None when the vehicle gave none."""
        self._keep(
            {
                "id": asked.id,
                "verb": asked.verb,
                "author": asked.author,
                "address": asked.address,
                "details": dict(asked.details),
                "answer": "none" if answer is None else ("accepted" if answer.accepted else "refused"),
                "said": said,
                "took_s": round(took_s, 3),
            }
        )

    def _keep(self, told: dict[str, Any]) -> None:
        entry = {"time": datetime.now(UTC).isoformat(timespec="milliseconds"), **told}
        self._heard(entry)
        with self._lock:
            self._recent.append(entry)
            try:
                self._write(json.dumps(entry))
                self.trouble = ""
            except OSError as error:
                if not self.trouble:
                    log.error("the audit cannot be written: %s", error)
                self.trouble = f"the audit cannot be written: {error.strerror or error}"

    def entries(self) -> list[dict[str, Any]]:
        """The newest lines, oldest first."""
        with self._lock:
            return list(self._recent)

    def _write(self, line: str) -> None:
        with self.path.open("ab") as file:
            if file.tell() and not self._ends_whole():
                file.write(b"\n")
            file.write(line.encode() + b"\n")
            file.flush()
            os.fsync(file.fileno())

    def _ends_whole(self) -> bool:
        with self.path.open("rb") as file:
            file.seek(-1, os.SEEK_END)
            return file.read() == b"\n"
