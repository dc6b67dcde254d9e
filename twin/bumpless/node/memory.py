"""What a node leaves on the disk while it flies, so that the one after a crash knows of it."""

import contextlib
import json
import os
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bumpless.contract.enums import MOVING

if TYPE_CHECKING:
    import numpy as np

    from bumpless.telemetry import FlightState

EVERY_S = 1.0
MOST_BYTES = 2_000_000


@dataclass(frozen=True)
class Left:
    """A flight that was going on when its node ended without a word."""

    run_id: str
    file_name: str
    mission_yaml: str
    seed: int
    position_ned_m: tuple[float, float, float]
    heading_rad: float


class Memory:
    """A file that is there while something flies; without a path nothing is remembered."""

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._written_s = 0.0
        self._there = False

    def left(self) -> Left | None:
        """What an earlier node left, None where it left nothing that can be read."""
        if self._path is None or not self._path.exists():
            return None
        self._there = True
        try:
            if self._path.stat().st_size > MOST_BYTES:
                return None
            told: dict[str, Any] = json.loads(self._path.read_bytes())
            north, east, down = (float(x) for x in told["position_ned_m"])
            run_id, file_name, text = (str(told[name]) for name in ("run_id", "file_name", "mission_yaml"))
            place, heading = (north, east, down), float(told["heading_rad"])
            return Left(run_id, file_name, text, int(told["seed"]), place, heading)
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def note(self, phase: int, state: "FlightState", place: "np.ndarray | None") -> None:
        """Bring the file up to date, at most once a second; `place` is [x y z phi theta psi], m and rad."""
        if self._path is None:
            return
        if phase not in MOVING or state.mission is None or place is None:
            self.forget()
            return
        now = time.monotonic()
        if self._there and now - self._written_s < EVERY_S:
            return
        mission = state.mission
        x, y, z, psi = (float(place[k]) for k in (0, 1, 2, 5))
        left = Left(state.run_id, mission.source, mission.text, state.seed, (x, y, z), psi)
        half = self._path.with_name(self._path.name + ".half")
        with contextlib.suppress(OSError):  # a full disk must not end a flight
            half.write_text(json.dumps(asdict(left)))
            os.replace(half, self._path)
        self._there, self._written_s = True, now

    def forget(self) -> None:
        """Nothing flies."""
        if self._there and self._path is not None:
            with contextlib.suppress(OSError):
                self._path.unlink(missing_ok=True)
            self._there = False
