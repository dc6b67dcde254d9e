"""A small share of the trials of `python -m tests.trust`: what must never happen, without its times."""

import json
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

from tests.trust import bus, files, page, recorder
from tests.trust.__main__ import FIGURES, TRIALS
from tests.trust.figure import Figure


def broken(figures: Iterable[Figure]) -> list[str]:
    """Promises that were not kept, but for times: a busy machine must not fail a test."""
    return [figure.row() for figure in figures if not figure.met and not figure.unit.startswith("s")]


def test_hostile_files_end_in_a_message() -> None:
    """Protects: a file may be anything; it is read or refused, in little memory, and ends nothing."""
    # from a small process: what a forked one holds begins with what its parent holds
    with ProcessPoolExecutor(1, get_context("spawn")) as apart:
        assert apart.submit(_hostile_files).result() == []


def _hostile_files() -> list[str]:
    return broken(files.figures(45))


def test_killed_recorders_leave_files_that_read() -> None:
    """Protects: what was written before a kill -9 is kept, in order, from its first second on."""
    assert broken(recorder.figures(2)) == []


def test_a_storm_on_the_bus_changes_nothing() -> None:
    """Protects: random and forged messages are each counted and take neither screen nor vehicle."""
    assert broken(bus.figures(500)) == []


def test_the_page_tells_what_was_measured() -> None:
    """Protects: the page of figures is made of the figures that were kept, every trial at full size."""
    known = json.loads(FIGURES.read_text())
    assert page.PAGE.read_text(encoding="utf-8") == page.text(known)
    assert known.keys() == TRIALS.keys()
