"""The node's Zenoh session: peer or client, opened when there is someone to open it with."""

import re
import threading
from collections.abc import Callable, Sequence

import zenoh

from bumpless.contract.session import endpoints_of, session_config

WAIT_FOR_ROUTER_S = 1.0
LOOPBACK_PORT = "tcp/127.0.0.1:0"
_LOOPBACK = re.compile(r"\w+/(127\.[\d.]+|localhost|\[::1\]):\d+")


def choose_mode(connect: Sequence[str], listen: Sequence[str]) -> str:
    """ "peer" on one machine or when it listens; "client" when all it has is a way to another machine.

    A router passes nothing between two peers, since it takes it that peers reach each other directly.
    That holds on one machine; across machines a client's traffic is the one that is always passed on.
    """
    if listen or all(_LOOPBACK.match(endpoint) for endpoint in connect):
        return "peer"
    return "client"


def node_config(connect: Sequence[str], listen: Sequence[str] = (), mode: str | None = None) -> zenoh.Config:
    """Configuration of the node's session.

    A peer listens on a free loopback port unless told otherwise: by it, nodes that connect to the same
    server find each other, and a second one for a live vehicle id notices.
    """
    mode = mode or choose_mode(connect, listen)
    own = list(listen) or ([LOOPBACK_PORT] if mode == "peer" else [])
    return session_config(mode, connect, own, timestamps=True)


def open_session(
    config: zenoh.Config, stopped: threading.Event, waiting: Callable[[str], None]
) -> zenoh.Session | None:
    """Open it; a client first waits for its router. None when `stopped` comes first.

    Raises zenoh.ZError when a peer cannot be opened, such as for a taken port.
    """
    client = config.get_json("mode") == '"client"'
    told = False
    while not stopped.is_set():
        try:
            return zenoh.open(config)
        except zenoh.ZError:
            if not client:
                raise
        if not told:
            waiting("waiting for a router at " + ", ".join(endpoints_of(config)[0]))
            told = True
        stopped.wait(WAIT_FOR_ROUTER_S)
    return None
