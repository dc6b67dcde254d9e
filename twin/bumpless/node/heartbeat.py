"""The console's heartbeat in a mission: when it stays away, the vehicle does what its file declares."""

import time
from collections.abc import Callable

from bumpless.config.vehicle.failsafe import Failsafe
from bumpless.contract.enums import RUNNING

OWN_FREEZE_S = 1.0  # between two looks: then we stood still ourselves, and heard nothing for that


class Heartbeat:
    """Armed by the first beat: a mission that no console ever watched has none to lose."""

    def __init__(self, declared: Failsafe, now: Callable[[], float] = time.monotonic) -> None:
        self._limit_s = declared.heartbeat_lost_s
        self._now = now
        self._heard_at: float | None = None
        self._looked_at = now()
        self._acted = False

    def beat(self) -> None:
        """A console said that it is there; on Zenoh's thread."""
        self._heard_at = self._now()
        self._acted = False

    def lost_s(self, phase: int) -> float | None:
        """How long nothing was heard, when that calls for the reaction now; told once for each loss."""
        now = self._now()
        slept, self._looked_at = now - self._looked_at, now
        if not self._limit_s or self._heard_at is None:
            return None
        if slept > OWN_FREEZE_S:
            self._heard_at = now
        silent = now - self._heard_at
        if self._acted or phase != RUNNING or silent < self._limit_s:
            return None
        self._acted = True
        return silent
