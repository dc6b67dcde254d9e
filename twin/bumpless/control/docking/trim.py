"""Gains and demand where pitch holds depth and thrust follows a reference. Beyond the paper."""

from math import copysign, sin, sqrt

from bumpless.control.docking.surge import surge_drag, surge_mass
from bumpless.jit import jit
from bumpless.physics.actuators import FIN
from bumpless.physics.actuators.fin import wrench, yaw_damping
from bumpless.physics.lag import lag

_TURNING = 0.1  # rad of heading error above which nothing is learnt of the yaw trim
_DIVING = 0.08  # m of depth error above which pitch is on its way there and nothing is learnt of the load
_FULL = 0.95  # share of the limit in heave at which the verticals are at their end
_LEAST_SHARE = 1e-3  # of the schedule
_T_TILT = 3.0  # s
_LEAST_DRAG = 1e-6  # N s^2/m^2
_HEAVE_LEFT = 0.05  # share of heave's weight that stays where pitch has depth


@jit
def note_schedule(schedule, view, docking):
    """Note by which factor the share of the fin channels' gains fell in this cycle."""
    before = docking.schedule
    view.schedule_fall = min(schedule / before, 1.0) if before > 0.0 else 1.0
    docking.schedule = schedule


@jit
def surge_feed(settings, model, u_d, u_dot, nu_c):
    """Thrust that drag and inertia ask for at the speed reference, N.

    X = (X_u + X_uu |u_r|) u_r + (m - X_u') u_d', with u_r = u_d - nu_c; nu_c: the water's speed ahead, m/s.
    """
    u_r = u_d - nu_c
    return settings.forward_feed * (surge_drag(model, u_r) + surge_mass(model) * u_dot)


@jit
def turn_feed(settings, model, u_r, damping, r_d):
    """Moment about z_b that a turn at r_d, rad/s, asks for, N m: of the hull, of fins that meet the turn's
    flow, and what the PID takes for a turn that is not wanted. damping: its K_D, N m s/rad; u_r: m/s."""
    drag = model.D_linear[5, 5] + model.D_quadratic[5, 5] * abs(r_d) + damping
    for i in range(model.n_u):
        if model.kind[i] == FIN:
            drag += yaw_damping(model, i, u_r)
    return settings.turn_feed * drag * r_d


@jit
def trim_gains(settings, model, navigation, u_d, errors, z_force, view, docking, gains):
    """Change the GAINS record for docking: depth goes from heave to pitch, the yaw integral with the flow.

    settings: DOCKING_SETTINGS; u_d: m/s; errors: the PID's smoothed ERRORS; z_force: last demand in heave, N.
    """
    share = docking.pitch_share
    gains.share[2] *= 1.0 - share
    diving = view.depth_moves == 1 or share * (abs(errors.e[2]) + abs(errors.e_dot[2])) > _DIVING
    gains.K_I[2] *= 0.0 if diving else 1.0 - settings.pitch_integral * share
    gains.windup[2] = 0.0  # draining the integral would give up the load that the verticals carry
    if abs(z_force) > _FULL * gains.demand_limit[2] and errors.e[2] * z_force > 0.0:
        gains.K_I[2] = 0.0
    for i in range(4, 6):
        if gains.share[i] > 0.0:
            gains.K_D[i] /= sqrt(gains.share[i])  # moments of damping go with U, not U^2
    gains.stays[5] = view.schedule_fall  # a trim of the fins: it goes with the flow
    if abs(errors.e[5]) > _TURNING:
        gains.K_I[5] = 0.0
    nu_c = navigation.nu[0] - navigation.smooth_nu_r[0]
    gains.ahead[0] = surge_feed(settings, model, u_d, docking.u_dot, nu_c)
    u_r, damping = navigation.smooth_nu_r[0], gains.share[5] * gains.K_D[5]
    gains.ahead[5] = turn_feed(settings, model, u_r, damping, docking.turn)


@jit
def note_tilt(dt, model, phi, z_force, u_r, docking):
    """Smooth docking.tilt: a hull that rolls by phi, rad, turns the verticals' z_force, N, aside, and drifts
    until its drag across is as large.

    (Y_v + Y_uv |u_r|) v + Y_vv v^2 = -Z sin phi. Nothing to a vehicle that pushes sideways itself.
    """
    if model.controllable[1] > 0.0:
        return
    force = -z_force * sin(phi)
    linear = model.D_linear[1, 1] + model.D_lift[1, 1] * abs(u_r)
    quadratic = max(model.D_quadratic[1, 1], _LEAST_DRAG)
    drift = (sqrt(linear * linear + 4.0 * quadratic * abs(force)) - linear) / (2.0 * quadratic)
    docking.tilt += lag(dt, _T_TILT) * (copysign(drift, force) - docking.tilt)


@jit
def fin_lift(model, u, effectiveness, nu_flow):
    """Force of the fins along z_b at the commands u (8,), N."""
    lift = 0.0
    for i in range(model.n_u):
        if model.kind[i] == FIN:
            _, _, z, _, _, _ = wrench(model, i, u, nu_flow)
            lift += effectiveness[i] * z
    return lift


@jit
def weigh_slow_moments(settings, problem, docking):
    """Raise Q of M and N in slow flow, by 1 / share^2 up to `slow_worth`.

    What fins can give falls with the square of the flow, and the worth of an error of moment must rise as
    fast, or the price of commands wins and a slow hull is not steered at all.
    """
    rise = min(1.0 / max(docking.schedule, _LEAST_SHARE) ** 2, settings.slow_worth)
    problem.Q[4] *= rise
    problem.Q[5] *= rise


@jit
def leave_heave_to_pitch(model, problem, tau_d, view, docking):
    """Where pitch holds depth, the lift of the fins that pitch the hull is no error of heave: it is added to
    the demand, as it was a cycle ago, and heave weighs little. Fills view.asked (6,), N and N m."""
    share = docking.pitch_share
    view.lift = 0.0
    if share > 0.0:
        view.lift = share * fin_lift(model, problem.u_previous, problem.effectiveness, problem.nu_flow)
    for k in range(6):
        view.asked[k] = tau_d[k]
    view.asked[2] += view.lift
    problem.Q[2] *= 1.0 - (1.0 - _HEAVE_LEFT) * share
