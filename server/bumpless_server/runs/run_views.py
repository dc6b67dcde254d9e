"""Named looks at the list of runs, shared by all: what is searched for, and which columns show.

They stand in one JSON file beside the logs.
"""

import json
import logging
import threading
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from bumpless_server.data_dir import write_whole

log = logging.getLogger(__name__)

MOST = 100


@dataclass(frozen=True)
class RunView:
    """One look at the list. `columns` are those shown beside the outcome and the title, in their order."""

    words: str = ""
    outcome: str = ""  # an Ending's word, "recording", or "" for all
    columns: tuple[str, ...] = ()
    author: str = ""  # who kept it last


class TooMany(ValueError):
    """As many as may be are kept."""


class RunViews:
    """Usable from any thread."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._lock = threading.Lock()
        self._views: dict[str, RunView] | None = None  # read when first asked for

    def _known(self) -> dict[str, RunView]:
        if self._views is None:
            self._views = _read(self._path)
        return self._views

    def all(self) -> dict[str, RunView]:
        """All, by name."""
        with self._lock:
            return dict(sorted(self._known().items(), key=lambda item: item[0].casefold()))

    def keep(self, name: str, view: RunView) -> RunView | None:
        """Keep a view, and return what it replaces. Raises TooMany."""
        with self._lock:
            known = self._known()
            before = known.get(name)
            if before is None and len(known) >= MOST:
                raise TooMany(f"there are {MOST} views already; forget one first")
            self._write(known | {name: view})
            return before

    def forget(self, name: str) -> RunView | None:
        """Forget a view, and return it; None when there is none of that name."""
        with self._lock:
            known = self._known()
            found = known.get(name)
            if found is not None:
                self._write({other: view for other, view in known.items() if other != name})
            return found

    def _write(self, views: dict[str, RunView]) -> None:
        """On the disk first: what is not kept there is not told either."""
        told = {name: asdict(view) for name, view in views.items()}
        write_whole(self._path, json.dumps(told, indent=1, ensure_ascii=False).encode())
        self._views = views


def _read(path: Path) -> dict[str, RunView]:
    """What was kept; what is no view is left out, with a warning."""
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, RecursionError) as error:
        log.warning("%s cannot be read (%s): there are no saved views of the list of runs", path, error)
        return {}
    found = {}
    for name, entry in told.items() if isinstance(told, dict) else ():
        try:
            found[str(name)] = _view(entry)
        except (KeyError, TypeError):
            log.warning("%s: %.60r is no view of the list of runs", path, name)
    return dict(list(found.items())[:MOST])


def _view(entry: dict[str, Any]) -> RunView:
    columns = tuple(map(str, entry["columns"]))
    return RunView(str(entry["words"]), str(entry["outcome"]), columns, str(entry["author"]))
