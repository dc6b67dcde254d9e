"""How far an approach may be turned off a dock's axis: the nose must stay before the dock's face."""

import math

from bumpless.config.mission.model import Target
from bumpless.config.vehicle import Vehicle
from bumpless.control.docking.gates import NOSE_GUARD

_ASIDE_M = 0.12  # offset in H that is waited out
_SLACK_M = 0.1  # for what gusts and the camera's error add


def turn_limit_deg(target: Target, vehicle: Vehicle) -> float:
    """The largest angle off the dock's axis at which a hull in place keeps its nose clear, 0 to 90 deg.

    (standoff - nose) cos a - aside sin a >= guard + slack: turned by a, the nose stands nearer to the face,
    and an offset takes it nearer still.
    """
    before = target.standoff_m - vehicle.ends_m[0]
    reach, needed = math.hypot(before, _ASIDE_M), NOSE_GUARD + _SLACK_M
    if before <= needed:
        return 0.0
    return math.degrees(math.acos(needed / reach) - math.atan2(_ASIDE_M, before))


def turn_used_deg(target: Target, vehicle: Vehicle) -> float:
    """By how much the vehicle turns the approach at most: the mission's tolerance, within that limit."""
    return target.turn_deg if target.turns else min(target.turn_deg, turn_limit_deg(target, vehicle))
