"""The vehicle on the bus: flies the twin at its control rate, publishes what it does, answers commands.

Four threads that never wait for each other: the control loop (`loop`), which paces itself to absolute
deadlines and touches neither network nor disk; the publisher, which turns the loop's rows into messages;
the commander, which reads and checks requests before the loop sees them; the main thread, which waits
for the end. A real vehicle takes this process's place by saying and answering the same on the same keys.
"""

from typing import Any


def main(*args: Any, **kwargs: Any) -> int:
    """Run a vehicle node until it is told to stop; see `bumpless.node.process.main`."""
    from bumpless.node.process import main as run

    return run(*args, **kwargs)
