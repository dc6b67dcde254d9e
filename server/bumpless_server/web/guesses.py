"""Who gives wrong passwords or tokens has to wait: a secret is as good as the guesses that are allowed."""

import ipaddress
import logging
import time
from collections import OrderedDict, deque
from collections.abc import Callable

from bumpless_server.live.tally import printable

log = logging.getLogger(__name__)

ALLOWED, WITHIN_S = 5, 60.0  # wrong ones by one address
ALLOWED_ON_NAME = 30  # on one account from everywhere: more than people mistype, fewer than guessing needs
MOST_ADDRESSES = 1000


class Guesses:
    """Wrong ones of late by address and by account; used on the event loop alone."""

    def __init__(self, note: Callable[[str, str], None], now: Callable[[], float] = time.monotonic) -> None:
        self._note, self._now = note, now
        self._wrong: OrderedDict[str, deque[float]] = OrderedDict()

    def wait_s(self, address: str, name: str = "") -> float:
        """How long this address (and this account) has to wait before it may try again; 0 when it may now."""
        waits = [self._wait_s(network_of(address), ALLOWED)]
        if name:
            waits.append(self._wait_s(f"account {name}", ALLOWED_ON_NAME))
        return max(waits)

    def wrong(self, address: str, what: str, name: str = "") -> None:
        """Note a wrong one."""
        where = printable(address)
        self._add(network_of(where), ALLOWED)
        if name:
            self._add(f"account {printable(name)}", ALLOWED_ON_NAME)
        log.warning("%s that is wrong came from %s", what, where)
        self._note("refused_login", f"{what} from {where}")

    def _add(self, key: str, allowed: int) -> None:
        self._wrong.setdefault(key, deque(maxlen=allowed)).append(self._now())
        self._wrong.move_to_end(key)
        while len(self._wrong) > MOST_ADDRESSES:
            self._wrong.popitem(last=False)

    def _wait_s(self, key: str, allowed: int) -> float:
        times = self._wrong.get(key)
        if times is None or len(times) < allowed:
            return 0.0
        return max(0.0, times[0] + WITHIN_S - self._now())


def network_of(address: str) -> str:
    """An address; of IPv6 the network of a subscriber, who has all addresses in it."""
    try:
        known = ipaddress.ip_address(address)
    except ValueError:
        return address
    return str(ipaddress.ip_network((known, 64), strict=False)) if known.version == 6 else address
