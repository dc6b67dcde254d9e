"""Flights ahead that the scene shows as ghosts: the web puts them here, the scene's own thread takes them."""

import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Ghost:
    """One flight ahead: mission times, s, and NED positions (n, 3) in m with attitudes (n, 3) in degrees."""

    time_s: np.ndarray
    position_ned_m: np.ndarray
    attitude_deg: np.ndarray

    def at(self, time_s: float) -> tuple[np.ndarray, np.ndarray]:
        """Position and attitude then."""
        place, angles = (
            np.array([np.interp(time_s, self.time_s, column) for column in table.T])
            for table in (self.position_ned_m, self.attitude_deg)
        )
        return place, angles


class Ghosts:
    """The newest flights ahead of one run. Usable from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._run, self._ghosts = "", dict[str, Ghost]()

    def put(self, run: str, ghosts: dict[str, Ghost]) -> None:
        """Show these in place of what was shown."""
        with self._lock:
            self._run, self._ghosts = run, ghosts

    def of(self, run: str, time_s: float) -> dict[str, Ghost]:
        """Those of this run that reach beyond this mission time."""
        with self._lock:
            if not run or run != self._run:
                return {}
            return {name: ghost for name, ghost in self._ghosts.items() if ghost.time_s[-1] > time_s}


def ghost_of(time_s: Sequence[float], columns: Mapping[str, Sequence[float | None]]) -> Ghost:
    """From a flight's columns as the console has them."""

    def table(*names: str) -> np.ndarray:
        return np.array([[value or 0.0 for value in columns[name]] for name in names], float).T

    return Ghost(np.array(time_s, float), table("north", "east", "depth"), table("roll", "pitch", "yaw"))
