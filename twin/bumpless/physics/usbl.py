"""Ultra-short baseline: range and direction of the transponder at the target, from a head on the vehicle.

The sound's way there and back (2 r / c, 0.13 s at 100 m) is not in the model: a vehicle at 1 m/s moves
0.13 m meanwhile, less than the direction's error there.

Source: Milne 1983, Underwater Acoustic Positioning Systems, ch. 5 (range by time, direction by phase, so
that the error across grows with range).
"""

from math import pi

from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.camera import view_from
from bumpless.physics.noise import (
    USBL_BEARING,
    USBL_ELEVATION,
    USBL_FALSE,
    USBL_LOST,
    USBL_RANGE,
    normal,
    uniform,
)


@jit
def measure_usbl(sensors, errors, target, plant, cycle, m):
    """Fill m.usbl when a reply is due, comes and is within range. errors: SENSOR_ERRORS."""
    m.usbl_fresh = 0
    if cycle % sensors.usbl_period != 0:
        return
    s, key, view = errors.noise_scale, errors.key, floats(3)
    view_from(sensors.usbl_position, 0.0, plant.eta, target, view)
    if view[0] > sensors.usbl_range_max or uniform(key, cycle, USBL_LOST) < sensors.usbl_dropout:
        return
    m.usbl_fresh = 1
    if s > 0.0 and uniform(key, cycle, USBL_FALSE) < sensors.usbl_outlier:  # an echo off surface or wall
        view[0] = sensors.usbl_range_max * uniform(key, cycle, USBL_RANGE)
        view[1] = pi * (2.0 * uniform(key, cycle, USBL_BEARING) - 1.0)
        view[2] = 0.5 * pi * (2.0 * uniform(key, cycle, USBL_ELEVATION) - 1.0)
    view[0] = max(0.0, view[0] + s * sensors.usbl_range_std * normal(key, cycle, USBL_RANGE))
    view[1] += s * sensors.usbl_angle_std * normal(key, cycle, USBL_BEARING)
    view[2] += s * sensors.usbl_angle_std * normal(key, cycle, USBL_ELEVATION)
    for k in range(3):
        m.usbl[k] = view[k]  # a reply that is missed tells nothing
