"""The numbers in topic "health" are read by operators as promises: they may overstate, never understate."""

from hypothesis import given
from hypothesis import strategies as st

from bumpless.node.histogram import Histogram

durations = st.lists(st.integers(min_value=0, max_value=(1 << 44) - 1), min_size=1, max_size=200)


@given(durations, st.floats(min_value=0.01, max_value=1.0))
def test_percentile_is_at_most_one_bin_above_the_exact_one(values: list[int], share: float) -> None:
    """The exact quantile <= the told one <= 1/16 more, and never beyond the maximum."""
    histogram = Histogram()
    for value in values:
        histogram.add(value)
    needed = share * len(values)
    exact = next(v for i, v in enumerate(sorted(values), start=1) if i >= needed)
    told = histogram.percentile(share)
    assert exact <= told <= min(exact + exact // 16 + 1, max(values))


def test_extremes_are_counted() -> None:
    """A frozen process shows hours of lateness; a clock that steps back must not break the count."""
    histogram = Histogram()
    for value in (-5, 0, 10**18):
        histogram.add(value)
    assert histogram.total == 3
    assert histogram.maximum == 10**18
    assert histogram.percentile(0.5) == 0


def test_an_empty_histogram_says_zero() -> None:
    """Health is told before the first cycle has been counted."""
    assert Histogram().percentile(0.99) == 0
