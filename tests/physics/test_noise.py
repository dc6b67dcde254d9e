"""Noise beside the row: even, normal, and its own for each flight, cycle and channel."""

import numpy as np
import pytest
from scipy import stats

from bumpless.physics.noise import normal, uniform

KEY = np.uint64(2**63 + 12345)


def test_numbers_are_even_and_normal() -> None:
    """Protects: the distributions that every rare event and error of the newer sensors is drawn from."""
    even = np.array([uniform(KEY, k, 3) for k in range(20_000)])
    bell = np.array([normal(KEY, k, 3) for k in range(20_000)])
    assert 0.0 < even.min() and even.max() < 1.0
    assert stats.kstest(even, "uniform").pvalue > 0.01
    assert stats.kstest(bell, "norm").pvalue > 0.01


@pytest.mark.parametrize("other", [(KEY, 1, 3), (KEY, 0, 4), (np.uint64(7), 0, 3)], ids=str)
def test_cycles_channels_and_flights_have_nothing_in_common(other: tuple) -> None:
    """Protects: two errors never move together, nor two flights."""
    ours = np.array([normal(KEY, k, 3) for k in range(5000)])
    theirs = np.array([normal(other[0], k + other[1], other[2]) for k in range(5000)])
    assert abs(np.corrcoef(ours, theirs)[0, 1]) < 0.05
    assert np.array_equal(ours, [normal(KEY, k, 3) for k in range(5000)])
