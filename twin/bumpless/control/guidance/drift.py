"""Making good the estimated current by a crab angle, instead of learning it.

Beyond the paper (`crab_gain`).
"""

from math import asin, atan, cos, sin, sqrt

from bumpless.contract.enums import HOVER
from bumpless.jit import jit

FULL_FLOW = 0.05  # m/s of inflow at which laws that turn the hull work in full
_ASTERN = 0.03  # m/s along the path above which a vehicle hovers stern to the current
_CRAB_MAX = 0.35  # sine of the largest crab angle: the target must stay in the camera's view


@jit
def crab(settings, situation, current, heading):
    """Angle (rad) by which to turn into the estimated current so that the track keeps `heading`.

    In H the hull lies along the current, bow or stern into it, as far as the camera's view allows.
    """
    across = -current[0] * sin(heading) + current[1] * cos(heading)
    if situation.mode == HOVER:
        along = current[0] * cos(heading) + current[1] * sin(heading)
        along = along if along > _ASTERN else min(along, -_ASTERN)
        return settings.crab_gain * atan(min(max(across / along, -_CRAB_MAX), _CRAB_MAX))
    flow = max(situation.u_r, FULL_FLOW)
    angle = asin(min(max(across / flow, -_CRAB_MAX), _CRAB_MAX))
    return -settings.crab_gain * min(max(situation.u_r / FULL_FLOW, 0.0), 1.0) * angle


@jit
def least_speed(settings, current, heading):
    """Speed over ground along `heading` at which the largest crab angle just makes good the drift, m/s."""
    along = current[0] * cos(heading) + current[1] * sin(heading)
    across = -current[0] * sin(heading) + current[1] * cos(heading)
    return settings.crab_gain * (along + abs(across) * sqrt(1.0 - _CRAB_MAX * _CRAB_MAX) / _CRAB_MAX)
