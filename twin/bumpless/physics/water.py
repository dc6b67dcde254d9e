"""Water in motion: a mean current, its change with depth, slow gusts, a dock's wake and one wave train.

Source: Fossen 2021, ch. 10 (irrotational current, Gauss-Markov variation); linear wave theory.
"""

from math import cos, exp, pi, sin, sqrt

import numpy as np

from bumpless.config.capacity import MAX_PROFILE
from bumpless.jit import jit
from bumpless.physics.dock.record import DOCK
from bumpless.physics.lag import decay
from bumpless.physics.surface import GRAVITY
from bumpless.physics.wake import shelter, step_eddies

f8, i8 = np.float64, np.int64

ENVIRONMENT = np.dtype(  # what acts on a vehicle besides itself
    [
        ("current", f8, 3),  # NED mean, m/s
        ("n_profile", i8),
        ("profile_depth", f8, MAX_PROFILE),  # m, ascending
        ("profile_current", f8, (MAX_PROFILE, 3)),  # NED, m/s, added to the mean
        ("gust_std", f8),  # m/s
        ("gust_time", f8),  # s
        ("shelter_width", f8),  # m, of the body that shelters; 0: none
        ("shelter_place", f8, 3),  # NED, m
        ("shelter_drag", f8),  # its drag coefficient
        ("shelter_growth", f8),  # of the wake's width per metre downstream
        ("shelter_turbulence", f8),  # deviation of eddies, as a share of the current taken away
        ("wave_height", f8),  # m
        ("wave_period", f8),  # s
        ("wave_direction", f8),  # rad, towards
        ("wave_second_order", i8),  # 1: with the convective acceleration
        ("surface", i8),  # 1: a hull that comes out of the water loses buoyancy
        ("tau_e", f8, 6),  # constant external load, N and N m
        ("dock", DOCK),
    ],
    align=True,
)


@jit
def water_velocity(environment, gust, time, position, velocity, acceleration):
    """Fill velocity (3,) m/s and acceleration (3,) m/s^2 of the water at a NED position, in NED.

    gust (6,): present deviation from the mean current, m/s, and eddies of unit deviation; both taken
    constant over a step. The acceleration is that of the waves; that of water which flows through shear or
    wake is left out (behind a dock of 1 m in 0.1 m/s it is below 0.001 m/s^2 from 6 m on).
    """
    for k in range(3):
        velocity[k] = environment.current[k] + gust[k]
        acceleration[k] = 0.0
    if environment.n_profile > 0:
        add_profile(environment, position[2], velocity)
    if environment.shelter_width > 0.0:
        shelter(environment, gust, position, velocity)
    if environment.wave_height > 0.0 and environment.wave_period > 0.0:
        add_wave(environment, time, position, velocity, acceleration)


@jit
def add_profile(environment, depth, velocity):
    """Add the profile's current at `depth` to velocity (3,): linear between its depths, constant beyond."""
    last = environment.n_profile - 1
    i = 0
    while i < last and environment.profile_depth[i + 1] < depth:
        i += 1
    j = min(i + 1, last)
    step = environment.profile_depth[j] - environment.profile_depth[i]
    share = (depth - environment.profile_depth[i]) / step if step > 0.0 else 0.0
    share = min(1.0, max(0.0, share))
    for k in range(3):
        low, high = environment.profile_current[i, k], environment.profile_current[j, k]
        velocity[k] += low + share * (high - low)


@jit
def add_wave(environment, time, position, velocity, acceleration):
    """Add a regular deep-water wave's orbital velocity and acceleration at a NED position.

    With `wave_second_order` the acceleration has its convective part (u . grad) u = grad |u|^2 / 2, which
    for deep water is -k u^2 along the vertical at all times: the suction towards the surface. It acts on
    displaced and added mass alike; how the surface changes the added mass close below it is left out.

    Source: Taylor 1928, Proc. R. Soc. A 120, 260 (force on a body in non-uniform flow); Ogilvie 1963,
    J. Fluid Mech. 16, 451, and Lee and Newman 1971, J. Ship Res. 15, 231 (mean force on submerged bodies:
    sectional area plus added mass).
    """
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
    if environment.wave_second_order == 1:
        acceleration[2] -= wave_number * speed * speed


@jit
def step_gust(environment, gust, dt, noise):
    """Advance the horizontal gusts by dt: first-order Gauss-Markov, stationary std `gust_std`; and a wake's
    eddies.

    noise: independent standard normal samples, 3 of them, or the cycle's row where there is a wake.
    """
    if environment.gust_std > 0.0:
        keep = decay(dt, max(environment.gust_time, dt))
        kick = environment.gust_std * sqrt(1.0 - keep * keep)
        for k in range(2):
            gust[k] = keep * gust[k] + kick * noise[k]
    if environment.shelter_width > 0.0:
        step_eddies(environment, gust, dt, noise)
