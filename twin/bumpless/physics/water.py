"""Water in motion: a mean current, slow gusts and one regular deep-water wave train.

Source: Fossen 2021, ch. 10 (irrotational current, Gauss-Markov variation); linear wave theory.
"""

from math import cos, exp, pi, sin, sqrt

from bumpless.jit import jit

GRAVITY = 9.80665  # m/s^2, standard


@jit
def water_velocity(truth, gust, time, position, velocity, acceleration):
    """Fill velocity (3,) m/s and acceleration (3,) m/s^2 of the water at a NED position, in NED.

    gust (3,): present deviation from the mean current, m/s, taken constant over a step.
    """
    for k in range(3):
        velocity[k] = truth.current[k] + gust[k]
        acceleration[k] = 0.0
    if truth.wave_height <= 0.0 or truth.wave_period <= 0.0:
        return
    omega = 2.0 * pi / truth.wave_period
    wave_number = omega * omega / GRAVITY
    cb, sb = cos(truth.wave_direction), sin(truth.wave_direction)
    phase = wave_number * (position[0] * cb + position[1] * sb) - omega * time
    speed = 0.5 * truth.wave_height * omega * exp(-wave_number * max(position[2], 0.0))
    cp, sp = cos(phase), sin(phase)
    velocity[0] += speed * cp * cb
    velocity[1] += speed * cp * sb
    velocity[2] -= speed * sp
    acceleration[0] += speed * omega * sp * cb
    acceleration[1] += speed * omega * sp * sb
    acceleration[2] += speed * omega * cp


@jit
def step_gust(truth, gust, dt, noise):
    """Advance the horizontal gusts by dt: first-order Gauss-Markov, stationary std `gust_std`.

    noise (3,): independent standard normal samples.
    """
    if truth.gust_std <= 0.0:
        return
    keep = exp(-dt / max(truth.gust_time, dt))
    kick = truth.gust_std * sqrt(1.0 - keep * keep)
    for k in range(2):
        gust[k] = keep * gust[k] + kick * noise[k]
