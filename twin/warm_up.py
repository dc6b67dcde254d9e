"""Compiles what flies, once per machine, with a line of progress for each part: `python -m twin.warm_up`.

Compiled code is kept on disk (see `twin.compiled`), so a vehicle node that starts later loads it in a
second or two instead of compiling while its operator waits.
"""

import sys
import time
from collections.abc import Callable
from pathlib import Path

from twin.mission import parse_mission
from twin.simulation import Twin, simulate
from twin.vehicle import load_vehicle


def announced(text: str, work: Callable[[], object]) -> None:
    """Say what is being done, do it, say how long it took."""
    print(f"  {text} ...", end=" ", flush=True)
    begin = time.perf_counter()
    work()
    print(f"{time.perf_counter() - begin:.1f} s", flush=True)


def warm_up(vehicle_name: str = "ts100", missions: tuple[Path, ...] = ()) -> None:
    """Compile the control cycle by flying one, and the simulation by flying each of `missions`."""
    vehicle = load_vehicle(vehicle_name)
    announced("control cycle", lambda: Twin(vehicle).step())
    for path in missions:
        mission = parse_mission(path.read_text(encoding="utf-8"), path.name)
        announced(f"mission {mission.name}", lambda mission=mission: simulate(mission, vehicle))


if __name__ == "__main__":
    warm_up(missions=tuple(Path(name) for name in sys.argv[1:]))
