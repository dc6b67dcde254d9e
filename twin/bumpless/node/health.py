"""How the node itself is doing, and the vehicle's body: lateness, missed cycles, memory, leak, battery."""

import os
import socket
from collections.abc import Callable
from typing import TYPE_CHECKING

import psutil

from bumpless.contract import bumpless_pb2 as pb
from bumpless.sim.condition import Condition

if TYPE_CHECKING:
    from bumpless.node.loop import ControlLoop
    from bumpless.node.ring import Ring


class HealthReport:
    """Builds topic "health" from the loop's own counters, on the publisher's thread."""

    def __init__(self, loop: "ControlLoop", ring: "Ring", condition: Callable[[], Condition]) -> None:
        self._loop = loop
        self._condition = condition
        self._ring = ring
        self._process = psutil.Process()
        self._host = socket.gethostname()

    def __call__(self, stamp: pb.Stamp) -> pb.Health:
        loop, condition = self._loop, self._condition()
        return pb.Health(
            stamp=stamp,
            cycles=loop.cycles,
            missed_cycles=loop.missed,
            lateness_p99_ms=loop.lateness.percentile(0.99) * 1e-6,
            lateness_max_ms=loop.lateness.maximum * 1e-6,
            cycle_time_p50_us=loop.cycle_time.percentile(0.5) * 1e-3,
            cycle_time_p99_us=loop.cycle_time.percentile(0.99) * 1e-3,
            resident_bytes=self._process.memory_info().rss,
            process_id=os.getpid(),
            host_name=self._host,
            dropped_rows=self._ring.dropped,
            leak=condition.leak,
            battery_share=condition.battery,
        )
