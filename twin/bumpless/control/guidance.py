"""References u_d, v_d, z_d, phi_d, theta_d, psi_d from the path, the target and the mode.

Source: Gao et al. 2026, eq. (41) (adaptive line of sight); Fossen & Aguiar 2024, Automatica 163
(uniform semiglobal exponential law, `AALOS`).
Beyond the paper: after a missed approach in F the vehicle returns to the start of the last leg and
tries again; in H the cross-track law fades with the inflow, since heading only moves the vehicle
sideways when water flows past it; the estimated current may be made good by a crab angle (`crab_gain`)
instead of being learnt. A vehicle without heave holds its depth by pitch, and one that needs flow over its
fins passes the observation point at its slowest speed and circles where it should wait.
"""

from math import asin, atan, cos, hypot, pi, sin, sqrt

from bumpless.jit import jit
from bumpless.physics.frames import direction, wrap
from bumpless.records import AALOS, FORWARD, HOVER, REVERSE

_RUNWAY = 14.0  # m added to the last leg after a missed approach: three turning radii of a slow torpedo
_FULL_FLOW = 0.05  # m/s of inflow at which hover uses its whole cross-track law
_ASTERN = 0.03  # m/s along the path above which a vehicle hovers stern to the current
_NEAR = 0.5  # m before the observation point from which the approach speed fades out
_CRAB_MAX = 0.35  # sine of the largest crab angle: the target must stay in the camera's view


@jit
def observation_point(plan, a, out):
    """out (3,): the point to hover at, `standoff` before `a.target` against the approach heading."""
    out[0] = a.target[0] - plan.standoff * cos(plan.target[3])
    out[1] = a.target[1] - plan.standoff * sin(plan.target[3])
    out[2] = a.target[2]


@jit
def leg_ends(plan, a, point, start, end):
    """Fill start and end (3,) of the active leg. Leg n_legs - 1 ends at the observation point; leg n_legs
    leads back after a missed approach, past the last leg's start so that there is room to turn and align."""
    last = plan.n_legs - 1
    for k in range(3):
        if a.leg > last:
            start[k], end[k] = point[k], plan.waypoint[last, k]
        else:
            start[k] = plan.waypoint[a.leg, k]
            end[k] = point[k] if a.leg == last else plan.waypoint[a.leg + 1, k]
    if a.leg > last:
        dx, dy = end[0] - start[0], end[1] - start[1]
        stretch = _RUNWAY / max(hypot(dx, dy), 1e-6)
        end[0] += stretch * dx
        end[1] += stretch * dy


@jit
def steer(settings, a, path_heading, y_e, adapt):
    """psi_d of the chosen law, rad; updates the bias estimate a.b. y_e: cross-track error, m."""
    delta = settings.look_ahead
    if settings.law == AALOS:
        if adapt:
            a.b += settings.dt * settings.gamma * delta * y_e / sqrt(delta * delta + y_e * y_e)
            a.b = min(max(a.b, -0.6), 0.6)
        return wrap(path_heading - a.b - atan(y_e / delta))
    if adapt:
        a.b += settings.dt * settings.gamma * y_e
        a.b = min(max(a.b, -delta), delta)
    return wrap(path_heading - atan((y_e + a.b) / delta))


@jit
def crab(settings, a, heading):
    """Angle (rad) by which to turn into the estimated current so that the track keeps `heading`.

    In H the hull lies along the current, bow or stern into it, as far as the camera's view allows.
    """
    across = -a.current[0] * sin(heading) + a.current[1] * cos(heading)
    if a.mode == HOVER or a.holding == 1:
        along = a.current[0] * cos(heading) + a.current[1] * sin(heading)
        along = along if along > _ASTERN else min(along, -_ASTERN)
        return settings.crab_gain * atan(min(max(across / along, -_CRAB_MAX), _CRAB_MAX))
    flow = max(a.nu_r[0], _FULL_FLOW)
    angle = asin(min(max(across / flow, -_CRAB_MAX), _CRAB_MAX))
    return -settings.crab_gain * min(max(a.nu_r[0] / _FULL_FLOW, 0.0), 1.0) * angle


@jit
def least_speed(settings, a, heading):
    """Speed over ground along `heading` at which the largest crab angle just makes good the drift, m/s."""
    along = a.current[0] * cos(heading) + a.current[1] * sin(heading)
    across = -a.current[0] * sin(heading) + a.current[1] * cos(heading)
    return settings.crab_gain * (along + abs(across) * sqrt(1.0 - _CRAB_MAX * _CRAB_MAX) / _CRAB_MAX)


@jit
def approach(value, goal, step):
    """value moved towards goal by at most step; step <= 0 means no limit."""
    if step <= 0.0:
        return goal
    return value + min(max(goal - value, -step), step)


@jit
def follow_path(settings, plan, a, point, start, end):
    """References in F and R. Returns (u goal, z goal, psi_d)."""
    last = plan.n_legs - 1
    if a.mode != FORWARD and a.leg != last:
        a.leg = last
    leg_ends(plan, a, point, start, end)
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = max(hypot(dx, dy), 1e-6)
    heading = direction(dx, dy) if length > 0.05 else plan.target[3]
    ch, sh = cos(heading), sin(heading)
    s = (a.eta[0] - start[0]) * ch + (a.eta[1] - start[1]) * sh
    y_e = -(a.eta[0] - start[0]) * sh + (a.eta[1] - start[1]) * ch
    left = length - s
    a.cross_track, a.along_track = y_e, left
    if a.mode == FORWARD:
        if a.leg < last and left <= settings.look_ahead * 0.5:
            a.leg, a.b = a.leg + 1, 0.0
        elif a.leg == last and left < -settings.look_ahead and a.detected == 0:
            a.leg, a.b = last + 1, 0.0
        elif a.leg > last and left <= settings.look_ahead:
            a.leg, a.b = last, 0.0
    if a.mode == REVERSE:
        near = min(max(left / _NEAR, 0.0), 1.0)
        u_goal = settings.reverse_slope * left + near * settings.reverse_offset
        if left > 0.0:
            u_goal = max(u_goal, near * least_speed(settings, a, heading))
        u_goal = min(max(u_goal, -0.5 * settings.reverse_max), settings.reverse_max)
    else:
        u_goal = plan.speed[min(a.leg, last)]
        # legs give the speed through water
        u_goal += settings.crab_gain * (a.current[0] * ch + a.current[1] * sh)
        if a.cycle == 0:
            a.reference[0] = u_goal if settings.crab_gain > 0.0 else a.reference[0]
        if a.leg >= last and a.range < settings.d_fr_l:
            u_goal = min(u_goal, settings.reverse_max)
    share = min(max((s + settings.look_ahead) / length, 0.0), 1.0)
    z_goal = start[2] + share * (end[2] - start[2])
    if a.mode == REVERSE and left < 0.0:
        y_e *= min(max(a.nu_r[0] / _FULL_FLOW, -1.0), 1.0)  # going astern turns the law round
    psi_d = steer(settings, a, heading, y_e, a.kappa >= 1.0)
    return u_goal, z_goal, wrap(psi_d + crab(settings, a, heading))


@jit
def hold_station(settings, plan, a, x, y, z, heading, controllable_sway):
    """References in H about a NED point. Returns (u goal, v goal, z goal, psi_d)."""
    dx, dy = x - a.eta[0], y - a.eta[1]
    c, s = cos(a.eta[5]), sin(a.eta[5])
    ahead, aside = c * dx + s * dy, -s * dx + c * dy
    limit = settings.hover_max
    u_goal = min(max(settings.hover_gain * ahead, -limit), limit)
    v_goal = min(max(settings.hover_gain * aside, -limit), limit)
    ch, sh = cos(heading), sin(heading)
    y_e = dx * sh - dy * ch
    a.cross_track, a.along_track = y_e, dx * ch + dy * sh
    psi_d = heading
    if not controllable_sway:
        flow = min(max(a.nu_r[0] / _FULL_FLOW, -1.0), 1.0)
        psi_d = wrap(heading - settings.hover_cross_gain * flow * atan(y_e / settings.look_ahead))
        psi_d = wrap(psi_d + crab(settings, a, heading))
    return u_goal, v_goal, z, psi_d


@jit
def circle(settings, a, x, y):
    """psi_d of a clockwise circle of two look-aheads' radius about a NED point, for what cannot stop."""
    dx, dy = x - a.eta[0], y - a.eta[1]
    outside = hypot(dx, dy) - 2.0 * settings.look_ahead
    return wrap(direction(dx, dy) - 0.5 * pi + atan(outside / settings.look_ahead))


@jit
def pitch_for_depth(settings, a):
    """theta_d by line of sight in the vertical plane, rad; learns the trim pitch a.alpha. 0 when depth is
    held by heave. It fades below the schedule speed: without flow, pitch does not move the vehicle.

    Source: Fossen & Aguiar 2024, the vertical half of their 3-D law.
    """
    delta = settings.pitch_look_ahead
    if delta <= 0.0:
        return 0.0
    share = min(max(a.nu_r[0] / max(settings.schedule_speed, 1e-3), 0.0), 1.0)
    z_e, limit = a.eta[2] - a.reference[2], settings.pitch_max
    wanted = a.alpha + atan(z_e / delta)
    if abs(wanted) < limit or wanted * z_e < 0.0:
        a.alpha += settings.dt * share * settings.pitch_gamma * delta * z_e / sqrt(delta * delta + z_e * z_e)
    return share * min(max(wanted, -limit), limit)


@jit
def guide(settings, plan, a, point, work):
    """Fill a.reference (6,) = [u_d v_d z_d phi_d theta_d psi_d] for the autopilot record `a`.

    point (3,): observation point, NED. work: scratch, at least 6 floats.
    """
    v_goal = 0.0
    if a.holding == 1:
        h = a.hold_point
        u_goal, v_goal, z_goal, psi_d = hold_station(settings, plan, a, h[0], h[1], h[2], h[3], a.sway == 1)
        if settings.speed_min > 0.0:
            psi_d = circle(settings, a, h[0], h[1])
    elif a.mode == HOVER:
        u_goal, v_goal, z_goal, psi_d = hold_station(
            settings, plan, a, point[0], point[1], point[2], plan.target[3], a.sway == 1
        )
    else:
        u_goal, z_goal, psi_d = follow_path(settings, plan, a, point, work[0:3], work[3:6])
    r = a.reference
    u_goal = max(u_goal, settings.speed_min) if settings.speed_min > 0.0 else u_goal
    r[0] = approach(r[0], u_goal, settings.acceleration * settings.dt)
    r[1] = approach(r[1], v_goal, settings.acceleration * settings.dt) if a.sway == 1 else 0.0
    r[2] = approach(r[2], z_goal, settings.depth_rate * settings.dt)
    r[3] = 0.0
    r[4] = pitch_for_depth(settings, a)
    turn = settings.heading_rate * settings.dt
    r[5] = wrap(r[5] + approach(0.0, wrap(psi_d - r[5]), turn))
