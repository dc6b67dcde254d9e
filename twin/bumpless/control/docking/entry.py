"""The way round to the beginning of the approach line, clear of the dock.

Beyond the paper. The line is joined on a circle that is tangent to it where it begins; the way there is
tangent to that circle, and to the keep-out circle about the marker where that is in the way.
"""

from math import asin, atan, cos, hypot, pi, sin, sqrt

from bumpless.control.docking.heading import along_across
from bumpless.jit import jit
from bumpless.physics.frames import direction, wrap

_LITTLE = 0.5  # rad of turn too much that is made up on the line
_SWEPT = 0.6  # of the keep-out radius: a turn that leads nearer is taken the other way
_PUSH = 2.0  # rad outwards for a vehicle in the middle of a circle it should keep out of


@jit
def nearer_side(settings, eta, point, approach):
    """The side, 1 clockwise or -1, on which the way round is the shorter one."""
    best, least = 1, 1e9
    for k in range(2):
        side = 1 - 2 * k
        way = way_round(settings, eta, point, approach, side)
        if way < least:
            best, least = side, way
    return best


@jit
def way_round(settings, eta, point, approach, side):
    """Length of the way round to the line's beginning on one side, turns at both ends included, m."""
    heading, far = circle_heading(settings, eta, point, approach, side)
    radius = settings.turn_radius
    straight = sqrt(max(far * far - radius * radius, 0.0))
    at_end = side * wrap(approach - heading)  # rad still to be turned on the circle
    arc = max(at_end, 0.0) if at_end > -_LITTLE else at_end + 2.0 * pi
    inside = 2.0 * pi * radius if far < 0.9 * radius else 0.0
    return straight + inside + radius * (arc + abs(wrap(heading - eta[5])))


@jit
def circle_heading(settings, eta, point, approach, side):
    """(heading, far): tangent to the turning circle at the line's beginning, rad, and m to its centre.

    point (3,): the observation point, NED; approach: heading of the line, rad; side: 1 clockwise, -1 not.
    """
    c, s = cos(approach), sin(approach)
    radius = settings.turn_radius
    # side 1: clockwise turn, centre to starboard of the line
    cx = point[0] - settings.entry_distance * c - side * radius * s
    cy = point[1] - settings.entry_distance * s + side * radius * c
    dx, dy = cx - eta[0], cy - eta[1]
    far = max(hypot(dx, dy), 1e-6)
    if far > radius:
        return direction(dx, dy) - side * asin(radius / far), far
    return direction(dx, dy) - side * (0.5 * pi + atan((radius - far) / (0.5 * radius))), far


@jit
def keep_out(settings, plan):
    """Radius of the circle about the target that is not entered in F, m."""
    return settings.keep_out + plan.dock_radius


@jit
def clear_heading(settings, keep, eta, target, heading, far):
    """`heading` (rad) turned away from the keep-out circle about the target (3,), where it leads into it.

    keep: its radius, m; far: m to where the way leads; a dock behind that is no obstacle.
    """
    bearing, off, least = tangent(keep, eta, target)
    aside = wrap(heading - bearing)
    if abs(aside) < least and off < far + keep:
        heading = bearing + (least if aside >= 0.0 else -least)
    if turns_into(settings, keep, eta[5], bearing, off, heading):
        return bearing + bow_side(eta[5], bearing) * least
    return heading


@jit
def bow_side(psi, bearing):
    """The side of the dock that the bow points to: 1 with the dock to port, -1 with it to starboard."""
    return 1 if wrap(psi - bearing) >= 0.0 else -1


@jit
def turns_into(settings, keep, psi, bearing, off, heading):
    """Whether the turn from psi to `heading`, rad, sweeps the bow over the dock, deep into the circle.

    The heading may be clear of the dock, and the turn to it lead through. bearing, off: of the target.
    """
    bow, turn, radius = wrap(psi - bearing), wrap(heading - psi), settings.turn_radius
    if bow * (bow + turn) >= 0.0:
        return False
    to_centre = off * sin(-bow) - (radius if turn >= 0.0 else -radius)
    return abs(hypot(off * cos(bow), to_centre) - radius) < _SWEPT * keep


@jit
def tangent(keep, eta, target):
    """(bearing, off, least): of the target, rad, its distance, m, and how far off the bearing the tangent to
    the keep-out circle lies, rad; from within the circle the tangent leads outwards."""
    dx, dy = target[0] - eta[0], target[1] - eta[1]
    off = max(hypot(dx, dy), 1e-6)
    least = 0.5 * pi + _PUSH * (keep - off) / keep if off < keep else asin(keep / off)
    return direction(dx, dy), off, least


@jit
def clear_leg(settings, plan, navigation, leg, left, heading, docking):
    """`heading` (rad) of a leg before the last, turned away from a dock that is in its way and at its depth.

    left: m to the leg's end. The side on which the dock is passed is kept, in docking.passing: the law leads
    back to the leg, and would change it every time.
    """
    target, eta = navigation.target, navigation.eta
    keep = keep_out(settings, plan)
    bearing, off, least = tangent(keep, eta, target)
    aside = wrap(heading - bearing)
    if leg >= plan.n_legs - 1 or abs(eta[2] - target[2]) > settings.keep_out + plan.dock_half:
        docking.passing = 0
        return heading
    if abs(aside) >= max(least, 0.5 * pi) or off >= left + keep:  # past, or the leg ends before it
        docking.passing = 0
    elif docking.passing == 0 and abs(aside) < least:
        docking.passing = 1 if aside >= 0.0 else -1
    if docking.passing * aside < least and docking.passing != 0:
        heading = wrap(bearing + docking.passing * least)
    if turns_into(settings, keep, eta[5], bearing, off, heading):
        docking.passing = bow_side(eta[5], bearing)
        return wrap(bearing + docking.passing * least)
    return heading


@jit
def entry_references(settings, plan, navigation, point, docking):
    """(u goal, z goal, psi_d) on the way round; drift is made good by a crab angle."""
    eta, target, current = navigation.eta, navigation.target, navigation.current
    heading, far = circle_heading(settings, eta, point, docking.heading, docking.side)
    heading = wrap(clear_heading(settings, keep_out(settings, plan), eta, target, heading, far))
    along, across = along_across(current, heading)
    speed = plan.speed[plan.n_legs - 1]
    crab = asin(min(max(-across / speed, -settings.crab_far), settings.crab_far))
    return speed + along, target[2], wrap(heading + crab)
