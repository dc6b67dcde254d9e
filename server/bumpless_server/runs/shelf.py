"""What people say of runs, and the bin: beside the logs, which are never changed for it.

Titles, tags and notes stand in one JSON file. A run that is thrown away lies in the bin for KEPT_DAYS.
"""

import json
import logging
import threading
import time
from dataclasses import asdict, dataclass
from pathlib import Path

from bumpless.contract.names import RUN
from bumpless.runs.names import ENDING
from bumpless_server.data_dir import write_whole

log = logging.getLogger(__name__)

KEPT_DAYS = 30.0


@dataclass(frozen=True)
class Words:
    """What was written about one run."""

    title: str = ""
    tags: tuple[str, ...] = ()
    note: str = ""

    @property
    def empty(self) -> bool:
        """Nothing was."""
        return self == Words()


class Shelf:
    """Usable from any thread."""

    def __init__(self, words: Path, bin_folder: Path) -> None:
        self._path, self.bin = words, bin_folder
        self._lock = threading.Lock()
        self._words: dict[str, Words] = {}

    def open(self) -> None:
        """Read what was written, and empty the bin of what has lain there for long."""
        self._words = _read(self._path)
        for path in self.bin.glob(f"*{ENDING}"):
            if time.time() - path.stat().st_ctime > KEPT_DAYS * 86_400.0:
                log.info("%s has lain in the bin for %g days and is deleted", path.name, KEPT_DAYS)
                path.unlink(missing_ok=True)

    def words(self, run: str) -> Words:
        """What is written about a run."""
        with self._lock:
            return self._words.get(run, Words())

    def write(self, run: str, words: Words) -> None:
        """Write about a run; empty words take it out."""
        with self._lock:
            self._words.pop(run, None)
            if not words.empty:
                self._words[run] = words
            told = {name: asdict(written) for name, written in self._words.items()}
            write_whole(self._path, json.dumps(told, indent=1, ensure_ascii=False).encode())

    def throw(self, path: Path) -> None:
        """Put a run's file into the bin, in the place of an older one of the same name."""
        self.bin.mkdir(parents=True, exist_ok=True)
        path.replace(self.bin / path.name)

    def take_back(self, run: str, folder: Path) -> Path | None:
        """Bring a run back into `folder`; None when it isn't in the bin. Raises FileExistsError."""
        path = self.bin / f"{RUN.check(run, 'run id')}{ENDING}"
        if not path.is_file():
            return None
        target = folder / path.name
        if target.exists():
            raise FileExistsError(f"there is a run {run!r} already")
        path.rename(target)
        return target

    def thrown(self) -> list[Path]:
        """What is in the bin, the newest first."""
        return sorted(self.bin.glob(f"*{ENDING}"), key=lambda path: path.stat().st_ctime, reverse=True)


def _read(path: Path) -> dict[str, Words]:
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
        return {
            str(name): Words(str(entry["title"]), tuple(map(str, entry["tags"])), str(entry["note"]))
            for name, entry in told.items()
        }
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        log.warning("%s cannot be read (%s): runs have no titles, tags and notes", path, error)
        return {}
