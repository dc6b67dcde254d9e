"""Work on logs that takes seconds, done by a process of its own at low priority: bus, web and recorder go on.

The command line does it: what the console can, a terminal can, and in the same words.
"""

import logging
import shutil
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

log = logging.getLogger(__name__)

MOST = 2  # at a time
LONGEST_S = 300.0
NICE = 10
_RUN = f"import os; os.nice({NICE}); from bumpless_server.cli.main import app; app(prog_name='bumpless')"


class ErrandFailed(ValueError):
    """It could not be done; the text says why, for people."""


class ErrandsBusy(RuntimeError):
    """As many as may be are on their way."""


class Errands:
    """Runs commands of ours. Usable from any thread; `scratch` is emptied when it begins."""

    def __init__(self, scratch: Path) -> None:
        self._scratch = scratch
        self._room = threading.BoundedSemaphore(MOST)

    def open(self) -> None:
        """Make the folder for what is on its way, and throw away what a killed server left there."""
        shutil.rmtree(self._scratch, ignore_errors=True)
        self._scratch.mkdir(parents=True)

    @contextmanager
    def folder(self) -> Iterator[Path]:
        """A folder to work in, gone afterwards. Raises ErrandsBusy."""
        if not self._room.acquire(blocking=False):
            raise ErrandsBusy("other exports and flights are on their way; try again in a moment")
        try:
            with tempfile.TemporaryDirectory(dir=self._scratch) as name:
                yield Path(name)
        finally:
            self._room.release()

    def run(self, arguments: Sequence[str]) -> str:
        """What the command printed. Raises ErrandFailed."""
        try:
            done = subprocess.run(
                [sys.executable, "-c", _RUN, *arguments],
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=LONGEST_S,
            )
        except subprocess.TimeoutExpired as error:
            raise ErrandFailed(f"it took longer than {LONGEST_S:g} s and was given up") from error
        except (ValueError, OSError) as error:  # a NUL in a word, or more words than a command may have
            raise ErrandFailed(f"it cannot be asked for: {error}") from error
        if done.returncode:
            said = [line for line in done.stderr.strip().splitlines() if line.strip()]
            log.info("bumpless %s: %s", arguments[0] if arguments else "", done.stderr.strip()[-2000:])
            reason = said[-1] if said else f"it ended with code {done.returncode}"
            raise ErrandFailed(reason.removeprefix(f"bumpless {arguments[0]}: "))
        return done.stdout
