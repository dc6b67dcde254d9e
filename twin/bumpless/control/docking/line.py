"""Following the approach line, ahead, at rest and astern.

Beyond the paper. On the line the heading makes good the drift with the flow there is: for a speed through
water u_r at a small angle beta to the line the way across is u_r sin beta, so sin beta = v / u_r gives v.
That inverse is damped, u_r v / (u_r^2 + u_0^2): it fades at rest and turns round when the vehicle goes
astern.
"""

from math import asin, copysign, cos, log, sin, sqrt

from bumpless.contract.enums import APPROACH, BACK, FORWARD, HOVER
from bumpless.control.docking.heading import along_across, weathervane
from bumpless.jit import jit
from bumpless.physics.frames import wrap

_STILL = 0.002  # m/s of estimated drift that is noise: no aim makes up for it
_AT_REST = 0.1  # m left, where the way ends and the stay begins
_BORNE = 0.07  # of a head current, across: made good by the crab angle at the end
_LEARN_WITHIN = 0.2  # m
_DRIFT_MOST = 0.015  # m/s
_ASTERN_MOST = 0.15  # m/s on the approach, past the observation point
_BACK_LEAST = 0.08  # m/s over ground: slower, a way back against the current wanders off the line
_CREEP = 0.1  # m/s, fastest correction while holding station


@jit
def place_on_line(eta, point, heading, view):
    """Fill view.left and view.aside from the vehicle's eta (6,), the observation point (3,) and heading."""
    c, s = cos(heading), sin(heading)
    dx, dy = eta[0] - point[0], eta[1] - point[1]
    view.left = -(c * dx + s * dy)
    view.aside = -s * dx + c * dy


@jit
def approach_speed(settings, left):
    """Speed over ground towards a stop `left` m ahead, m/s: constant deceleration, exponential at the end.

    u = sqrt(k^2 + 2 a |left|) - k with k = a / end_gain: du/dleft is end_gain at the stop.
    """
    deceleration = settings.deceleration
    knee = deceleration / settings.end_gain
    speed = sqrt(knee * knee + 2.0 * deceleration * abs(left)) - knee
    return speed if left >= 0.0 else -speed


@jit
def approach_most(settings, reverse_max, left):
    """Fastest approach in R `left` m before its stop, m/s over ground.

    Drag alone slows the hull about as fast as `approach_speed` asks, so that a brake without thrust shows
    late. From `try_brake` on the approach is slower than that: the brake has work to do while there is room.
    """
    return min(reverse_max, settings.try_speed) if left <= settings.try_brake else reverse_max


@jit
def aim_aside(settings, along, across, tilt, left):
    """Offset of the aim upstream, m, so that a drift that can't be made good at rest crosses the middle.

    It lasts while the vehicle comes to rest, ln(1 + left / _AT_REST) / end_gain of an approach that ends
    exponentially, and `aim_time` of the stay. across: of current and learnt drift, of which a little is
    noise; tilt: drift by the hull's roll, m/s; left: m.
    """
    drift = tilt + copysign(max(abs(across) - _STILL, 0.0), across)
    loose = max(abs(drift) - _BORNE * max(-along, 0.0), 0.0)
    lasts = settings.aim_time + log(1.0 + max(left, 0.0) / _AT_REST) / settings.end_gain
    aim = min(loose * lasts, settings.aim_most)
    return -aim if drift > 0.0 else aim


@jit
def largest_crab(settings, near, along, left):
    """Sine of the largest heading correction: it narrows towards the observation point, so that the marker
    stays in view and the bow straight; without flow an angle there would not be undone. near: what is left of
    it there in flow; along: of the current, m/s; left: m.
    """
    full = 2.0 * settings.flow_floor
    missing = max(full - abs(along), 0.0)
    near += missing / full * (settings.crab_near - near)
    straighten = settings.straighten + settings.straighten_flow * missing
    most = near + settings.crab_slope * max(abs(left) - straighten, 0.0)
    return min(most, settings.crab_far)


@jit
def line_heading(dt, settings, current, u_r, learn, free, view, docking):
    """psi_d that follows the approach line, rad. u_r: speed ahead through water; learn: drift is learnt;
    free: the approach heading may follow the hull."""
    along, _ = along_across(current, docking.heading)
    near = settings.crab_free if free else settings.crab_borne
    most = largest_crab(settings, near, along, view.left)
    return steer(dt, settings, current, u_r, learn, most, view, docking)


@jit
def steer(dt, settings, current, u_r, learn, most, view, docking):
    """The same within a heading correction whose sine is `most`."""
    along, across = along_across(current, docking.heading)
    y = view.aside - aim_aside(settings, along, across + docking.drift, docking.tilt, view.left)
    delta = settings.look_ahead + settings.look_ahead_slope * abs(u_r)
    wanted = -abs(u_r) * y / sqrt(delta * delta + y * y)
    if learn and abs(y) < _LEARN_WITHIN:
        docking.drift += dt * settings.lateral_integral * abs(u_r) * y
        docking.drift = min(max(docking.drift, -_DRIFT_MOST), _DRIFT_MOST)
    drift = across + docking.drift + docking.tilt
    rate = wanted - drift - settings.lateral_damping * (docking.lateral_rate - wanted)
    sine = rate * u_r / (u_r * u_r + settings.flow_floor * settings.flow_floor)
    return wrap(docking.heading + asin(min(max(sine, -most), most)))


@jit
def back_speed(settings, head):
    """Speed over ground astern, m/s, positive, in a head current: half the current where that leaves flow
    over the fins, else through the water astern, and in one from astern as fast as makes way against it."""
    if head > 2.0 * settings.flow_floor + 0.02:
        return 0.5 * head
    return max(head + settings.back_speed, min(_BACK_LEAST, settings.back_speed))


@jit
def line_speed(settings, stage, cleared, mode, leg_speed, reverse_max, along, left, back_to):
    """u_d on the approach line before shaping, m/s over ground. along: the current's part, m/s."""
    if stage == APPROACH:
        stop = 0.0 if cleared == 1 else settings.gate_distance
        u_goal = approach_speed(settings, left - stop)
        if mode == FORWARD:
            return min(u_goal, leg_speed + along)
        return min(max(u_goal, -_ASTERN_MOST), approach_most(settings, reverse_max, left))
    if stage == BACK:
        slow = max(approach_speed(settings, back_to + 0.3 - left), -0.1)
        return -min(back_speed(settings, -along), slow)
    return min(max(approach_speed(settings, left - back_to), -_CREEP), _CREEP)


@jit
def line_references(dt, settings, reverse_max, plan, navigation, mode, u_d, view, docking):
    """(u goal, z goal, psi_d) on the approach line; turns and learns in DOCKING_STATE.

    u_d: the speed reference in force, m/s; mode: F, R or H; view: DOCKING_OUTPUT.
    """
    eta, current = navigation.eta, navigation.current
    along, _ = along_across(current, docking.heading)
    u_goal = line_speed(
        settings, docking.stage, docking.cleared, mode, plan.speed[plan.n_legs - 1], reverse_max,
        along, view.left, docking.back_to,
    )  # fmt: skip
    u_r = u_d - along
    approaching = docking.stage == APPROACH
    learn = approaching and mode != FORWARD
    free = plan.heading_tolerance > 0.0
    psi_d = line_heading(dt, settings, current, u_r, learn, free, view, docking)
    if approaching and mode == HOVER:
        weathervane(dt, settings, plan, eta[5], u_r, docking)
    return u_goal, navigation.target[2], psi_d
