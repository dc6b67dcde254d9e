"""When the next control cycle is due: absolute deadlines on the wall clock, or as fast as it goes."""

import time
from collections.abc import Callable

SPIN_NS = 400_000  # woken this much early, the loop already holds the interpreter at its deadline


class WallClock:
    """Deadlines t0 + n * period on the monotonic clock, so that no lateness ever accumulates.

    A cycle that starts late by less than a period keeps its place in the grid. One that starts later
    has missed the deadlines that passed meanwhile: they are counted and left out, never caught up in a
    burst that an actuator could not follow.
    """

    def __init__(
        self,
        period_ns: int,
        now: Callable[[], int] = time.monotonic_ns,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._period = period_ns
        self._now = now
        self._sleep = sleep
        self._deadline = 0
        self.missed = 0

    def start(self) -> None:
        """The first deadline is one period from now."""
        self._deadline = self._now() + self._period

    def wait(self, hurry: bool = False) -> int:
        """Return at the next deadline: how late that is, ns. `hurry` changes nothing on this clock."""
        deadline = self._deadline
        pause = deadline - self._now() - SPIN_NS
        if pause > 0:
            self._sleep(pause * 1e-9)
        while (now := self._now()) < deadline:
            pass
        late = now - deadline
        skipped = late // self._period
        self.missed += skipped
        self._deadline = deadline + (1 + skipped) * self._period
        return late

    def time_ns(self) -> int:
        """UNIX time of the present cycle."""
        return time.time_ns()


class FreeClock:
    """Virtual time: a flown mission isn't waited for, an idle vehicle keeps the wall clock's pace."""

    def __init__(self, period_ns: int, start_time_ns: int | None = None) -> None:
        self._period = period_ns
        self._time_ns = time.time_ns() if start_time_ns is None else start_time_ns
        self._wall = WallClock(period_ns)
        self.missed = 0

    def start(self) -> None:
        """Begin."""
        self._wall.start()

    def wait(self, hurry: bool = False) -> int:
        """Return at once when `hurry`, else after a period; never late."""
        self._time_ns += self._period
        if hurry:
            self._wall.start()
        else:
            self._wall.wait()
        return 0

    def time_ns(self) -> int:
        """Virtual UNIX time: one period further with every cycle."""
        return self._time_ns


Clock = WallClock | FreeClock
