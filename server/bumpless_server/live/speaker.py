"""Who speaks for the vehicle: one session at a time, and nobody takes its place while it is there.

The bus itself lets everybody say everything unless it has keys. A session is known by the id that Zenoh puts
into the time of each sample; a vehicle node also claims its vehicle with that id (`keys.claim`). An honest
second vehicle is kept out by this, a stranger who forges ids is not: that takes certificates.
"""

import threading
import time
from collections.abc import Callable

QUIET_S = 2.0  # without a claim, one that said nothing for so long has left


class Speaker:
    """Decides on each message; written on the bus's threads, read from any."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._claims: dict[str, str] = {}  # session -> since
        self._current: str | None = None  # "": a session whose samples bear no id
        self._claimed = False  # the current one had a claim once
        self._heard_at = 0.0
        self._alive = False
        self._had_token = False

    @property
    def session(self) -> str:
        """Session id of the vehicle; "" while nobody is known by one."""
        return self._current or ""

    def claim(self, session: str, since: str, present: bool) -> None:
        """A claim on the vehicle appeared or went."""
        with self._lock:
            if present:
                self._claims[session] = since
            else:
                self._claims.pop(session, None)
            self._claimed = self._claimed or session == self._current

    def token(self, present: bool) -> None:
        """The vehicle's liveliness token appeared or went."""
        with self._lock:
            self._alive = present
            self._had_token = self._had_token or present
            if present and not self._claimed:
                self._current = None  # whoever is there now is a newcomer

    def accepts(self, session: str) -> bool:
        """Whether what this session says is the vehicle's word."""
        with self._lock:
            if session != self._current and not self._may_follow(session):
                return False
            if session != self._current:
                self._current, self._claimed = session, session in self._claims
            self._heard_at = self._now()
            return True

    def _may_follow(self, session: str) -> bool:
        if self._claims and session not in self._claims:
            return False
        if self._had_token and not self._alive:
            return False  # the vehicle is lost: silence must stay silence
        if self._current is None:
            return True
        if self._claims and self._current not in self._claims:
            return True
        return not self._claimed and self._now() - self._heard_at > QUIET_S
