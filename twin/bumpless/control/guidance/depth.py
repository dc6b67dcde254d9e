"""Depth by pitch, for a vehicle without heave."""

from math import atan, sqrt

from bumpless.jit import jit


@jit
def pitch_for_depth(dt, settings, depth, u_r, guidance):
    """theta_d by line of sight in the vertical plane, rad; learns the trim pitch guidance.alpha. 0 when depth
    is held by heave. It fades below the schedule speed: without flow, pitch does not move the vehicle.

    Source: Fossen & Aguiar 2024, the vertical half of their 3-D law.
    """
    delta = settings.pitch_look_ahead
    if delta <= 0.0:
        return 0.0
    share = min(max(u_r / max(settings.schedule_speed, 1e-3), 0.0), 1.0)
    z_e, limit = depth - guidance.reference[2], settings.pitch_max
    wanted = guidance.alpha + atan(z_e / delta)
    if abs(wanted) < limit or wanted * z_e < 0.0:
        guidance.alpha += dt * share * settings.pitch_gamma * delta * z_e / sqrt(delta * delta + z_e * z_e)
    return share * min(max(wanted, -limit), limit)
