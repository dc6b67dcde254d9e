"""Hostile missions, vehicles and logs: each is refused with a message or read, in time and in little memory.

Each is read in a forked process of its own: what it takes is known, and what it breaks is nobody else's.
"""

import contextlib
import os
import random
import resource
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from bumpless.config.mission import parse_mission
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import load_vehicle, parse_vehicle
from bumpless.runs.summary import summarise
from tests.trust.figure import Figure, at_most, exactly
from tests.trust.mutate import log_bytes, mutated_bytes, mutated_text

MISSIONS = Path(__file__).parents[2] / "missions"
MOST_S, MOST_MB = 1.0, 300.0
READ, REFUSED, TRACEBACK = 0, 1, 2


def figures(count: int, seed: int = 5) -> Iterator[Figure]:
    """Try `count` files: missions, vehicles and logs in turn."""
    draw = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        kinds = _kinds(Path(folder), draw)
        odd, worst_s, worst_mb, refused = 0, 0.0, 0.0, 0
        for number in range(count):
            made = kinds[number % len(kinds)]()
            how, cpu_s, mb = _apart(made)
            odd += how not in (READ, REFUSED)
            refused += how == REFUSED
            worst_s, worst_mb = max(worst_s, cpu_s), max(worst_mb, mb)
    yield exactly("files", f"of {count} hostile files, ended by anything but a message", odd, "", 0)
    yield at_most("files", f"slowest ({refused} were refused, the others read)", worst_s, "s CPU", MOST_S)
    yield at_most("files", "largest, the program itself included", worst_mb, "MB", MOST_MB)


def _kinds(folder: Path, draw: random.Random) -> list[Callable[[], Callable[[], object]]]:
    vehicle = load_vehicle("ts100")
    missions = [path.read_text() for path in sorted(MISSIONS.glob("*.yaml"))]
    whole = log_bytes(folder)

    def mission() -> Callable[[], object]:
        text = mutated_text(draw.choice(missions), draw)
        return lambda: parse_mission(text, "hostile.yaml", vehicle)

    def car() -> Callable[[], object]:
        text = mutated_text(vehicle.text, draw)
        return lambda: parse_vehicle(text, "hostile.toml")

    def log() -> Callable[[], object]:
        path = folder / "hostile.mcap"
        path.write_bytes(mutated_bytes(whole, draw))
        return lambda: summarise(path)

    return [mission, car, log]


def _apart(read: Callable[[], object]) -> tuple[int, float, float]:
    """How it ended, CPU time in s and memory in MB, in a process of its own."""
    child = os.fork()
    if child == 0:
        how = TRACEBACK
        try:
            resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
            with contextlib.suppress(OSError):
                os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            read()
            how = READ
        except (ProblemsError, ValueError, OSError) as refusal:
            how = REFUSED if str(refusal).strip() else TRACEBACK
        finally:
            os.write(1, b"")
            os._exit(how)
    _, status, used = os.wait4(child, 0)
    how = os.waitstatus_to_exitcode(status)
    return how, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024.0
