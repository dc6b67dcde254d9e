"""The ring between loop and publisher: the loop never waits, and what is lost is counted."""

import threading

import numpy as np
import pytest

from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless.node.ring import Cycle, Ring
from bumpless.sim.events import TwinEvent
from bumpless.sim.log import LOG
from bumpless.telemetry import FlightState


@pytest.fixture(scope="module")
def state() -> FlightState:
    return FlightState(default_parameters(load_vehicle("ts100")))


def row(number: int) -> np.void:
    """A row whose every number is `number`, so that a torn one shows."""
    made = np.zeros(1, LOG)
    made.view(np.float64)[:] = number
    made["cycle"] = number
    return made[0]


def test_rows_and_events_arrive_in_order(state: FlightState) -> None:
    """Everything put is taken once, with the time and events of its own cycle."""
    ring, seen = Ring(), []
    for n in range(10):
        ring.put(row(n), 1000 + n, state, [TwinEvent(1, f"e{n}", "", {})] if n % 3 == 0 else [])
    ring.close()
    assert not ring.take_all(lambda c: seen.append((c.number, c.time_ns, [e.code for e in c.events])))
    assert seen == [(n, 1000 + n, [f"e{n}"] if n % 3 == 0 else []) for n in range(10)]


def test_a_reader_that_stands_still_costs_the_oldest_rows_and_no_event(state: FlightState) -> None:
    """Ten thousand cycles into a ring that nobody reads: the writer gets through, the account is right."""
    ring, seen, events = Ring(capacity=16), [], []
    for n in range(10_000):
        ring.put(row(n), n, state, [TwinEvent(1, str(n), "", {})] if n % 1000 == 0 else [])
    ring.close()

    def take(cycle: Cycle) -> None:
        seen.append(cycle.number)
        events.extend(event.code for event in cycle.events)

    ring.take_all(take)
    assert seen == list(range(10_000 - len(seen), 10_000))
    assert len(seen) >= 15
    assert ring.dropped == 10_000 - len(seen)
    assert events == [str(n) for n in range(0, 10_000, 1000)]


def test_no_row_is_torn_while_the_writer_laps_the_reader(state: FlightState) -> None:
    """A row taken is a row put, whole, however the two threads interleave."""
    ring, taken = Ring(capacity=4), []

    def take(cycle: Cycle) -> None:
        values = set(np.atleast_1d(cycle.row)["u"][0].tolist())
        assert values == {float(cycle.row["time"])} and cycle.row["cycle"] == cycle.number == cycle.time_ns
        taken.append(cycle.number)

    def write() -> None:
        for n in range(20_000):
            ring.put(row(n), n, state, [])
        ring.close()

    writer = threading.Thread(target=write)
    writer.start()
    while ring.take_all(take):
        pass
    writer.join()
    assert taken == sorted(set(taken))
    assert len(taken) + ring.dropped == 20_000


def test_virtual_time_loses_nothing(state: FlightState) -> None:
    """Lossless, the writer waits for the reader instead."""
    ring, taken = Ring(capacity=4, lossless=True), []

    def write() -> None:
        for n in range(500):
            ring.put(row(n), n, state, [])
        ring.close()

    writer = threading.Thread(target=write)
    writer.start()
    while ring.take_all(lambda cycle: taken.append(cycle.number)):
        pass
    writer.join()
    assert taken == list(range(500))
    assert ring.dropped == 0
