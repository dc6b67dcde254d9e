"""Staying at a place, in H and in a pause.

Beyond the paper: in H the cross-track law fades with the inflow, since heading only moves the vehicle
sideways when water flows past it. A vehicle that needs flow over its fins passes the observation point at its
slowest speed and circles where it should wait.
"""

from math import atan, cos, hypot, pi, sin

from bumpless.control.guidance.drift import FULL_FLOW, crab
from bumpless.jit import jit
from bumpless.physics.frames import direction, wrap


@jit
def observation_point(target, heading, standoff, out):
    """out[:3]: the point to hover at, `standoff` m before target (3,), NED, against the approach heading."""
    out[0] = target[0] - standoff * cos(heading)
    out[1] = target[1] - standoff * sin(heading)
    out[2] = target[2]


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
        flow = min(max(situation.u_r / FULL_FLOW, -1.0), 1.0)
        psi_d = wrap(heading - settings.hover_cross_gain * flow * atan(y_e / settings.look_ahead))
        psi_d = wrap(psi_d + crab(settings, situation, navigation.current, heading))
    return u_goal, v_goal, psi_d


@jit
def circle(settings, eta, x, y):
    """psi_d of a clockwise circle of two look-aheads' radius about a NED point, for what cannot stop."""
    dx, dy = x - eta[0], y - eta[1]
    outside = hypot(dx, dy) - 2.0 * settings.look_ahead
    return wrap(direction(dx, dy) - 0.5 * pi + atan(outside / settings.look_ahead))
