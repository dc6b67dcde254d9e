"""Rows about starting up and memory: fresh processes of this very tree.

A cached start finds both caches filled: Numba's machine code and Python's bytecode. Where neither the
installer nor Python keeps bytecode, every process translates all that it imports once more: a row of its own.
"""

import os
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator

from tests.bench.figure import Figure, figure
from tests.bench.stream import ROOT

_FIRST_CYCLE = """
from pathlib import Path
from bumpless.sim.twin import Twin
from bumpless.config.vehicle import load_vehicle
Twin(load_vehicle("ts100")).step()
peak = [line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM")]
print(peak[0].split()[1])  # kB; ru_maxrss would begin at the size of the process that started this one
"""


def _child(arguments: list[str], bytecode: str | None = None) -> tuple[float, str]:
    """CPU seconds of a Python process, and what it printed; `bytecode`: an empty folder to find none in."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    if bytecode is not None:
        environment |= {"PYTHONPYCACHEPREFIX": bytecode, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, *arguments], cwd=ROOT, env=environment, check=True, capture_output=True, text=True
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime), done.stdout


def figures(rounds: int) -> Iterator[Figure]:
    """CPU of `bumpless --help` and of a first control cycle with cached code; memory of the latter."""
    help_, first, source, memory = [], [], [], []
    _child(["-m", "bumpless_server.cli.main", "--help"])  # fills the caches
    _child(["-c", _FIRST_CYCLE])
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as nothing:
            source.append(_child(["-c", _FIRST_CYCLE], bytecode=nothing)[0])
        help_.append(_child(["-m", "bumpless_server.cli.main", "--help"])[0])
        seconds, printed = _child(["-c", _FIRST_CYCLE])
        first.append(seconds)
        memory.append(int(printed.split()[-1]) / 1024)
    yield figure("help_s", "bumpless --help, CPU", help_, "s", below=0.3)
    yield figure("first_cycle_s", "first control cycle after a cached start, CPU", first, "s", below=3.0)
    yield figure("first_cycle_source_s", "the same where no bytecode is kept", source, "s")
    yield figure("twin_mb", "peak memory of a process that flies the twin", memory, "MB")
