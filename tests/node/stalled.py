"""A program on the bus that hears a vehicle but never returns from its first message."""

import sys
import threading

import zenoh

from bumpless.contract import keys
from bumpless.node.session import node_config


def hang(sample: zenoh.Sample) -> None:
    """Keep Zenoh's thread for ever: nothing more is read from the vehicle's link."""
    print("stalled", flush=True)
    threading.Event().wait()


if __name__ == "__main__":
    with zenoh.open(node_config([sys.argv[1]])) as session:
        held = session.declare_subscriber(f"{keys.ROOT}/ts100/**", hang)
        threading.Event().wait()
