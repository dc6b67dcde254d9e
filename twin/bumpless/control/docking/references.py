"""References that the vehicle can follow: speed without jerk, depth by pitch where the fins have flow.

Beyond the paper. reference (6,) = [u_d v_d z_d phi_d theta_d psi_d], m/s, m and rad.
"""

from math import asin, atan, cos, sin

from bumpless.contract.enums import BACK, CREEP, ENTRY, OFF_HEADING, OVERSHOT, TOO_SLOW, TRANSIT
from bumpless.control.docking.creep import creep_references
from bumpless.control.docking.entry import clear_leg, entry_references, off_the_way
from bumpless.control.docking.line import line_references
from bumpless.control.docking.surge import SURE_DRAG, T_MADE, surge_drag, surge_mass
from bumpless.control.docking.swerve import swerve_heading, swerves
from bumpless.control.guidance.guide import approach
from bumpless.control.guidance.path import follow_path
from bumpless.jit import inline, jit
from bumpless.physics.frames import wrap
from bumpless.physics.lag import lag

_T_LATERAL = 1.5  # s, smoothing of the speed across the line
_T_DEPTH_RATE = 1.0  # s, smoothing of the depth reference's rate
_T_LAG = 4.0  # s, smoothing of the speed error
_T_TURN = 1.0  # s, smoothing of the heading reference's rate
_T_UNBRAKED = 0.5  # s, smoothing of what is beyond the speed that commands should have made
_CLIMB_MOST = 0.2  # rad of path slope fed forward


@jit
def smooth_lateral(dt, navigation, docking):
    """Smooth the speed over ground across the approach line, m/s to starboard, for damping."""
    off = navigation.eta[5] - docking.heading
    rate = sin(off) * navigation.nu[0] + cos(off) * navigation.nu[1]
    docking.lateral_rate += min(1.0, dt / _T_LATERAL) * (rate - docking.lateral_rate)


@inline
def smooth_step(x):
    """3 x^2 - 2 x^3 of x held in [0, 1]: from 0 to 1 without a corner."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)


@jit
def look_ahead(settings, guidance, u_r):
    """Delta of depth by pitch, m: shorter where the hull is slow, or the same slope would take longer."""
    slow = settings.pitch_look_slow
    way = min(max(u_r / max(guidance.schedule_speed, 1e-3), 0.0), 1.0)
    return guidance.pitch_look_ahead * (slow + (1.0 - slow) * way)


@jit
def pitch_reference(settings, guidance, depth, z_d, e_dot_z, u_r, docking):
    """theta_d by line of sight in depth, rad; fills docking.pitch_share, what pitch has of depth.

    theta_d = share atan((z - z_d + T z') / Delta), z' the smoothed depth rate, from the PID's e'_z = -z',
    m/s. guidance: GUIDANCE_SETTINGS, its pitch_look_ahead and pitch_max; u_r: speed through water, m/s.
    """
    low, high = settings.pitch_flow_low, settings.pitch_flow_high
    docking.pitch_share = smooth_step((u_r - low) / max(high - low, 1e-6))
    if guidance.pitch_look_ahead <= 0.0:
        docking.pitch_share = 0.0
        return 0.0
    fed = settings.pitch_feed * docking.leg_climb if docking.stage == TRANSIT else 0.0
    z_e = depth - z_d - settings.pitch_lead * (e_dot_z + fed)
    slope = fed / max(u_r, max(low, 1e-3))
    climb = asin(min(max(slope, -_CLIMB_MOST), _CLIMB_MOST))
    wanted = atan(z_e / look_ahead(settings, guidance, u_r)) - climb
    return docking.pitch_share * min(max(wanted, -guidance.pitch_max), guidance.pitch_max)


@jit
def shape_speed(dt, settings, acceleration, u_goal, reference, docking):
    """Move u_d towards its goal, m/s, at an acceleration that changes no faster than the jerk: but at once
    where the vehicle would not stop before the dock."""
    reason = docking.reason
    if docking.stage == BACK and (reason == TOO_SLOW or reason == OVERSHOT or reason == OFF_HEADING):
        reference[0] = min(reference[0], u_goal)
    wanted = (u_goal - reference[0]) / settings.speed_time
    wanted = min(max(wanted, -acceleration), acceleration)
    docking.u_dot = approach(docking.u_dot, wanted, settings.jerk * dt)
    reference[0] += docking.u_dot * dt


@jit
def shape_depth(dt, settings, guidance, z_goal, reference, view, docking):
    """Move z_d towards its goal, m: faster where pitch has depth."""
    slow = guidance.depth_rate
    rate = slow + docking.pitch_share * (settings.depth_rate_pitch - slow)
    before = reference[2]
    view.depth_moves = 1 if abs(z_goal - before) > rate * dt else 0
    reference[2] = approach(before, z_goal, rate * dt)
    climbs = 0.0 if view.depth_moves == 1 else (reference[2] - before) / dt  # a step fed forward overshoots
    docking.leg_climb += dt / (dt + _T_DEPTH_RATE) * (climbs - docking.leg_climb)


@jit
def shape_references(dt, settings, guidance, goals, navigation, smooth, reference, view, docking):
    """Move reference (6,) towards goals (u, z, psi) at the rates that the vehicle can follow.

    guidance: GUIDANCE_SETTINGS; smooth: the PID's ERRORS of the last cycle.
    """
    u_goal, z_goal, psi_d = goals
    shape_speed(dt, settings, guidance.acceleration, u_goal, reference, docking)
    shape_depth(dt, settings, guidance, z_goal, reference, view, docking)
    u_r = navigation.smooth_nu_r[0]
    theta_d = pitch_reference(
        settings, guidance, navigation.eta[2], reference[2], smooth.e_dot[2], u_r, docking
    )  # fmt: skip
    reference[1] = reference[3] = 0.0
    reference[4] = approach(reference[4], theta_d, settings.line_rate * dt)
    shape_heading(dt, settings, guidance, psi_d, reference, docking)


@jit
def shape_heading(dt, settings, guidance, psi_d, reference, docking):
    """Turn the heading reference towards psi_d, rad; notes its rate for the moment that a turn asks for."""
    under_way = docking.stage == TRANSIT or docking.stage == ENTRY
    most = guidance.heading_rate if under_way or docking.passing != 0 else settings.line_rate
    turn = approach(0.0, wrap(psi_d - reference[5]), most * dt)
    reference[5] = wrap(reference[5] + turn)
    rate = turn / dt if under_way else 0.0
    docking.turn += lag(dt, _T_TURN) * (rate - docking.turn)


@jit
def turn_away(settings, plan, navigation, reference, docking):
    """Turn the heading reference of a vehicle that holds station and has no brake past the dock."""
    psi_d = swerve_heading(settings.docking, plan, navigation, docking)
    shape_heading(settings.dt, settings.docking, settings.guidance, psi_d, reference, docking)


@jit
def guide_docking(dt, settings, plan, s, situation, view, out):
    """Advance the references by the stage. settings: SETTINGS; s: STATE; out: GUIDANCE_OUTPUT, filled."""
    docking, navigation, guidance = s.docking, s.navigation, s.guidance
    law, reference, stage = settings.guidance, s.guidance.reference, s.docking.stage
    if stage == TRANSIT:
        u_goal, z_goal, psi_d = follow_path(dt, law, plan, navigation, situation, guidance, out)
        psi_d = clear_leg(settings.docking, plan, navigation, guidance.leg, out.along_track, psi_d, docking)
        goals = u_goal, z_goal, psi_d
    else:
        out.cross_track, out.along_track = view.aside, view.left
        if stage == ENTRY:
            goals = entry_references(settings.docking, plan, navigation, situation.station, docking)
            out.cross_track = off_the_way(settings.docking, navigation.eta, situation.station, docking)
        elif stage == CREEP:
            goals = creep_references(dt, settings.docking, plan, navigation, reference[0], view, docking)
        else:
            goals = line_references(
                dt, settings.docking, law.reverse_max, plan, navigation, situation.mode, reference[0], view,
                docking,
            )  # fmt: skip
            if swerves(plan, navigation, docking):
                goals = goals[0], goals[1], swerve_heading(settings.docking, plan, navigation, docking)
    shape_references(dt, settings.docking, law, goals, navigation, s.pid.smooth, reference, view, docking)


@jit
def begin_at(navigation, reference, docking):
    """References of the first cycle: as the vehicle is found, so that nothing dips."""
    reference[0], reference[2] = navigation.nu[0], navigation.eta[2]
    docking.made = navigation.nu[0]
    reference[5] = navigation.eta[5]


@jit
def rest_references(view, docking):
    """While paused nothing of the shaping goes on; depth is held by heave."""
    docking.u_dot = docking.leg_climb = docking.pitch_share = docking.turn = 0.0
    view.depth_moves = 0


@jit
def note_brake(dt, model, thrust, u, u_r, docking):
    """Smooth by how much speed u, m/s, exceeds what the commanded thrust, N, and drag should have made of it.

    made' = (thrust - drag(u_r)) / (m - X_u') + (u - made) / T, so that what is off by a little for good
    counts for little; `braked` is the part of thrust astern in it, of which a weak brake lacks a share. A
    brake that is weak shows here before it shows in the speed: the PID asks for more at first.
    """
    pull = (thrust - SURE_DRAG * surge_drag(model, u_r)) / surge_mass(model)
    docking.made += dt * (pull + (u - docking.made) / T_MADE)
    docking.braked -= dt * (thrust / surge_mass(model) + docking.braked / T_MADE)
    docking.unbraked += lag(dt, _T_UNBRAKED) * (u - docking.made - docking.unbraked)


@jit
def note_lag(dt, u_d, u, docking):
    """Smooth by how much speed u stays behind its reference u_d, m/s: much of it for long is a fault."""
    docking.surge_lag += dt / _T_LAG * (u_d - u - docking.surge_lag)
