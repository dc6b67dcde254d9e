"""Who is there in a mission: when console or holder of control stays away, the vehicle acts as declared."""

import time
from collections.abc import Callable

from google.protobuf.message import DecodeError

from bumpless.config.vehicle.failsafe import Failsafe, Reaction
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import FLYING, RUNNING

OWN_FREEZE_S = 1.0  # between two looks: then we stood still ourselves, and heard nothing for that


class Presence:
    """Armed by the first sign of life: a mission that nobody ever watched has nobody to lose.

    `limit_s` of silence in a mission is a loss; 0: it is not watched.
    """

    def __init__(self, limit_s: float, now: Callable[[], float] = time.monotonic) -> None:
        self._limit_s = limit_s
        self._now = now
        self._heard_at: float | None = None
        self._looked_at = now()
        self._acted = False

    def seen(self) -> None:
        """A sign of life; on Zenoh's thread."""
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
        if silent < self._limit_s or self._acted:
            return None
        if phase not in FLYING:
            self._heard_at = None  # who left before a mission has not left it
        if phase != RUNNING:
            return None
        self._acted = True
        return silent


class Heartbeat:
    """What the console says twice a second: that it is there, and whether the holder of control is."""

    def __init__(self, declared: Failsafe, now: Callable[[], float] = time.monotonic) -> None:
        self._declared = declared
        self._console = Presence(declared.heartbeat_lost_s, now)
        self._holder = Presence(declared.holder_lost_s, now)

    def beat(self, payload: bytes) -> None:
        """A console said something; on Zenoh's thread. What is no Heartbeat says that it is there at most."""
        self._console.seen()
        try:
            in_control = pb.Heartbeat.FromString(payload).in_control
        except DecodeError:
            return
        if in_control:
            self._holder.seen()

    def lost(self, phase: int) -> list[tuple[str, str, Reaction]]:
        """(cause, what happened in words, declared reaction) of each loss that calls for one now."""
        found: list[tuple[str, str, Reaction]] = []
        if (silent_s := self._console.lost_s(phase)) is not None:
            what = f"No word from the console for {silent_s:.1f} s"
            found.append(("heartbeat_lost", what, self._declared.heartbeat_lost))
        if (silent_s := self._holder.lost_s(phase)) is not None:
            what = f"Nobody has been in control for {silent_s:.1f} s"
            found.append(("holder_lost", what, self._declared.holder_lost))
        return found
