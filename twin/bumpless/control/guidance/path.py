"""Following legs, in F and R.

Beyond the paper: after a missed approach in F the vehicle returns to the start of the last leg and
tries again.
"""

from math import cos, hypot, sin

from bumpless.contract.enums import FORWARD, REVERSE
from bumpless.control.guidance.drift import FULL_FLOW, crab, least_speed
from bumpless.control.guidance.law import steer
from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.frames import direction, wrap

_RUNWAY = 14.0  # m added to the last leg after a missed approach: three turning radii of a slow torpedo
_NEAR = 0.5  # m before the observation point from which the approach speed fades out


@jit
def leg_ends(plan, leg, point, start, end):
    """Fill start and end (3,) of a leg. Leg n_legs - 1 ends at the observation point; leg n_legs leads
    back after a missed approach, past the last leg's start so that there is room to turn and align."""
    last = plan.n_legs - 1
    for k in range(3):
        if leg > last:
            start[k], end[k] = point[k], plan.waypoint[last, k]
        else:
            start[k] = plan.waypoint[leg, k]
            end[k] = point[k] if leg == last else plan.waypoint[leg + 1, k]
    if leg > last:
        dx, dy = end[0] - start[0], end[1] - start[1]
        stretch = _RUNWAY / max(hypot(dx, dy), 1e-6)
        end[0] += stretch * dx
        end[1] += stretch * dy


@jit
def next_leg(settings, situation, last, left, guidance):
    """In F: the next leg near a leg's end; back for another approach when the target was passed unseen."""
    if guidance.leg < last and left <= settings.look_ahead * 0.5:
        guidance.leg, guidance.b = guidance.leg + 1, 0.0
    elif guidance.leg == last and left < -settings.look_ahead and situation.detected == 0:
        guidance.leg, guidance.b = last + 1, 0.0
    elif guidance.leg > last and left <= settings.look_ahead:
        guidance.leg, guidance.b = last, 0.0


@jit
def follow_path(dt, settings, plan, navigation, situation, guidance, out):
    """References in F and R. Returns (u goal, z goal, psi_d)."""
    start, end, last = floats(3), floats(3), plan.n_legs - 1
    eta, current = navigation.eta, navigation.current
    if situation.mode != FORWARD and guidance.leg != last:
        guidance.leg = last
    leg_ends(plan, guidance.leg, situation.station, start, end)
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = max(hypot(dx, dy), 1e-6)
    heading = direction(dx, dy) if length > 0.05 else plan.target[3]
    ch, sh = cos(heading), sin(heading)
    s = (eta[0] - start[0]) * ch + (eta[1] - start[1]) * sh
    y_e = -(eta[0] - start[0]) * sh + (eta[1] - start[1]) * ch
    left = length - s
    out.cross_track, out.along_track = y_e, left
    if situation.mode == FORWARD:
        next_leg(settings, situation, last, left, guidance)
    if situation.mode == REVERSE:
        near = min(max(left / _NEAR, 0.0), 1.0)
        u_goal = settings.reverse_slope * left + near * settings.reverse_offset
        if left > 0.0:
            u_goal = max(u_goal, near * least_speed(settings, current, heading))
        u_goal = min(max(u_goal, -0.5 * settings.reverse_max), settings.reverse_max)
    else:
        u_goal = plan.speed[min(guidance.leg, last)]
        # legs give the speed through water
        u_goal += settings.crab_gain * (current[0] * ch + current[1] * sh)
        if situation.first == 1 and settings.crab_gain > 0.0:
            guidance.reference[0] = u_goal
        if guidance.leg >= last and situation.slow == 1:
            u_goal = min(u_goal, settings.reverse_max)
    share = min(max((s + settings.look_ahead) / length, 0.0), 1.0)
    z_goal = start[2] + share * (end[2] - start[2])
    if situation.mode == REVERSE and left < 0.0:
        y_e *= min(max(situation.u_r / FULL_FLOW, -1.0), 1.0)  # going astern turns the law round
    psi_d = steer(dt, settings, heading, y_e, situation.adapt == 1, guidance)
    return u_goal, z_goal, wrap(psi_d + crab(settings, situation, current, heading))
