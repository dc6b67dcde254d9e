"""Rows about a live node beside a loaded server: the short form of `tests.bench.live_node`."""

import asyncio
import subprocess
import sys
from collections.abc import Iterator

from tests.bench.figure import Figure, figure
from tests.bench.live_node import observe
from tests.bench.stream import ROOT

TURNS = 3
NOISE_MS = 0.05  # a thousandth of a period


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
    yield from _beside_a_planner(minutes)


def _beside_a_planner(minutes: float) -> Iterator[Figure]:
    """Lateness without and with somebody who drags a plan all the time, in turns; each with a fresh node."""
    p99: dict[bool, list[float]] = {False: [], True: []}
    for dragging in (False, True) * TURNS:
        health = asyncio.run(observe(minutes, 1, "off", "docking", dragging)).health
        assert health is not None
        p99[dragging].append(health.lateness_p99_ms)
    yield figure("alone_p99_ms", f"lateness p99, {TURNS} times {minutes:g} min, no planner", p99[False], "ms")
    yield figure("dragging_p99_ms", "the same in turns, a plan being dragged all the time", p99[True], "ms")
    more = [one - other for one, other in zip(p99[True], p99[False], strict=True)]
    title = "lateness p99, more with a plan being dragged than without"
    yield figure("dragging_more_ms", title, more, "ms", at_most=NOISE_MS)
