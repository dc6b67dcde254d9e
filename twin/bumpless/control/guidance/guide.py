"""References u_d, v_d, z_d, phi_d, theta_d, psi_d from path, target and mode, moved as fast as they may."""

from bumpless.contract.enums import HOVER
from bumpless.control.guidance.depth import pitch_for_depth
from bumpless.control.guidance.path import follow_path
from bumpless.control.guidance.station import circle, hold_station
from bumpless.jit import jit
from bumpless.physics.frames import wrap


@jit
def approach(value, goal, step):
    """value moved towards goal by at most step; step <= 0 means no limit."""
    if step <= 0.0:
        return goal
    return value + min(max(goal - value, -step), step)


@jit
def guide(dt, settings, plan, navigation, situation, sway, guidance, out):
    """Advance guidance.reference (6,) = [u_d v_d z_d phi_d theta_d psi_d].

    settings: GUIDANCE_SETTINGS; navigation: NAVIGATION_STATE; sway: the vehicle can push sideways; out:
    GUIDANCE_OUTPUT.
    """
    v_goal = 0.0
    if situation.mode == HOVER:
        u_goal, v_goal, psi_d = hold_station(settings, navigation, situation, sway, out)
        z_goal = situation.station[2]
        if situation.holding == 1 and settings.speed_min > 0.0:
            psi_d = circle(settings, navigation.eta, situation.station[0], situation.station[1])
    else:
        u_goal, z_goal, psi_d = follow_path(dt, settings, plan, navigation, situation, guidance, out)
    r = guidance.reference
    u_goal = max(u_goal, settings.speed_min) if settings.speed_min > 0.0 else u_goal
    r[0] = approach(r[0], u_goal, settings.acceleration * dt)
    r[1] = approach(r[1], v_goal, settings.acceleration * dt) if sway else 0.0
    r[2] = approach(r[2], z_goal, settings.depth_rate * dt)
    r[3] = 0.0
    r[4] = pitch_for_depth(dt, settings, navigation.eta[2], situation.u_r, guidance)
    turn = settings.heading_rate * dt
    r[5] = wrap(r[5] + approach(0.0, wrap(psi_d - r[5]), turn))
