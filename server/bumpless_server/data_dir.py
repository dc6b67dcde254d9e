"""The folder that holds what the server keeps, and the lock that gives it to one server only."""

import fcntl
import os
import secrets
from pathlib import Path
from typing import IO


class DataDirError(RuntimeError):
    """The data folder cannot be used; the text is one line for the operator."""


class DataDir:
    """What the server keeps, each in its place below one folder, and the lock."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.runs = root / "runs"
        self.missions = root / "missions"
        self.versions = root / "mission_history"
        self.bin = root / "mission_bin"
        self.drafts = root / "mission_drafts"
        self.marks = root / "mission_marks.json"
        self.presets = root / "presets"
        self.charts = root / "charts"
        self.limits = root / "limits"
        self.run_bin = root / "run_bin"
        self.words = root / "words.json"
        self.run_views = root / "run_views.json"
        self.scratch = root / "scratch"
        self.revisions = root / "revisions.jsonl"
        self.alarms = root / "alarms.json"
        self.index = root / "index.sqlite"
        self.node_record = root / "node.json"
        self.flight = root / "flight.json"  # the node's own: there while something flies
        self.audit = root / "audit.jsonl"
        self.access = root / "access"  # accounts, tokens and sessions: for its owner's eyes
        self.node_log = root / "node.log"
        self._lock: IO[str] | None = None

    def open(self) -> None:
        """Make the folders and take the lock. Raises DataDirError."""
        try:
            made = (self.runs, self.missions, self.versions, self.bin, self.drafts, self.presets, self.limits)
            for folder in (*made, self.charts):
                folder.mkdir(parents=True, exist_ok=True)
            lock = (self.root / "lock").open("w")
        except OSError as error:
            raise DataDirError(f"cannot write to the data folder {self.root}: {error.strerror}") from error
        try:
            # Released by the kernel when this process ends, however it ends. Python does not pass
            # the descriptor on to the vehicle node, which outlives a killed server.
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            lock.close()
            raise DataDirError(f"the data folder {self.root} is in use by another server") from error
        self._lock = lock

    def close(self) -> None:
        """Give the lock back."""
        if self._lock is not None:
            self._lock.close()
            self._lock = None

    def secret(self) -> bytes:
        """The key that signs session cookies: kept, so that an open page survives a restart."""
        path = self.root / "secret"
        try:
            key = path.read_bytes()
            if len(key) >= 32:
                return key
        except FileNotFoundError:
            pass
        key = secrets.token_bytes(32)
        self.root.mkdir(parents=True, exist_ok=True)
        write_whole(path, key, mode=0o600)
        return key


def write_whole(path: Path, data: bytes, mode: int = 0o644) -> None:
    """Replace a file at once: a reader sees the old content or the new, never a part."""
    partial = path.with_name(f".{path.name}.{secrets.token_hex(4)}.part")
    descriptor = os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, path)
    except BaseException:
        partial.unlink(missing_ok=True)
        raise
