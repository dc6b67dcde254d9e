"""First-order lags, sampled: what is left of a gap after some time, and what is closed."""

from math import exp, isfinite

from bumpless.jit import inline


@inline
def decay(dt, T):
    """exp(-dt / T): share of a gap that is left after dt seconds of a lag with time constant T > 0, s."""
    return exp(-dt / T)


@inline
def lag(dt, T):
    """1 - exp(-dt / T): share of a gap that is closed after dt seconds; 1 where T is no lag at all."""
    return 1.0 - exp(-dt / T) if T > 0.0 else 1.0


@inline
def follow(value, sample, gain):
    """value moved towards a sample by the share gain; a sample that is no number moves nothing."""
    return value + gain * (sample - value) if isfinite(sample) else value
