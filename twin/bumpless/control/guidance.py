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

from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.control.guidance_record import AALOS
from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.frames import direction, wrap

_RUNWAY = 14.0  # m added to the last leg after a missed approach: three turning radii of a slow torpedo
_FULL_FLOW = 0.05  # m/s of inflow at which hover uses its whole cross-track law
_ASTERN = 0.03  # m/s along the path above which a vehicle hovers stern to the current
_NEAR = 0.5  # m before the observation point from which the approach speed fades out
_CRAB_MAX = 0.35  # sine of the largest crab angle: the target must stay in the camera's view


@jit
def observation_point(target, heading, standoff, out):
    """out[:3]: the point to hover at, `standoff` m before target (3,), NED, against the approach heading."""
    out[0] = target[0] - standoff * cos(heading)
    out[1] = target[1] - standoff * sin(heading)
    out[2] = target[2]


@jit
def leg_ends(plan, leg, point, start, end):
    """Fill start and end (3,) of a leg. Leg n_legs - 1 ends at the observation point; leg n_legs leads
    back after a missed approach, past the last leg's start so that there is room to turn and align."""
    last = plan.n_legs - 1
    for k in range(3):
        if leg > last:
            start[k], end[k] = point[k], plan.waypoint[last, k]
        else:
            start[k] = plan.waypoint[leg, k]
            end[k] = point[k] if leg == last else plan.waypoint[leg + 1, k]
    if leg > last:
        dx, dy = end[0] - start[0], end[1] - start[1]
        stretch = _RUNWAY / max(hypot(dx, dy), 1e-6)
        end[0] += stretch * dx
        end[1] += stretch * dy


@jit
def steer(dt, settings, path_heading, y_e, adapt, guidance):
    """psi_d of the chosen law, rad; updates guidance.b where it may `adapt`. y_e: cross-track error, m."""
    delta = settings.look_ahead
    if settings.law == AALOS:
        if adapt:
            guidance.b += dt * settings.gamma * delta * y_e / sqrt(delta * delta + y_e * y_e)
            guidance.b = min(max(guidance.b, -0.6), 0.6)
        return wrap(path_heading - guidance.b - atan(y_e / delta))
    if adapt:
        guidance.b += dt * settings.gamma * y_e
        guidance.b = min(max(guidance.b, -delta), delta)
    return wrap(path_heading - atan((y_e + guidance.b) / delta))


@jit
def crab(settings, situation, current, heading):
    """Angle (rad) by which to turn into the estimated current so that the track keeps `heading`.

    In H the hull lies along the current, bow or stern into it, as far as the camera's view allows.
    """
    across = -current[0] * sin(heading) + current[1] * cos(heading)
    if situation.mode == HOVER:
        along = current[0] * cos(heading) + current[1] * sin(heading)
        along = along if along > _ASTERN else min(along, -_ASTERN)
        return settings.crab_gain * atan(min(max(across / along, -_CRAB_MAX), _CRAB_MAX))
    flow = max(situation.u_r, _FULL_FLOW)
    angle = asin(min(max(across / flow, -_CRAB_MAX), _CRAB_MAX))
    return -settings.crab_gain * min(max(situation.u_r / _FULL_FLOW, 0.0), 1.0) * angle


@jit
def least_speed(settings, current, heading):
    """Speed over ground along `heading` at which the largest crab angle just makes good the drift, m/s."""
    along = current[0] * cos(heading) + current[1] * sin(heading)
    across = -current[0] * sin(heading) + current[1] * cos(heading)
    return settings.crab_gain * (along + abs(across) * sqrt(1.0 - _CRAB_MAX * _CRAB_MAX) / _CRAB_MAX)


@jit
def approach(value, goal, step):
    """value moved towards goal by at most step; step <= 0 means no limit."""
    if step <= 0.0:
        return goal
    return value + min(max(goal - value, -step), step)


@jit
def next_leg(settings, situation, last, left, guidance):
    """In F: the next leg near a leg's end; back for another approach when the target was passed unseen."""
    if guidance.leg < last and left <= settings.look_ahead * 0.5:
        guidance.leg, guidance.b = guidance.leg + 1, 0.0
    elif guidance.leg == last and left < -settings.look_ahead and situation.detected == 0:
        guidance.leg, guidance.b = last + 1, 0.0
    elif guidance.leg > last and left <= settings.look_ahead:
        guidance.leg, guidance.b = last, 0.0


@jit
def follow_path(dt, settings, plan, navigation, situation, guidance, out):
    """References in F and R. Returns (u goal, z goal, psi_d)."""
    start, end, last = floats(3), floats(3), plan.n_legs - 1
    eta, current = navigation.eta, navigation.current
    if situation.mode != FORWARD and guidance.leg != last:
        guidance.leg = last
    leg_ends(plan, guidance.leg, situation.station, start, end)
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = max(hypot(dx, dy), 1e-6)
    heading = direction(dx, dy) if length > 0.05 else plan.target[3]
    ch, sh = cos(heading), sin(heading)
    s = (eta[0] - start[0]) * ch + (eta[1] - start[1]) * sh
    y_e = -(eta[0] - start[0]) * sh + (eta[1] - start[1]) * ch
    left = length - s
    out.cross_track, out.along_track = y_e, left
    if situation.mode == FORWARD:
        next_leg(settings, situation, last, left, guidance)
    if situation.mode == REVERSE:
        near = min(max(left / _NEAR, 0.0), 1.0)
        u_goal = settings.reverse_slope * left + near * settings.reverse_offset
        if left > 0.0:
            u_goal = max(u_goal, near * least_speed(settings, current, heading))
        u_goal = min(max(u_goal, -0.5 * settings.reverse_max), settings.reverse_max)
    else:
        u_goal = plan.speed[min(guidance.leg, last)]
        # legs give the speed through water
        u_goal += settings.crab_gain * (current[0] * ch + current[1] * sh)
        if situation.first == 1 and settings.crab_gain > 0.0:
            guidance.reference[0] = u_goal
        if guidance.leg >= last and situation.slow == 1:
            u_goal = min(u_goal, settings.reverse_max)
    share = min(max((s + settings.look_ahead) / length, 0.0), 1.0)
    z_goal = start[2] + share * (end[2] - start[2])
    if situation.mode == REVERSE and left < 0.0:
        y_e *= min(max(situation.u_r / _FULL_FLOW, -1.0), 1.0)  # going astern turns the law round
    psi_d = steer(dt, settings, heading, y_e, situation.adapt == 1, guidance)
    return u_goal, z_goal, wrap(psi_d + crab(settings, situation, current, heading))


@jit
def hold_station(settings, navigation, situation, sway, out):
    """References in H about the station. Returns (u goal, v goal, psi_d). sway: the vehicle can push
    sideways."""
    eta, station = navigation.eta, situation.station
    heading = station[3]
    dx, dy = station[0] - eta[0], station[1] - eta[1]
    c, s = cos(eta[5]), sin(eta[5])
    ahead, aside = c * dx + s * dy, -s * dx + c * dy
    limit = settings.hover_max
    u_goal = min(max(settings.hover_gain * ahead, -limit), limit)
    v_goal = min(max(settings.hover_gain * aside, -limit), limit)
    ch, sh = cos(heading), sin(heading)
    y_e = dx * sh - dy * ch
    out.cross_track, out.along_track = y_e, dx * ch + dy * sh
    psi_d = heading
    if not sway:
        flow = min(max(situation.u_r / _FULL_FLOW, -1.0), 1.0)
        psi_d = wrap(heading - settings.hover_cross_gain * flow * atan(y_e / settings.look_ahead))
        psi_d = wrap(psi_d + crab(settings, situation, navigation.current, heading))
    return u_goal, v_goal, psi_d


@jit
def circle(settings, eta, x, y):
    """psi_d of a clockwise circle of two look-aheads' radius about a NED point, for what cannot stop."""
    dx, dy = x - eta[0], y - eta[1]
    outside = hypot(dx, dy) - 2.0 * settings.look_ahead
    return wrap(direction(dx, dy) - 0.5 * pi + atan(outside / settings.look_ahead))


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
