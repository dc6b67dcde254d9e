"""Ask the system to favour the control loop. Whatever isn't permitted is done without, silently."""

import os
import sys
from contextlib import suppress

SWITCH_INTERVAL_S = 0.0005  # how long another thread may keep the interpreter from the loop
NICE = -10
FIFO_PRIORITY = 10


def raise_process() -> None:
    """Before any thread is started: all of them may hold what the loop is about to need."""
    sys.setswitchinterval(SWITCH_INTERVAL_S)
    with suppress(OSError):
        os.setpriority(os.PRIO_PROCESS, 0, NICE)


def raise_thread() -> None:
    """On the loop's own thread: real-time scheduling where the system grants it."""
    if hasattr(os, "sched_setscheduler"):
        with suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(FIFO_PRIORITY))
