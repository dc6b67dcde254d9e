"""The list of runs: an SQLite index beside the MCAP files, which are the truth.

The index can be lost or wrong at any time: `refresh` compares it with the files and reads again what
differs. Files that a killed server left without an end are repaired first.
"""

import contextlib
import json
import logging
import sqlite3
import threading
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any

import bumpless
from bumpless.contract.names import RUN
from bumpless.metrics import as_dict
from bumpless.runs.names import CUT_OFF, ENDING
from bumpless.runs.pieces import piece_of
from bumpless.runs.records import is_whole
from bumpless.runs.repair import repair
from bumpless.runs.run import NoFigures
from bumpless.runs.summary import RunSummary, summarise
from bumpless_server.files import why_no_file
from bumpless_server.live.tally import printable

log = logging.getLogger(__name__)

LAYOUT = 3  # grows when the table changes: an older index is then built anew
_TABLE = """CREATE TABLE runs (
    id TEXT PRIMARY KEY, run_id TEXT, mission TEXT, mission_sha256 TEXT, vehicle TEXT, started_ns INTEGER,
    duration_s REAL, state TEXT, end_reason TEXT, messages INTEGER, dropped INTEGER, outcome TEXT,
    outcome_reason TEXT, metrics TEXT, seed INTEGER,
    parameters_sha256 TEXT, software_version TEXT, bytes INTEGER, modified_ns INTEGER)"""


@dataclass(frozen=True)
class Row:
    """One finished run."""

    summary: RunSummary
    bytes: int
    modified_ns: int

    @property
    def piece(self) -> int:
        """Which piece of its flight it is, from 1; 0: a run, or a copy, of its own."""
        return piece_of(self.summary.id, self.summary.run_id)

    def as_dict(self) -> dict[str, Any]:
        """For JSON; metrics as an object or None."""
        return asdict(self.summary) | {"bytes": self.bytes, "piece": self.piece}


class Catalogue:
    """Finished runs in `folder`, indexed in `index`. Usable from any thread."""

    def __init__(self, folder: Path, index: Path) -> None:
        self._folder, self._index = folder, index
        self._lock = threading.RLock()
        self._db: sqlite3.Connection | None = None
        self._left_out: dict[str, str] = {}

    def open(self) -> None:
        """Open the index; a damaged or older one is thrown away, for the files hold everything."""
        with self._lock:
            try:
                self._db = self._connect()
            except sqlite3.DatabaseError as error:
                log.warning("the index of runs is rebuilt: %s", error)
                for path in self._index.parent.glob(self._index.name + "*"):
                    path.unlink()
                self._db = self._connect()

    def close(self) -> None:
        """Close the index."""
        with self._lock:
            if self._db is not None:
                self._db.close()
                self._db = None

    def refresh(self, busy: Callable[[], Path | None] = lambda: None) -> list[Path]:
        """Make the index agree with the files; returns those that were repaired.

        The file that `busy` names is being written and is left alone. What can't be taken in costs
        no other file its place: `left_out` tells why.
        """
        repaired = []
        with self._lock:
            known = {
                row["id"]: (row["bytes"], row["modified_ns"]) for row in self._rows("SELECT * FROM runs")
            }
        present, left_out = set(), {}
        for path in sorted(self._folder.glob(f"*{ENDING}")):
            if path == busy():
                present.add(path.stem)
                continue
            try:
                reason = why_no_file(path, RUN)
                if not reason:
                    present.add(path.stem)
                    if self._refreshed(path, known.get(path.stem)):
                        repaired.append(path)
            except FileNotFoundError:
                continue
            except Exception as error:
                log.exception("%s could not be taken into the list", printable(path.name))
                reason = str(error) or type(error).__name__
            if reason:
                left_out[printable(path.name)] = printable(reason)
        with self._lock, self._database() as db:
            self._left_out = left_out
            db.executemany("DELETE FROM runs WHERE id = ?", [(run,) for run in known if run not in present])
        return repaired

    def left_out(self) -> dict[str, str]:
        """Entries of the folder that are in no list, with the reason."""
        with self._lock:
            return dict(self._left_out)

    def _refreshed(self, path: Path, known: tuple[int, int] | None) -> bool:
        """Take in a file that differs from what is known of it; True when it was repaired for that."""
        repaired = not is_whole(path) and _repaired(path)
        found = path.stat()
        if known != (found.st_size, found.st_mtime_ns):
            self.add(path)
        return repaired

    def add(self, path: Path) -> None:
        """Index one finished file, or again."""
        found = path.stat()
        summary = summarise(path)
        if summary.metrics is None and summary.end_reason == CUT_OFF:
            summary = _judged(summary, path)
        values = asdict(summary) | {"bytes": found.st_size, "modified_ns": found.st_mtime_ns}
        values["metrics"] = json.dumps(summary.metrics) if summary.metrics is not None else None
        names = ", ".join(values)
        marks = ", ".join(f":{name}" for name in values)
        with self._lock, self._database() as db:
            db.execute(f"INSERT OR REPLACE INTO runs ({names}) VALUES ({marks})", values)

    def rows(self) -> list[Row]:
        """All finished runs, newest first."""
        with self._lock:
            found = self._rows("SELECT * FROM runs ORDER BY started_ns DESC, id DESC")
        return [row for row in map(_row, found) if row is not None]

    def row(self, run: str) -> Row | None:
        """One finished run."""
        with self._lock:
            found = self._rows("SELECT * FROM runs WHERE id = ?", run)
        return _row(found[0]) if found else None

    def pieces(self, run: str, flown: bool = False) -> list[Path]:
        """The finished files of the flight that `run` is of, in order; of a run that is no piece, its own.

        flown: only those that have figures, where any has: a hold after a mission has none.
        """
        own = self.row(run)
        if own is None:
            return []
        with self._lock:
            found = self._rows("SELECT * FROM runs WHERE run_id = ?", own.summary.run_id)
        rows = [row for row in map(_row, found) if row is not None and row.piece]
        if not own.piece:
            rows = [own]
        if flown and any(row.summary.metrics for row in rows):
            rows = [row for row in rows if row.summary.metrics]
        rows.sort(key=lambda row: row.piece)
        return [path for row in rows if (path := self.path(row.summary.id)) is not None]

    def path(self, run: str) -> Path | None:
        """The file of a run, finished or not; None when there is none of that name."""
        if not RUN.allows(run):
            return None
        path = self._folder / f"{run}{ENDING}"
        return path if path.is_file() else None

    def delete(self, run: str) -> bool:
        """Remove a finished run, file and index; False when there is none."""
        path = self.path(run)
        with self._lock, self._database() as db:
            gone = db.execute("DELETE FROM runs WHERE id = ?", (run,)).rowcount > 0
        if path is not None:
            path.unlink(missing_ok=True)
        return gone or path is not None

    def _connect(self) -> sqlite3.Connection:
        db = sqlite3.connect(self._index, check_same_thread=False)
        try:
            db.row_factory = sqlite3.Row
            layout = db.execute("PRAGMA user_version").fetchone()[0]
            if layout != LAYOUT:
                with db:
                    db.execute("DROP TABLE IF EXISTS runs")
                    db.execute(_TABLE)
                    db.execute(f"PRAGMA user_version = {LAYOUT}")
            db.execute("SELECT count(*) FROM runs").fetchone()
        except sqlite3.DatabaseError:
            db.close()
            raise
        return db

    @contextlib.contextmanager
    def _database(self) -> Iterator[sqlite3.Connection]:
        if self._db is None:
            raise RuntimeError("the catalogue is closed")
        with self._db:
            yield self._db

    def _rows(self, query: str, *values: str) -> list[sqlite3.Row]:
        with self._database() as db:
            return db.execute(query, values).fetchall()


def _row(row: sqlite3.Row) -> Row | None:
    """None for a row that somebody else wrote: the next refresh of its file mends it."""
    try:
        values = {item.name: row[item.name] for item in fields(RunSummary)}
        values["metrics"] = json.loads(row["metrics"]) if row["metrics"] else None
        return Row(RunSummary(**values), row["bytes"], row["modified_ns"])
    except (ValueError, TypeError, RecursionError):
        log.warning("a row of the index of runs cannot be read")
        return None


def _judged(summary: RunSummary, path: Path) -> RunSummary:
    """With the figures of a run that lost its end, where it has some. It is worth listing without them."""
    try:
        run = bumpless.open_run(path)
        metrics, outcome = as_dict(run.metrics), run.outcome
    except NoFigures:
        return summary
    except Exception:
        log.exception("the metrics of %s could not be computed", path)
        return summary
    flown_s = summary.duration_s or run.metrics.duration_s  # without an index the file tells no times
    return replace(
        summary,
        metrics=metrics,
        outcome=outcome.ending.value,
        outcome_reason=outcome.reason,
        duration_s=flown_s,
    )


def _repaired(path: Path) -> bool:
    try:
        repair(path)
    except Exception:
        log.exception("%s cannot be repaired and is left as it is", path)
        return False
    log.warning("%s was cut off and has been repaired", path)
    return True
