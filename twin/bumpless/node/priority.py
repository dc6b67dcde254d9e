"""Ask the system to favour a node that flies. Whatever is not permitted is done without, silently."""

import os
import sys
from contextlib import suppress
from pathlib import Path

SWITCH_INTERVAL_S = 0.0005  # how long another thread may keep the interpreter from the loop
NICE = -10
FIFO_PRIORITY = 10


def raise_process() -> None:
    """Favour every thread there is: each of them may hold what the loop is about to need.

    To be called when the node is ready to fly, for compiling must not crowd out its neighbours.
    """
    sys.setswitchinterval(SWITCH_INTERVAL_S)
    with suppress(OSError):
        for thread in Path("/proc/self/task").iterdir():
            os.setpriority(os.PRIO_PROCESS, int(thread.name), NICE)


def raise_thread() -> None:
    """On the loop's own thread: real-time scheduling where the system grants it."""
    if hasattr(os, "sched_setscheduler"):
        with suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(FIFO_PRIORITY))
