"""The wake of a dock: sheltered water behind it, with eddies.

Source: Bastankhah and Porte-Agel 2014, Renewable Energy 70, 116 (a wake of Gaussian section whose deficit
follows from the body's drag by conservation of momentum).
Differs: a solid body, not a disc, so the wake begins with dead water, sigma_0 = d sqrt(C_D / 8); within one
width behind the body it is blended in.
"""

from math import exp, hypot, sqrt

from bumpless.jit import jit
from bumpless.physics.lag import decay

_SLOWEST = 0.01  # m/s, of the current that carries eddies along
_EDDIES = 21  # first sample of the cycle's row


@jit
def shelter(environment, gust, position, velocity):
    """Slow down velocity (3,) where it is behind the body, and stir it; what flows sideways flows on.

    gust (6,): eddies of unit deviation from 3 on.
    """
    speed = hypot(velocity[0], velocity[1])
    if speed <= 0.0:
        return
    north, east = velocity[0] / speed, velocity[1] / speed
    place, d = environment.shelter_place, environment.shelter_width
    n, e, down = position[0] - place[0], position[1] - place[1], position[2] - place[2]
    behind, aside = n * north + e * east, e * north - n * east
    if behind <= 0.0:
        return
    spread = sqrt(environment.shelter_drag / 8.0) + environment.shelter_growth * behind / d  # sigma / d
    left = 1.0 - environment.shelter_drag / (8.0 * spread * spread)
    deficit = 1.0 - sqrt(max(0.0, left))
    deficit *= exp(-0.5 * (aside * aside + down * down) / (spread * d * spread * d))
    if behind < d:
        share = behind / d
        deficit *= share * share * (3.0 - 2.0 * share)
    stir = environment.shelter_turbulence * speed * deficit
    for k in range(3):
        if k < 2:
            velocity[k] *= 1.0 - deficit
        velocity[k] += stir * gust[3 + k]


@jit
def step_eddies(environment, gust, dt, noise):
    """Advance the eddies gust[3:6] by dt: Gauss-Markov of unit deviation, as long as the current takes to
    pass the body."""
    speed = hypot(environment.current[0], environment.current[1])
    keep = decay(dt, max(dt, environment.shelter_width / max(speed, _SLOWEST)))
    kick = sqrt(1.0 - keep * keep)
    for k in range(3):
        gust[3 + k] = keep * gust[3 + k] + kick * noise[_EDDIES + k]
