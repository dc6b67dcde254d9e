"""Noise beside a cycle's row of samples: numbers that follow from a flight's key, the cycle and a channel.

Sensors that a vehicle lacks draw nothing, so that a flight without them is the same to the bit as before
there were any; and each number is the same whatever else is drawn.

Source: Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators" (SplitMix64's finaliser);
Box and Muller 1958.
"""

from math import cos, log, pi, sqrt

import numpy as np

from bumpless.jit import inline, jit

u8 = np.uint64

# what is drawn: one channel each
(
    HEADING_WALK,
    CONTRAST,
    FALSE_SIGHT,
    FALSE_RANGE,
    FALSE_BEARING,
    FALSE_ELEVATION,
    USBL_LOST,
    USBL_FALSE,
    USBL_RANGE,
    USBL_BEARING,
    USBL_ELEVATION,
) = range(11)

_GOLDEN = u8(0x9E3779B97F4A7C15)
_M1, _M2 = u8(0xBF58476D1CE4E5B9), u8(0x94D049BB133111EB)
_S30, _S27, _S31, _S11 = u8(30), u8(27), u8(31), u8(11)
_ULP = 2.0**-53


@inline
def _mix(z):
    z = (z ^ (z >> _S30)) * _M1
    z = (z ^ (z >> _S27)) * _M2
    return z ^ (z >> _S31)


@jit
def uniform(key, cycle, channel):
    """A number evenly between 0 and 1, both left out. key: of the flight, unsigned."""
    z = _mix(_mix(key + u8(cycle) * _GOLDEN) + u8(channel + 1) * _GOLDEN)
    return ((z >> _S11) + 0.5) * _ULP


@jit
def normal(key, cycle, channel):
    """A standard normal sample."""
    a, b = uniform(key, cycle, 2 * channel + 1000), uniform(key, cycle, 2 * channel + 1001)
    return sqrt(-2.0 * log(a)) * cos(2.0 * pi * b)
