"""Folders of compiled code: one for each state of the sources; those that nobody has used for long go."""

import contextlib
import os
import re
import shutil
import stat
import tempfile
import time
from pathlib import Path
from typing import IO

try:
    import fcntl
except ImportError:  # no such locks on this system: then nothing is ever deleted
    fcntl = None

KEEP = 8  # states of the sources, about 7 MB each
IDLE_S = 86_400.0  # used within this time: kept, however many there are
_NAME = re.compile(r"numba-[0-9a-f]{16}")
_held: list[IO[str]] = []  # one lock for the life of this process


def usable(folder: Path) -> Path:
    """`folder`, or one of this user's own among temporary files where it cannot be written to.

    A service without a home directory would otherwise compile anew at each start, or not at all.
    """
    with contextlib.suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        if os.access(folder, os.W_OK | os.X_OK):
            return folder
    user = os.getuid() if hasattr(os, "getuid") else 0
    own = Path(tempfile.gettempdir()) / f"bumpless-{user}"
    with contextlib.suppress(OSError):
        own.mkdir(mode=0o700, exist_ok=True)
        found = own.lstat()
        # compiled code of somebody else's would run as ours
        if stat.S_ISDIR(found.st_mode) and found.st_uid == user and not found.st_mode & 0o022:
            return own / folder.name
    return Path(tempfile.mkdtemp(prefix="bumpless-"))


def claim(folder: Path) -> Path:
    """Mark `folder` as in use by this process; a new one makes room among the others. Returns it."""
    with contextlib.suppress(OSError):
        fresh = not folder.is_dir()
        folder.mkdir(parents=True, exist_ok=True)
        mark = _mark(folder).open("a")
        _held.append(mark)
        os.utime(mark.fileno())
        if fcntl is not None:
            fcntl.flock(mark, fcntl.LOCK_SH | fcntl.LOCK_NB)
        if fresh:
            prune(folder)
    return folder


def prune(current: Path, now_s: float | None = None) -> list[Path]:
    """Delete folders beside `current` that are not of the KEEP last used, idle and locked by nobody."""
    if fcntl is None:
        return []
    others = [path for path in current.parent.iterdir() if _NAME.fullmatch(path.name) and path != current]
    before = (time.time() if now_s is None else now_s) - IDLE_S
    used = {path: _last_used_s(path) for path in others}
    gone = []
    for path in sorted(others, key=lambda path: -used[path])[KEEP - 1 :]:
        if used[path] < before and _delete(path):
            gone.append(path)
    return gone


def _mark(folder: Path) -> Path:
    return folder / "in-use"


def _last_used_s(folder: Path) -> float:
    with contextlib.suppress(OSError):
        return _mark(folder).stat().st_mtime
    return folder.stat().st_mtime


def _delete(folder: Path) -> bool:
    assert fcntl is not None
    with contextlib.suppress(OSError), _mark(folder).open("a") as mark:
        fcntl.flock(mark, fcntl.LOCK_EX | fcntl.LOCK_NB)  # fails while any process uses the folder
        shutil.rmtree(folder, ignore_errors=True)
        return True
    return False
