"""TCP ports for tests that must know a port before anybody listens on it."""

import random
import socket
from pathlib import Path

_RANGE = Path("/proc/sys/net/ipv4/ip_local_port_range")
_FIRST, _draw = 10_240, random.SystemRandom()


def free_port() -> int:
    """A port of loopback that nobody listens on, and that the system gives to nobody who asks for any.

    A port that the system chose is free again as soon as it is known: whoever binds or connects before its
    test does may be given it.
    """
    last = int(_RANGE.read_text().split()[0]) if _RANGE.exists() else 32_768
    while True:
        port = _draw.randrange(_FIRST, last)
        with socket.socket() as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
            return port
