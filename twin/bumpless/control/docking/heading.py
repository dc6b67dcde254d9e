"""Which approach heading, and whether station can be held at it: the vehicle's bow belongs into the current.

Beyond the paper. The current V_c in the horizontal plane is split about a heading psi:
along = V_N cos psi + V_E sin psi (positive from astern), across = -V_N sin psi + V_E cos psi (to starboard).
"""

from math import cos, hypot, sin

from bumpless.contract.enums import APPROACH, ENTRY
from bumpless.jit import jit
from bumpless.physics.frames import direction, wrap

_STILL = 0.006  # m/s of current below which any heading will do
_KNOWN = 0.02  # m/s: a weaker current has no sure way, one of twice this is known in full


@jit
def along_across(current, heading):
    """(along, across) of a current (3,), NED m/s, about a heading, rad."""
    c, s = cos(heading), sin(heading)
    return current[0] * c + current[1] * s, -current[0] * s + current[1] * c


@jit
def bearable(settings, along):
    """Current across that station can be held in, m/s, beside a current of `along`; negative where none.

    Fins hold the bow by the flow over them: what they can hold grows with the head current, -along.
    settings: DOCKING_SETTINGS, fitted to flights with every check off.
    """
    if along > settings.following:
        return -1.0
    return settings.side_still + settings.side_share * max(-along, 0.0)


@jit
def holdable(settings, current, heading):
    """Whether station can be held at `heading`, rad, in a current (3,), NED m/s."""
    along, across = along_across(current, heading)
    return abs(across) <= bearable(settings, along)


@jit
def turned(given, tolerance, heading):
    """The heading within `tolerance` of the given one that is nearest to `heading`; all rad."""
    return wrap(given + min(max(wrap(heading - given), -tolerance), tolerance))


@jit
def choose_heading(settings, plan, current):
    """The approach heading inside the tolerance that is nearest to straight into the current (3,), rad; where
    station can't be held at that, but stern to the current it can, the one nearest to that."""
    if plan.heading_tolerance <= 0.0 or hypot(current[0], current[1]) < _STILL:
        return plan.target[3]
    into = turned(plan.target[3], plan.heading_tolerance, direction(-current[0], -current[1]))
    if holdable(settings, current, into):
        return into
    stern = turned(plan.target[3], plan.heading_tolerance, direction(current[0], current[1]))
    return stern if holdable(settings, current, stern) else into


@jit
def follow_current(dt, settings, plan, current, left, docking):
    """Turn docking.heading with the estimated current, slowly where the line is being flown."""
    approaching = docking.stage == APPROACH
    if plan.heading_tolerance > 0.0 and (
        docking.stage == ENTRY or (approaching and left > settings.turn_until)
    ):
        time = settings.turn_time if approaching else 0.5 * settings.turn_time
        known = min(max((hypot(current[0], current[1]) - _KNOWN) / _KNOWN, 0.0), 1.0)
        turn = known * dt / time * wrap(choose_heading(settings, plan, current) - docking.heading)
        docking.heading = wrap(docking.heading + turn)


@jit
def weathervane(dt, settings, plan, psi, u_r, docking):
    """In H let docking.heading follow the hull's psi, rad: it knows best where the current comes from.

    u_r: speed through water, m/s; at rest in the water the hull knows nothing, and stern to the current it
    knows worst.
    """
    if plan.heading_tolerance > 0.0:
        step = dt / settings.weathervane * min(max((u_r - 0.02) / 0.03, 0.0), 1.0)
        wanted = docking.heading + step * wrap(psi - docking.heading)
        docking.heading = turned(plan.target[3], plan.heading_tolerance, wanted)
