"""One cycle of docking, as the autopilot takes it. Beyond the paper.

settings: SETTINGS; s: STATE; view: DOCKING_OUTPUT; m: MEASUREMENT.
"""

from math import hypot, isfinite

from bumpless.contract.enums import APPROACH, COMPLETED, HOLD, HOVER, TIME_OVER
from bumpless.control.docking.creep import creep_mode
from bumpless.control.docking.references import (
    begin_at,
    guide_docking,
    note_brake,
    note_lag,
    rest_references,
    smooth_lateral,
    turn_away,
)
from bumpless.control.docking.stages import next_stage, see_line
from bumpless.control.docking.swerve import note_shafts, note_stop, swerves
from bumpless.control.docking.trim import note_schedule, note_tilt, trim_gains
from bumpless.control.docking.waveoff import give_up
from bumpless.control.guidance.guide import guide
from bumpless.jit import jit

_IN_PLACE_M, _IN_PLACE_RAD, _IN_PLACE_MPS = 0.13, 0.08, 0.045  # a little inside what docked means


@jit
def look_docking(dt, plan, model, feedback, sighted, s, situation, view):
    """Fill the observation point for the approach heading in use, the range to it (3-D, m) and the view.

    feedback (8,): of the actuators, as measured; sighted: 1 in a cycle with a camera frame that shows the
    target where it may be.
    """
    docking, navigation, station = s.docking, s.navigation, situation.station
    docking.fix_age = 0 if sighted == 1 else docking.fix_age + 1
    see_line(dt, plan, navigation, s.supervisor.detected, station, docking, view)
    smooth_lateral(dt, navigation, docking)
    note_shafts(dt, model, feedback, s.allocation.u, docking)
    station[3], eta = docking.heading, navigation.eta
    situation.range = hypot(hypot(station[0] - eta[0], station[1] - eta[1]), station[2] - eta[2])


@jit
def start_as_found(model, m, s):
    """In a mission's first cycle: references and commands as the vehicle is found, so that nothing dips."""
    begin_at(s.navigation, s.guidance.reference, s.docking)
    for i in range(model.n_u):
        if isfinite(m.u_feedback[i]):
            s.allocation.u[i] = min(max(m.u_feedback[i], model.command_min[i]), model.command_max[i])


@jit
def stage_mode(settings, plan, model, phase, s, situation, view):
    """The mode for this cycle. A mission that is over holds station clear of the dock, or where it docked."""
    docking, mode = s.docking, s.supervisor.mode
    docked = docking.stage == APPROACH and mode == HOVER
    if phase == COMPLETED and docking.stage != HOLD and not docked:
        give_up(s.clock.cycle, settings.docking, TIME_OVER, view, docking)
    mode = next_stage(
        s.clock, settings.dt, settings.docking, settings.supervisor, plan, s.navigation, s.guidance.leg, mode,
        situation.station, view, docking,
    )  # fmt: skip
    situation.station[3] = docking.heading
    if plan.dock == 1:
        nose = model.rings.x[0]
        mode = creep_mode(s.clock.cycle, settings.dt, settings.docking, plan, nose, mode, view, docking)
    return mode


@jit
def is_in_place(s, holding, d, view):
    """Whether the vehicle hovers at the observation point as docked: in place, straight and still."""
    nu = s.navigation.nu
    still = hypot(nu[0], nu[1]) <= _IN_PLACE_MPS
    hovers = s.supervisor.mode == HOVER and s.docking.stage == APPROACH and not holding
    return hovers and d <= _IN_PLACE_M and view.off <= _IN_PLACE_RAD and still


@jit
def refer_docking(settings, plan, s, situation, sway, view, out):
    """References of this cycle: by the stage, or of holding station while paused. out: GUIDANCE_OUTPUT."""
    if situation.holding == 1:
        rest_references(view, s.docking)
        psi_d = s.guidance.reference[5]
        guide(settings.dt, settings.guidance, plan, s.navigation, situation, sway, s.guidance, out)
        if swerves(plan, s.navigation, s.docking):  # a pause is no brake either
            s.guidance.reference[5] = psi_d
            turn_away(settings, plan, s.navigation, s.guidance.reference, s.docking)
    else:
        guide_docking(settings.dt, settings, plan, s, situation, view, out)


@jit
def trim_docking(settings, model, schedule, s, view, gains):
    """Change this cycle's GAINS for docking. schedule: share of the fin channels' gains."""
    reference, navigation = s.guidance.reference, s.navigation
    note_schedule(schedule, view, s.docking)
    u, u_r = navigation.nu[0], navigation.smooth_nu_r[0]
    note_lag(settings.dt, reference[0], u, s.docking)
    note_brake(settings.dt, model, s.allocation.tau_c[0], u, u_r, s.docking)
    note_stop(model, u, u_r, s.docking)
    errors, z_force = s.pid.smooth, s.switching.now.tau_d[2]
    note_tilt(settings.dt, model, navigation.eta[3], z_force, u_r, s.docking)
    trim_gains(settings.docking, model, navigation, reference[0], errors, z_force, view, s.docking, gains)
