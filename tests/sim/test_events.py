"""Events of a simulated run: the quick look at changed rows must miss none."""

import numpy as np

from bumpless.contract.enums import INFEASIBLE, REFUSED, RUNNING, SOLVED
from bumpless.control.settings import SETTINGS
from bumpless.sim.events import QUIET_S, EventWriter, TwinEvent, completed_event, eventful, row_events
from bumpless.sim.log import LOG
from bumpless.sim.settings import fill_settings
from bumpless.sim.twin import Result, one


def test_rows_passed_over_have_nothing_to_say(flight: Result) -> None:
    """Protects: what `row_events` learns to tell and `eventful` does not look for is lost in batches."""
    settings = one(SETTINGS)
    fill_settings(settings[0], flight.vehicle, flight.parameters)
    chosen = set(eventful(flight.log))
    told = set()
    for k in range(1, len(flight.log)):
        writer = EventWriter()
        row_events(writer, flight.log[k - 1], flight.log[k], settings[0])
        if writer.drain():
            told.add(k)
    assert told and told <= chosen


def flickering(seconds: float = 21.0) -> np.ndarray:
    """A LOG whose allocator flips its status with every cycle of 50 ms, two bad ones in turn."""
    log = np.zeros(round(seconds / 0.05), LOG)
    log["cycle"] = np.arange(len(log)) + 1
    log["time"] = 0.05 * log["cycle"]
    log["phase"] = RUNNING
    log["status"] = np.resize([SOLVED, REFUSED, SOLVED, INFEASIBLE], len(log))
    return log


def told(log: np.ndarray, rows: list[int], writer: EventWriter | None = None) -> list[TwinEvent]:
    writer = writer or EventWriter()
    writer.add("mission_started", "", {})
    for k in rows:
        row_events(writer, log[k - 1], log[k], one(SETTINGS)[0])
    completed_event(writer, log[-1])
    return [event for event in writer.drain() if event.code == "allocator"]


def test_a_flickering_allocator_is_told_now_and_then_with_a_count() -> None:
    """Protects: twenty events a second would hide every other from the operator; all are counted."""
    log = flickering()
    events = told(log, list(range(1, len(log))))
    for status, code in (("demand refused", REFUSED), ("bounds contradict each other", INFEASIBLE)):
        own = [event for event in events if event.details["status"] == status]
        times = [event.time_s for event in own]
        assert own[0].text == f"Allocator: {status}." and times[0] < 0.3
        assert np.all(np.diff(times[:-1]) >= QUIET_S)
        assert len(own) == 6  # the first, four with a count, and what was left at the end
        assert sum(int(event.details["count"]) for event in own) == np.sum(log["status"] == code)
    assert own[1].text == "Allocator: bounds contradict each other, 25 times in 5.0 s."


def test_batch_and_live_tell_the_same_of_a_flickering_allocator() -> None:
    """Protects: the live node looks at every row, a batch at changed ones; a second run begins afresh."""
    log, writer = flickering(), EventWriter()
    every = list(range(1, len(log)))
    live = told(log, every, writer)
    assert told(log, eventful(log)) == live
    assert told(log, every, writer) == live
