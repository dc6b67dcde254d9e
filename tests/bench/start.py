"""Rows about starting up and memory: fresh processes of this very tree."""

import os
import resource
import subprocess
import sys
from collections.abc import Iterator

from tests.bench.figure import Figure, figure
from tests.bench.stream import ROOT

_FIRST_CYCLE = """
import resource, sys
from twin.simulation import Twin
from twin.vehicle import load_vehicle
Twin(load_vehicle("ts100")).step()
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def _child(arguments: list[str]) -> tuple[float, str]:
    """CPU seconds of a Python process, and what it printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, *arguments], cwd=ROOT, env=environment, check=True, capture_output=True, text=True
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime), done.stdout


def figures(rounds: int) -> Iterator[Figure]:
    """CPU of `bumpless --help` and of a first control cycle with cached code; memory of the latter."""
    help_, first, memory = [], [], []
    _child(["-c", _FIRST_CYCLE])
    for _ in range(rounds):
        help_.append(_child(["-m", "server.cli.main", "--help"])[0])
        seconds, printed = _child(["-c", _FIRST_CYCLE])
        first.append(seconds)
        memory.append(int(printed.split()[-1]) / 1024)
    yield figure("help_s", "bumpless --help, CPU", help_, "s", below=0.3)
    yield figure("first_cycle_s", "first control cycle after a cached start, CPU", first, "s", below=3.0)
    yield figure("twin_mb", "peak memory of a process that flies the twin", memory, "MB")
