"""How far the vehicle's clock is from the server's, measured by what it says."""

import threading
import time
from collections import deque
from collections.abc import Callable

WINDOW_S = 2.0
MOST = 256


class VehicleClock:
    """Offset of the vehicle's UNIX time against ours.

    A message can only come late, never early: the largest difference of the last seconds is the truest. After
    a silence come messages that waited meanwhile; what was measured before it counts for so long again.
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._seen: deque[tuple[float, int]] = deque(maxlen=MOST)
        self._offset_ns = 0

    def heard(self, stamp_ns: int, receive_ns: int) -> None:
        """Take in one message: when it was made by the vehicle's clock, and received by ours."""
        now = self._now()
        with self._lock:
            if self._seen and now - self._seen[-1][0] > WINDOW_S / 2:
                self._seen.clear()
                self._seen.append((now, self._offset_ns))
            while self._seen and now - self._seen[0][0] > WINDOW_S:
                self._seen.popleft()
            self._seen.append((now, stamp_ns - receive_ns))
            self._offset_ns = max(difference for _, difference in self._seen)

    @property
    def offset_s(self) -> float:
        """Vehicle minus server; 0 before anything was heard."""
        return self._offset_ns * 1e-9

    def to_vehicle(self, time_ns: int) -> int:
        """A time of ours by the vehicle's clock; ns, never negative."""
        return max(0, time_ns + self._offset_ns)
