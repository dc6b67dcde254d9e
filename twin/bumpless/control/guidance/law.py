"""The path-following law: from the cross-track error to a heading.

Source: Gao et al. 2026, eq. (41) (adaptive line of sight); Fossen & Aguiar 2024, Automatica 163
(uniform semiglobal exponential law, `AALOS`).
"""

from math import atan, sqrt

from bumpless.config.parameters.records import word_codes
from bumpless.jit import jit
from bumpless.physics.frames import wrap

ALOS, AALOS = word_codes("guidance", "law")


@jit
def steer(dt, settings, path_heading, y_e, adapt, guidance):
    """psi_d of the chosen law, rad; updates guidance.b where it may `adapt`. y_e: cross-track error, m.

    Source: Gao et al. 2026, eq. (41).
    """
    delta = settings.look_ahead
    if settings.law == AALOS:
        if adapt:
            guidance.b += dt * settings.gamma * delta * y_e / sqrt(delta * delta + y_e * y_e)
            guidance.b = min(max(guidance.b, -0.6), 0.6)
        return wrap(path_heading - guidance.b - atan(y_e / delta))
    if adapt:
        guidance.b += dt * settings.gamma * y_e
        guidance.b = min(max(guidance.b, -delta), delta)
    return wrap(path_heading - atan((y_e + guidance.b) / delta))
