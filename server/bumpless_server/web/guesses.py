"""Who gives wrong tokens has to wait: a shared secret is only as good as the guesses that are allowed."""

import logging
import time
from collections import OrderedDict, deque
from collections.abc import Callable

from bumpless_server.live.tally import printable

log = logging.getLogger(__name__)

ALLOWED, WITHIN_S = 5, 60.0  # wrong ones by one address
MOST_ADDRESSES = 1000


class Guesses:
    """Wrong tokens of late by address; used on the event loop alone."""

    def __init__(self, note: Callable[[str, str], None], now: Callable[[], float] = time.monotonic) -> None:
        self._note, self._now = note, now
        self._wrong: OrderedDict[str, deque[float]] = OrderedDict()

    def wait_s(self, address: str) -> float:
        """How long this address has to wait before it may try again; 0 when it may now."""
        times = self._wrong.get(address)
        if times is None or len(times) < ALLOWED:
            return 0.0
        return max(0.0, times[0] + WITHIN_S - self._now())

    def wrong(self, address: str) -> None:
        """Note a wrong token."""
        address = printable(address)
        self._wrong.setdefault(address, deque(maxlen=ALLOWED)).append(self._now())
        self._wrong.move_to_end(address)
        while len(self._wrong) > MOST_ADDRESSES:
            self._wrong.popitem(last=False)
        log.warning("a wrong token came from %s", address)
        self._note("refused_login", f"from {address}")
