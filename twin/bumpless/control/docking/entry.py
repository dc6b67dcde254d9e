"""The way round to the beginning of the approach line, clear of the dock.

Beyond the paper. The line is joined on a circle that is tangent to it where it begins; the way there is tangent
to that circle, and to the keep-out circle about the marker where that is in the way.
"""

from math import asin, atan, cos, hypot, pi, sin

from bumpless.control.docking.heading import along_across
from bumpless.jit import jit
from bumpless.physics.frames import direction, wrap


@jit
def circle_heading(settings, eta, point, docking):
    """(heading, far): tangent to the turning circle at the line's beginning, rad, and m to its centre.

    point (3,): the observation point, NED.
    """
    c, s = cos(docking.heading), sin(docking.heading)
    radius, side = settings.turn_radius, float(docking.side)
    # side 1: clockwise turn, centre to starboard of the line
    cx = point[0] - settings.entry_distance * c - side * radius * s
    cy = point[1] - settings.entry_distance * s + side * radius * c
    dx, dy = cx - eta[0], cy - eta[1]
    far = max(hypot(dx, dy), 1e-6)
    if far > radius:
        return direction(dx, dy) - side * asin(radius / far), far
    return direction(dx, dy) - side * (0.5 * pi + atan((radius - far) / (0.5 * radius))), far


@jit
def clear_heading(settings, eta, target, heading, far):
    """`heading` (rad) turned away from the keep-out circle about the target (3,), where it leads into it.

    far: m to the centre of the turning circle; a dock behind it is no obstacle.
    """
    dx, dy = target[0] - eta[0], target[1] - eta[1]
    off, keep = max(hypot(dx, dy), 1e-6), settings.keep_out
    bearing = direction(dx, dy)
    aside = wrap(heading - bearing)
    least = 0.5 * pi + 0.5 * (keep - off) / keep if off < keep else asin(keep / off)
    if abs(aside) < least and off < far + keep:
        return bearing + (least if aside >= 0.0 else -least)
    return heading


@jit
def entry_references(settings, plan, navigation, point, docking):
    """(u goal, z goal, psi_d) on the way round; drift is made good by a crab angle."""
    eta, target, current = navigation.eta, navigation.target, navigation.current
    heading, far = circle_heading(settings, eta, point, docking)
    heading = wrap(clear_heading(settings, eta, target, heading, far))
    along, across = along_across(current, heading)
    speed = plan.speed[plan.n_legs - 1]
    crab = asin(min(max(-across / speed, -settings.crab_far), settings.crab_far))
    return speed + along, target[2], wrap(heading + crab)
