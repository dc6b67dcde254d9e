"""One number for a set of flights, smaller is better: how they ended first, then how well they flew.

score = 4 * sum of PENALTY over the flights + q / (1 + q), with q the weighted mean of tracking, smoothness
and cost over those of the parameters that tuning began with. Penalties are quarters, so the sum is whole,
the rest is below 1, and no gain in tracking can pay for a single worse ending.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from bumpless.campaign.declaration import Weights
from bumpless.campaign.figures import TRACKING
from bumpless.campaign.flight import Row
from bumpless.config.declare import as_table
from bumpless.metrics.outcome import Ending

T = TypeVar("T")
PENALTY = {
    Ending.DOCKED: 0.0,
    Ending.HELD: 0.5,
    Ending.WAVED_OFF: 0.75,
    Ending.TIME_OVER: 1.0,
    Ending.INTERRUPTED: 1.0,
    Ending.ABORTED: 1.5,
    Ending.COLLIDED: 2.0,
}
_SCALE = {"depth": 0.1, "cross": 0.1, "heading": 5.0, "speed": 0.05}  # m, m, deg, m/s: errors worth as much
_RMS = {name: _SCALE[name.split("_")[1]] for name in TRACKING if name.endswith("_rms")}


@dataclass(frozen=True)
class Quality:
    """Means over flights: RMS errors over their scales, largest step, energy in J; NaN when never known."""

    tracking: float
    smoothness: float
    cost: float


def quality_of(rows: Sequence[Row]) -> Quality:
    """Of these flights, however they ended."""
    errors = np.array([[row[name] / scale for name, scale in _RMS.items()] for row in rows], float)
    return Quality(
        _mean(errors.ravel()),
        _mean(np.array([row["largest_step"] for row in rows], float)),
        _mean(np.array([row["energy_j"] for row in rows], float)),
    )


def endings(rows: Sequence[Row]) -> float:
    """The whole part of the score; never falls as flights are added."""
    return 4.0 * sum(PENALTY[row["outcome"]] for row in rows)


def score_of(rows: Sequence[Row], weights: Weights, reference: Quality) -> float:
    """See the module."""
    quality = quality_of(rows)
    total = share = 0.0
    for name, weight in as_table(weights).items():
        ratio = getattr(quality, name) / getattr(reference, name)
        if np.isfinite(ratio):
            total += weight * ratio
            share += weight
    q = total / share if share > 0.0 else 0.0
    return endings(rows) + q / (1.0 + q)


def score_interval(
    rows: Sequence[Row], weights: Weights, reference: Quality, resamples: int = 400
) -> tuple[float, float]:
    """95 % interval of the score by the bootstrap: as many flights drawn from these, again and again.

    Source: Efron 1979, Ann. Stat. 7, percentile interval. Always the same for the same flights.
    """
    scores = [score_of(drawn, weights, reference) for drawn in _drawn(rows, resamples)]
    low, high = np.percentile(scores, [2.5, 97.5])
    return float(low), float(high)


def score_gain(
    before: Sequence[Row], after: Sequence[Row], weights: Weights, reference: Quality, resamples: int = 400
) -> tuple[float, float]:
    """95 % interval of how much smaller the score is after; the same flights are drawn of both."""
    pairs = [*zip(before, after, strict=True)]
    gains = []
    for drawn in _drawn(pairs, resamples):
        one, other = zip(*drawn, strict=True)
        gains.append(score_of(one, weights, reference) - score_of(other, weights, reference))
    low, high = np.percentile(gains, [2.5, 97.5])
    return float(low), float(high)


def _drawn(of: Sequence[T], resamples: int) -> Iterator[list[T]]:
    draws = np.random.Generator(np.random.PCG64(0)).integers(len(of), size=(resamples, len(of)))
    return ([of[i] for i in draw] for draw in draws)


def _mean(values: np.ndarray) -> float:
    known = values[np.isfinite(values)]
    return float(known.mean()) if len(known) else float("nan")
