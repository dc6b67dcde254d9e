"""Rows about a live node beside a loaded server: the short form of `tests.bench.live_node`."""

import asyncio
import subprocess
import sys
from collections.abc import Iterator

from tests.bench.figure import Figure, figure
from tests.bench.live_node import observe
from tests.bench.stream import ROOT


def figures(minutes: float) -> Iterator[Figure]:
    """Lateness and missed cycles with five streams and one view of the full scene; peak memory.

    Beside them an empty loop of the same priority: what the machine makes late by itself.
    """
    command = [sys.executable, "-m", "tests.bench.empty_loop", str(60 * minutes)]
    empty = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    seen = asyncio.run(observe(minutes, 5, "full", "docking"))
    health = seen.health
    assert health is not None
    during = f"live node, {minutes:g} min beside a loaded server"
    yield figure("lateness_p99_ms", f"{during}: lateness p99", [health.lateness_p99_ms], "ms", below=2.0)
    alone = float(empty.communicate()[0])
    yield figure("empty_p99_ms", "an empty loop of the same priority at the same time: p99", [alone], "ms")
    yield figure("missed_cycles", f"{during}: missed cycles", [health.missed_cycles], "cycles", at_most=0)
    yield figure("live_cycle_us", "live control cycle, p50 with telemetry", [health.cycle_time_p50_us], "µs")
    for name in ("node", "server"):
        yield figure(f"{name}_mb", f"peak memory, {name}", [seen.peaks[name] / 1024], "MB")
