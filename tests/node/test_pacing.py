"""Deadlines are absolute: lateness is accounted for and never accumulates or is made up in a burst."""

from hypothesis import given
from hypothesis import strategies as st

from bumpless.node.pacing import FreeClock, WallClock

PERIOD = 50_000_000  # ns
TICK = 1_000  # ns that reading the clock takes


class VirtualTime:
    """A clock that only sleeping, reading and `work` move; a sleep ends `oversleep` late."""

    def __init__(self) -> None:
        self.now_ns = 123_456_789
        self.oversleep = 0

    def now(self) -> int:
        self.now_ns += TICK
        return self.now_ns

    def sleep(self, seconds: float) -> None:
        self.now_ns += round(seconds * 1e9) + self.oversleep

    def work(self, duration_ns: int) -> None:
        self.now_ns += duration_ns


def clock_on(time: VirtualTime) -> WallClock:
    clock = WallClock(PERIOD, time.now, time.sleep)
    clock.start()
    return clock


def test_a_thousand_cycles_stay_on_the_grid() -> None:
    """No drift: the thousandth cycle starts a thousand periods after the start, less than a spin late."""
    time = VirtualTime()
    clock = clock_on(time)
    begin = time.now_ns
    for _ in range(1000):
        assert clock.wait() <= 2 * TICK
        time.work(7_000_000)
    assert 0 <= time.now_ns - 7_000_000 - begin - 1000 * PERIOD <= 3 * TICK
    assert clock.missed == 0


def test_a_sleep_that_ends_late_is_lateness_but_not_a_missed_cycle() -> None:
    """A cycle less than a period late keeps its place; the next one is on time again."""
    time = VirtualTime()
    clock = clock_on(time)
    time.oversleep = 20_000_000
    assert 19_000_000 < clock.wait() < 20_000_000
    time.oversleep = 0
    assert clock.wait() <= 2 * TICK
    assert clock.missed == 0


def test_deadlines_that_passed_are_counted_and_left_out() -> None:
    """After standing still for 3.5 periods one cycle is flown at once, the next at its own deadline."""
    time = VirtualTime()
    clock = clock_on(time)
    clock.wait()
    time.work(round(4.5 * PERIOD))
    late = clock.wait()
    assert late // PERIOD == 3
    assert clock.missed == 3
    assert clock.wait() <= 2 * TICK
    assert clock.missed == 3


@given(st.lists(st.integers(min_value=0, max_value=6 * PERIOD), min_size=1, max_size=50))
def test_flown_and_missed_cycles_together_are_the_deadlines_that_passed(work: list[int]) -> None:
    """Whatever the load: no deadline is lost from the account."""
    time = VirtualTime()
    clock = clock_on(time)
    begin = time.now_ns
    for duration in work:
        clock.wait()
        time.work(duration)
    clock.wait()
    passed = (time.now_ns - begin) // PERIOD
    assert len(work) + 1 + clock.missed == passed


def test_virtual_time_advances_by_exactly_one_period_per_cycle() -> None:
    """A mission flown faster than the clock still carries the stamps of its own rate."""
    clock = FreeClock(PERIOD, start_time_ns=10**18)
    clock.start()
    for count in range(1, 100):
        assert clock.wait(hurry=True) == 0
        assert clock.time_ns() == 10**18 + count * PERIOD
