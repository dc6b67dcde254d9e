"""Compiles what flies, once per machine, with visible progress: `python -m bumpless.sim.warm_up [missions]`.

Compiled code is kept on disk (see `bumpless.jit`), so a vehicle node that starts later loads it in a
second or two instead of compiling while its operator waits.
"""

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from numba.core import event

from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.sim.twin import Twin, simulate


class Progress(event.Listener):
    """Counts the functions that Numba has compiled, on one line that a terminal keeps rewriting."""

    def __init__(self, text: str) -> None:
        self.text, self.compiled, self.begin = text, 0, time.perf_counter()
        self.live = sys.stdout.isatty()
        self.show()

    def show(self, end: str = "") -> None:
        """Write the line; on a terminal over the line before, elsewhere only when it is final."""
        seconds = time.perf_counter() - self.begin
        line = f"  {self.text}: {self.compiled} functions compiled, {seconds:.0f} s"
        if self.live or end:
            print("\r" * self.live + line, end=end, flush=True)

    def on_start(self, event: Any) -> None:
        """Numba begins a function: nothing to say."""

    def on_end(self, event: Any) -> None:
        """Numba finished a function."""
        self.compiled += 1
        self.show()


def announced(text: str, work: Callable[[], object]) -> None:
    """Do the work and show how far the compiler is."""
    progress = Progress(text)
    with event.install_listener("numba:compile", progress):
        work()
    progress.show(end="\n")


def warm_up(vehicle_name: str = "ts100", missions: tuple[Path, ...] = ()) -> None:
    """Compile the control cycle by flying one, and the simulation by flying each of `missions`."""
    vehicle = load_vehicle(vehicle_name)
    announced("control cycle", lambda: Twin(vehicle).step())
    for path in missions:
        mission = parse_mission(path.read_bytes(), path.name)
        announced(f"mission {mission.name}", lambda mission=mission: simulate(mission, vehicle))


if __name__ == "__main__":
    warm_up(missions=tuple(Path(name) for name in sys.argv[1:]))
