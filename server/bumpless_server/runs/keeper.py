"""Keeps the catalogue in step with the folder of runs, and says what was found, repaired or deleted."""

import contextlib
import logging
import threading
from collections.abc import Callable
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.adopt import NotOurs, adopt
from bumpless.runs.names import COMPLETE, ENDING
from bumpless.runs.records import read_records
from bumpless_server.live.told import Say
from bumpless_server.runs.catalogue import Catalogue

log = logging.getLogger(__name__)


class Keeper:
    """runs: the folder; busy: the file being written, if any; say: an event for the operator."""

    def __init__(self, runs: Path, catalogue: Catalogue, busy: Callable[[], Path | None], say: Say) -> None:
        self._runs = runs
        self._catalogue = catalogue
        self._busy = busy
        self._say = say
        self.indexed = threading.Event()  # set when the catalogue has seen every file

    def recorded(self, path: Path) -> None:
        """A recording has ended."""
        try:
            self._catalogue.add(path)
        except Exception:
            log.exception("%s could not be indexed", path)

    def prune(self, most_bytes: int) -> bool:
        """Delete the oldest complete run; what was interrupted may be all there is of an accident."""
        complete = [row.summary for row in self._catalogue.rows() if row.summary.state == COMPLETE]
        if not complete or not self._catalogue.delete(complete[-1].id):
            return False
        text = f"Run {complete[-1].id} was deleted: runs may take {most_bytes} bytes"
        self._say(pb.SEVERITY_WARNING, "run_deleted", text, {"run": complete[-1].id})
        return True

    def index(self, then: Callable[[], None]) -> None:
        """See every file once, and repair what was cut off; the body of a thread."""
        try:
            for path in self._catalogue.refresh(busy=self._busy):
                text = f"Run {path.stem} had been cut off and was repaired"
                self._say(pb.SEVERITY_INFO, "run_repaired", text, {"run": path.stem})
            then()
        except Exception:
            log.exception("the runs could not be indexed")
        finally:
            self.indexed.set()

    def found(self, names: set[str]) -> None:
        """Somebody put logs into the folder of runs, or took some away."""
        if not self.indexed.is_set():
            return
        before = {row.summary.id for row in self._catalogue.rows()}
        for path in (self._runs / name for name in names - {f"{run}{ENDING}" for run in before}):
            if path.is_file() and path != self._busy() and not read_records(path).run:
                with contextlib.suppress(NotOurs, OSError):  # it is listed as what it is
                    adopt(path, path)
        self._catalogue.refresh(busy=self._busy)
        new = {row.summary.id for row in self._catalogue.rows()} - before
        for run in sorted(new & {Path(name).stem for name in names}):
            text = f"Run {run} was put into the folder of runs"
            self._say(pb.SEVERITY_INFO, "run_found", text, {"run": run})
