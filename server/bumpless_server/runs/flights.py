"""Figures of flights that were recorded in pieces: made when asked for, the last few kept."""

import logging
import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bumpless.metrics import Ending
from bumpless.review.subject import subject_of

log = logging.getLogger(__name__)

KEPT = 50


@dataclass(frozen=True)
class FlightFigures:
    """None where the flight has none."""

    outcome: Ending | None = None
    reason: str = ""
    metrics: Mapping[str, Any] | None = None


class Flights:
    """Usable from any thread; one flight is judged at a time."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._known: OrderedDict[tuple[tuple[Path, int], ...], FlightFigures] = OrderedDict()

    def of(self, pieces: Sequence[Path]) -> FlightFigures:
        """The figures of the flight in these files as they are now."""
        key = tuple((path, path.stat().st_mtime_ns) for path in pieces)
        with self._lock:
            found = self._known.pop(key, None) or _figures(pieces)
            self._known[key] = found
            while len(self._known) > KEPT:
                self._known.popitem(last=False)
            return found


def _figures(pieces: Sequence[Path]) -> FlightFigures:
    try:
        subject = subject_of(pieces)
    except ValueError as error:
        log.info("%s has no figures: %s", pieces[0].name, error)
        return FlightFigures()
    outcome = Ending(subject.outcome) if subject.outcome in set(Ending) else None
    return FlightFigures(outcome, subject.reason, subject.metrics)
