"""Past the dock where the brake would not stop the vehicle before it. Beyond the paper.

A vehicle that was waved off because it doesn't brake, and that comes nearer all the same, still has its fins:
it turns away from the dock for as long as it goes ahead.
"""

from math import hypot, isfinite, sin

from bumpless.contract.enums import BACK, HOLD, TOO_SLOW
from bumpless.control.docking.entry import keep_out, tangent
from bumpless.control.docking.heading import along_across
from bumpless.control.docking.surge import SURE_DRAG, surge_drag, surge_mass
from bumpless.jit import jit
from bumpless.physics.actuators import FIN
from bumpless.physics.frames import wrap
from bumpless.physics.lag import lag

_AHEAD = 0.5  # of an actuator's push along x_b, from which on it is a brake
_AT_REST = 0.06  # m/s over ground, at which there is nothing to turn away from
_UNSURE = 0.03  # m/s of what a brake has taken off: of so little nothing is known
_LEAST = 1e-4  # m/s^2
_GUARD = 0.3  # m that the nose keeps off the dock
_SURE = 0.5  # of the room in which it stops ends a turn away
_STRAIGHT = 0.05  # rad off the dock's bearing within which the current chooses the side
_T_SLIP = 1.5  # s, smoothing of what shafts stay behind their commands
SLIP_MOST = 0.75  # rev/s of it: a shaft that sticks


@jit
def note_shafts(dt, model, feedback, command, docking):
    """Smooth by how much a shaft that brakes stays behind its command, rev/s: the largest of them.

    feedback (8,): as measured; command (8,): of the cycle before.
    """
    most = 0.0
    for i in range(model.n_u):
        brakes = model.kind[i] != FIN and abs(model.direction[i, 0]) > _AHEAD
        if brakes and isfinite(feedback[i]) and abs(feedback[i] - command[i]) > abs(most):
            most = feedback[i] - command[i]
    docking.slip += lag(dt, _T_SLIP) * (most - docking.slip)


@jit
def note_stop(model, u, u_r, docking):
    """Fill docking.stops, the way in which a vehicle at u, m/s, comes to rest by what its brake has done of
    late and its drag, m. u_r: through water."""
    if docking.reason != TOO_SLOW:
        return
    astern = 0.0
    for i in range(model.n_u):
        if model.kind[i] != FIN and abs(model.direction[i, 0]) > _AHEAD:
            astern += model.T_nn_reverse[i] * model.command_min[i] ** 2
    works = (docking.braked - docking.unbraked - _UNSURE) / max(docking.braked, _UNSURE)
    push = min(max(works, 0.0), 1.0) * astern + SURE_DRAG * max(surge_drag(model, u_r), 0.0)
    docking.stops = 0.5 * u * max(u, 0.0) / max(push / surge_mass(model), _LEAST)


@jit
def swerves(plan, navigation, docking):
    """Whether the vehicle would not stop before the dock, and turns away from it."""
    given_up = (docking.stage == BACK or docking.stage == HOLD) and docking.reason == TOO_SLOW
    if not given_up or navigation.nu[0] < _AT_REST:
        docking.passing = 0
        return False
    eta, target = navigation.eta, navigation.target
    room = hypot(target[0] - eta[0], target[1] - eta[1]) - plan.nose - _GUARD
    return docking.stops > (_SURE * room if docking.passing != 0 else room)


@jit
def is_past(settings, plan, navigation, docking):
    """Whether the dock lies abaft, out of the way of a vehicle that turned away from it."""
    bearing, off, _ = tangent(keep_out(settings, plan), navigation.eta, navigation.target)
    return (
        docking.passing != 0
        and off > keep_out(settings, plan)
        and abs(wrap(navigation.eta[5] - bearing)) > 1.6
    )


@jit
def swerve_heading(settings, plan, navigation, docking):
    """psi_d that leads past the dock, rad: on the side to which the bow points, or the water flows."""
    eta = navigation.eta
    bearing, _, least = tangent(keep_out(settings, plan), eta, navigation.target)
    aside = wrap(eta[5] - bearing)
    if docking.passing == 0:
        _, across = along_across(navigation.current, bearing)
        side = aside if abs(aside) > _STRAIGHT else across + 1e-3 * sin(aside)
        docking.passing = 1 if side >= 0.0 else -1
    return wrap(bearing + docking.passing * max(least, docking.passing * aside))
