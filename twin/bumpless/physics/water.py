"""Water in motion: a mean current, slow gusts and one regular deep-water wave train.

Source: Fossen 2021, ch. 10 (irrotational current, Gauss-Markov variation); linear wave theory.
"""

from math import cos, exp, pi, sin, sqrt

import numpy as np

from bumpless.jit import jit
from bumpless.physics.lag import decay

f8 = np.float64

GRAVITY = 9.80665  # m/s^2, standard

ENVIRONMENT = np.dtype(  # what acts on a vehicle besides itself
    [
        ("current", f8, 3),  # NED mean, m/s
        ("gust_std", f8),  # m/s
        ("gust_time", f8),  # s
        ("wave_height", f8),  # m
        ("wave_period", f8),  # s
        ("wave_direction", f8),  # rad, towards
        ("tau_e", f8, 6),  # constant external load, N and N m
    ],
    align=True,
)


@jit
def water_velocity(environment, gust, time, position, velocity, acceleration):
    """Fill velocity (3,) m/s and acceleration (3,) m/s^2 of the water at a NED position, in NED.

    gust (3,): present deviation from the mean current, m/s, taken constant over a step.
    """
    for k in range(3):
        velocity[k] = environment.current[k] + gust[k]
        acceleration[k] = 0.0
    if environment.wave_height <= 0.0 or environment.wave_period <= 0.0:
        return
    omega = 2.0 * pi / environment.wave_period
    wave_number = omega * omega / GRAVITY
    cb, sb = cos(environment.wave_direction), sin(environment.wave_direction)
    phase = wave_number * (position[0] * cb + position[1] * sb) - omega * time
    speed = 0.5 * environment.wave_height * omega * exp(-wave_number * max(position[2], 0.0))
    cp, sp = cos(phase), sin(phase)
    velocity[0] += speed * cp * cb
    velocity[1] += speed * cp * sb
    velocity[2] -= speed * sp
    acceleration[0] += speed * omega * sp * cb
    acceleration[1] += speed * omega * sp * sb
    acceleration[2] += speed * omega * cp


@jit
def step_gust(environment, gust, dt, noise):
    """Advance the horizontal gusts by dt: first-order Gauss-Markov, stationary std `gust_std`.

    noise (3,): independent standard normal samples.
    """
    if environment.gust_std <= 0.0:
        return
    keep = decay(dt, max(environment.gust_time, dt))
    kick = environment.gust_std * sqrt(1.0 - keep * keep)
    for k in range(2):
        gust[k] = keep * gust[k] + kick * noise[k]
