"""Faults of actuators: when, how much effectiveness is left, and how it comes in."""

import numpy as np

from bumpless.config.capacity import MAX_FAULTS
from bumpless.jit import jit

f8, i8 = np.float64, np.int64

FAULTS = np.dtype(
    [
        ("n", i8),
        ("actuator", i8, MAX_FAULTS),  # index in the vehicle file's order
        ("time", f8, MAX_FAULTS),  # s
        ("effectiveness", f8, MAX_FAULTS),  # 0 to 1
        ("blend", f8, MAX_FAULTS),  # s over which it comes in
    ],
    align=True,
)


@jit
def blend_faults(faults, time, effectiveness):
    """Fill effectiveness (8,) of each actuator at `time`, s: each fault comes in over its own blend time.

    Returns how far the fault that is furthest has come in, 0 to 1.
    """
    most = 0.0
    for i in range(effectiveness.shape[0]):
        effectiveness[i] = 1.0
    for f in range(faults.n):
        elapsed = time - faults.time[f]
        if elapsed > 0.0:
            share = min(1.0, elapsed / faults.blend[f]) if faults.blend[f] > 0.0 else 1.0
            most = max(most, share)
            effectiveness[faults.actuator[f]] = 1.0 + share * (faults.effectiveness[f] - 1.0)
    return most
