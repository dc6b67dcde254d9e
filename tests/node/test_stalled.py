"""Somebody on the bus who does not read must cost the vehicle nothing."""

import signal
import subprocess

from bumpless.contract import bumpless_pb2 as pb
from tests.node.listening import Listener, light_node, program

Process = subprocess.Popen[str]
CYCLES = 60


def wait_for_first_message(stalled: Process) -> None:
    assert stalled.stdout is not None
    assert stalled.stdout.readline().strip() == "stalled"


def gapless_from(bus: Listener, first: int) -> None:
    """The next cycles after number `first` are heard one by one, none left out by the publisher."""
    heard = bus.until(lambda: [m for m in bus.of("tlm/control") if m.stamp.cycle >= first + CYCLES]) and [
        m.stamp.cycle for m in bus.of("tlm/control") if m.stamp.cycle >= first
    ]
    assert heard[:CYCLES] == list(range(heard[0], heard[0] + CYCLES))
    health = bus.until(lambda: [m for m in bus.of("tlm/health") if m.stamp.cycle >= first + 20])[-1]
    assert health.dropped_rows == 0


def test_a_frozen_subscriber_does_not_slow_the_loop(bus: Listener, node: Process, endpoint: str) -> None:
    """A process that is stopped in the middle of hearing: every cycle is flown and said to the others."""
    with program("-m", "tests.node.stalled", endpoint) as stalled:
        wait_for_first_message(stalled)
        stalled.send_signal(signal.SIGSTOP)
        gapless_from(bus, bus.of("tlm/control")[-1].stamp.cycle + 1)
        assert bus.start().accepted


def test_a_callback_that_never_returns_does_not_slow_the_loop(
    bus: Listener, node: Process, endpoint: str
) -> None:
    """Alive for Zenoh but deaf: events, which wait for their place, still reach the others."""
    with program("-m", "tests.node.stalled", endpoint) as stalled:
        wait_for_first_message(stalled)
        for _ in range(20):
            assert not bus.ask("pause").accepted
        bus.until(lambda: len(bus.of("event")) == 20)
        gapless_from(bus, bus.of("tlm/control")[-1].stamp.cycle + 1)


def test_flown_and_missed_cycles_are_all_there_were(bus: Listener, node: Process) -> None:
    """Over 60 cycles: what was flown and what was missed together fill the time between the stamps."""
    first, last = bus.until(lambda: (h := bus.of("tlm/health")) and len(h) >= 4 and (h[0], h[-1]))
    deadlines = (last.cycles + last.missed_cycles) - (first.cycles + first.missed_cycles)
    periods = (last.stamp.time_ns - first.stamp.time_ns) / 50e6
    assert abs(deadlines - periods) <= 1.0 + (last.lateness_max_ms + first.lateness_max_ms) / 50.0


def test_virtual_time_gets_past_a_deaf_listener(bus: Listener, endpoint: str) -> None:
    """Flown as fast as it goes the bus is full at once: the deaf link is given up, the mission flown."""
    with light_node(endpoint, "fast"):
        bus.until_alive()
        with program("-m", "tests.node.stalled", endpoint) as stalled:
            wait_for_first_message(stalled)
            assert bus.start().accepted
            bus.until(lambda: [m for m in bus.of("tlm/mission") if m.phase == pb.MISSION_PHASE_COMPLETED])
