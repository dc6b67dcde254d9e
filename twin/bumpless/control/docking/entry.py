"""The way round to the beginning of the approach line, clear of the dock.

Beyond the paper. The line is joined on a circle that is tangent to it where it begins; the way there is
tangent to that circle, and to the keep-out circle about the marker where that is in the way.
"""

from math import asin, atan, cos, hypot, pi, sin, sqrt

from bumpless.control.docking.heading import along_across
from bumpless.jit import jit
from bumpless.physics.frames import direction, wrap

_LITTLE = 0.5  # rad of turn too much that is made up on the line
_FARTHER = 5  # places where the line may be joined, half a turning radius apart
_TIGHT = 0.8  # of the turning radius: the first turn leads nowhere in particular, and is flown as it comes
_ROOM = 0.8  # of the room that two circles need: what is lacking is made good on the line
_NO_WAY = 1e6  # m
_SLOWER = 1.25  # s, of the rate of turn: at 8 deg/s a sixth less speed
_SWEPT = 0.6  # of the keep-out radius: a turn that leads nearer is taken the other way
_PUSH = 2.0  # rad outwards for a vehicle in the middle of a circle it should keep out of


@jit
def choose_way(settings, keep, eta, target, point, docking):
    """Choose the shortest way round that can be flown: docking.side, 1 clockwise or -1, and docking.farther,
    by how much sooner than `entry_distance` the line is joined, m.

    Each is a turn from where the vehicle heads, a straight way and the turn on to the line (Dubins 1957). Two
    turns of opposite hands need room between their circles: where there is too little, joining farther out
    gives it, or else the vehicle would swing past the line and back. keep: radius of the keep-out circle
    about the target (3,), m; point (3,): the observation point, NED.
    Returns the length of the way to where the line begins at the latest, m.
    """
    radius = settings.turn_radius
    bearing, off, _ = tangent(keep, eta, target)
    near = off < keep + 2.0 * radius
    best = _NO_WAY
    for attempt in range(2):
        for k in range(2 * _FARTHER):
            side, farther = 1 - 2 * (k % 2), 0.5 * (k // 2) * radius
            cx, cy = circle_centre(settings, point, docking.heading, side, farther)
            for j in range(2):
                hand = 1 - 2 * j
                most, away = (1 + attempt) * pi, near and attempt == 0
                way = way_round(radius, eta, cx, cy, docking.heading, side, hand, most, away, bearing)
                if way + farther < best:
                    best, docking.side, docking.farther = way + farther, side, farther
        if best < _NO_WAY:
            break  # else any turn will do
    return best


@jit
def way_round(radius, eta, cx, cy, approach, side, hand, most, away, bearing):
    """Length of the way to the line, m, by a first turn of this hand and the turn on to the line of this
    side, about (cx, cy); none where the circles leave no room, where the first turn is greater than
    `most`, rad: the autopilot turns the short way, and where it sweeps over the dock, at `bearing`, rad, and
    should not.

    approach: heading of the line, rad.
    """
    tight = _TIGHT * radius
    dx = cx - eta[0] + hand * tight * sin(eta[5])
    dy = cy - eta[1] - hand * tight * cos(eta[5])
    apart, between = hypot(dx, dy), radius - hand * side * tight
    if apart < _ROOM * between:
        return _NO_WAY
    heading = direction(dx, dy) - side * asin(min(between / max(apart, 1e-6), 1.0))
    first, last = turn_by(hand, heading - eta[5]), turn_by(side, approach - heading)
    if first > most or (away and turn_by(hand, bearing - eta[5]) < first):
        return _NO_WAY
    return sqrt(max(apart * apart - between * between, 0.0)) + tight * first + radius * last


@jit
def turn_by(hand, angle):
    """How far a turn of this hand goes until it has turned by `angle`, rad: from 0 to less than 2 pi. One
    that would go all the way round for a little is none."""
    turn = (hand * angle) % (2.0 * pi)
    return turn if turn < 2.0 * pi - _LITTLE else 0.0


@jit
def circle_centre(settings, point, approach, side, farther):
    """(north, east) of the circle of the turn on to the line, m. side 1: clockwise, to its starboard."""
    c, s = cos(approach), sin(approach)
    begins, radius = settings.entry_distance + farther, settings.turn_radius
    return point[0] - begins * c - side * radius * s, point[1] - begins * s + side * radius * c


@jit
def circle_heading(settings, eta, point, docking):
    """(heading, far): tangent to the circle of the turn on to the line, rad, and m to its centre.

    point (3,): the observation point, NED.
    """
    radius, side = settings.turn_radius, docking.side
    cx, cy = circle_centre(settings, point, docking.heading, side, docking.farther)
    dx, dy = cx - eta[0], cy - eta[1]
    far = max(hypot(dx, dy), 1e-6)
    if far > radius:
        return direction(dx, dy) - side * asin(radius / far), far
    return direction(dx, dy) - side * (0.5 * pi + atan((radius - far) / (0.5 * radius))), far


@jit
def off_the_way(settings, eta, point, docking):
    """How far the vehicle is to starboard of the way round, m: within the turning circle it is off it, and
    elsewhere the way, a tangent to that circle, begins where the vehicle is."""
    _, far = circle_heading(settings, eta, point, docking)
    return docking.side * max(settings.turn_radius - far, 0.0)


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
    """(u goal, z goal, psi_d) on the way round; drift is made good by a crab angle, and the hull is not
    asked for more in a turn, which drags, than its screw gives."""
    eta, target, current = navigation.eta, navigation.target, navigation.current
    heading, far = circle_heading(settings, eta, point, docking)
    heading = wrap(clear_heading(settings, keep_out(settings, plan), eta, target, heading, far))
    along, across = along_across(current, heading)
    speed = plan.speed[plan.n_legs - 1] / (1.0 + _SLOWER * abs(docking.turn))
    crab = asin(min(max(-across / speed, -settings.crab_far), settings.crab_far))
    return speed + along, target[2], wrap(heading + crab)
