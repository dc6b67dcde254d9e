"""One control step, fit to run on a real vehicle: measurements in, commands out.

Order of the paper's loop (Gao et al. 2026, fig. 7 and 8): navigation, supervisor, guidance, PID,
switching, allocation. Everything it remembers is in one AUTOPILOT record.
"""

from math import exp, hypot

from bumpless.control.allocation.baselines import allocate_direct, allocate_wls
from bumpless.control.allocation.bounds import command_bounds, limited_channels
from bumpless.control.allocation.easing import missed_wrench
from bumpless.control.allocation.mdca import INFEASIBLE, REFUSED, allocate_mdca
from bumpless.control.effectiveness.step import believe_estimate, estimate_effectiveness, reset_estimator
from bumpless.control.guidance import guide, observation_point
from bumpless.control.navigation import navigate
from bumpless.control.pid import demand, gain_share, smooth_errors, tracking_error
from bumpless.control.supervisor import filter_detection, supervise
from bumpless.control.switching import begin_ramp, blend, report_slack, soften, transition_factor
from bumpless.jit import jit
from bumpless.jit.clock import monotonic
from bumpless.physics.actuators import total_wrench
from bumpless.records import HOVER, MDCA, WLS

_LONG_AGO = -1_000_000_000


@jit
def reset_autopilot(modes, plan, model, a):
    """Bring `a` to the start of a mission: forward mode, settled, actuators at rest."""
    for k in range(6):
        a.eta[k] = plan.start[k]
        a.nu[k] = 0.0
        a.integral[k] = a.bias[k] = a.reference[k] = 0.0
        a.tau_d[k] = a.tau_c[k] = a.tau_plus[k] = a.tau_minus[k] = a.slack[k] = 0.0
        a.Q[k] = a.Q_minus[k] = a.Q_mode[k] = modes[0].Q[k]
        a.smooth_error[k] = a.smooth_rate[k] = 0.0
        a.limited[k] = 0
        a.K_I[k] = modes[0].K_I[k]
    for i in range(a.u.shape[0]):
        a.u[i] = 0.0
        a.R[i] = a.R_minus[i] = modes[0].R[i]
        a.effectiveness[i] = 1.0
    for k in range(3):
        a.target[k] = plan.target[k]
        a.current[k] = 0.0
    a.lam = a.lam_minus = modes[0].lam
    a.increment_share = a.increment_share_minus = a.step_share = modes[0].increment_share
    a.increment_price = a.fault_share = 0.0
    a.cycle = a.fixes = a.leg = a.mode = a.previous_mode = 0
    a.history = a.hold_left = a.detected = a.holding = a.hover_cycles = 0
    a.switch_cycle = a.ramp_cycle = _LONG_AGO
    a.ramp_length = 0.0
    a.kappa = 1.0
    a.b = a.alpha = a.time = 0.0
    a.reference[2] = plan.start[2]
    a.reference[5] = plan.start[5]
    a.reference[0] = plan.start_speed
    reset_estimator(a.estimator)
    a.sway = 1 if model.controllable[1] > 0.0 else 0


@jit
def believe_faults(settings, plan, a):
    """Effectiveness as the allocator believes it: known or estimated when fault tolerant, nominal otherwise.
    a.fault_share says how far a fault is blended in."""
    a.fault_share = 0.0
    for i in range(a.effectiveness.shape[0]):
        a.effectiveness[i] = 1.0
    if settings.fault_tolerant == 1 and settings.estimate == 1:
        believe_estimate(settings, a.effectiveness.shape[0], a)
    elif settings.fault_tolerant == 1:
        for f in range(plan.n_faults):
            elapsed = a.time - plan.fault_time[f]
            if elapsed > 0.0:
                share = min(1.0, elapsed / plan.fault_blend[f]) if plan.fault_blend[f] > 0.0 else 1.0
                a.fault_share = max(a.fault_share, share)
                if settings.degraded_map == 1:
                    a.effectiveness[plan.fault_actuator[f]] = 1.0 + share * (
                        plan.fault_effectiveness[f] - 1.0
                    )


@jit
def allocate(handle, settings, model, a, w):
    """Commands of this cycle for a.tau_d, by the chosen allocator, and the wrench they achieve."""
    started = monotonic()  # pyright: ignore[reportCallIssue]
    feasible = command_bounds(model, a.u, settings.dt * a.step_share, a.u_lower, a.u_upper, a.du_max)
    if settings.allocator == MDCA:
        for k in range(6):
            w.demand[k] = a.tau_d[k]
        if settings.easing_made_up == 1:
            missed_wrench(model, a.u, a.effectiveness, w.missed)
            for k in range(6):
                a.tau_d[k] += w.missed[k]
        allocate_mdca(handle, settings, model, a, w)
        for k in range(6):
            a.tau_d[k] = w.demand[k]
    elif settings.allocator == WLS:
        allocate_wls(model, a, w)
    else:
        allocate_direct(settings, model, a, w)
    if not feasible and a.status != REFUSED:
        a.status = INFEASIBLE
    a.solve_time = monotonic() - started  # pyright: ignore[reportCallIssue]
    total_wrench(model, a.u, a.effectiveness, a.nu_r, a.tau_c)
    report_slack(settings, a)
    limited_channels(model, a.u, a.u_lower, a.u_upper, w.jacobian, a.limited)


@jit
def smooth_flow(settings, a):
    """Lag a.nu_r (6,), so that noise of the velocity log does not reach the fins through the map.

    Of sway and heave, and of the turning rates, only a share may be seen: what fins do by themselves against
    drift and turning then stays with the hull, steadying it, instead of being undone. With no share of either
    the map is the published one, alpha = delta. Source: Gao et al. 2026, eq. (15) and below.
    """
    t = settings.flow_filter
    k = 1.0 - exp(-settings.dt / t) if t > 0.0 and a.cycle > 0 else 1.0
    for i in range(6):
        a.flow[i] += k * (a.nu_r[i] - a.flow[i])
        a.nu_r[i] = a.flow[i]
        if i > 0:
            a.nu_r[i] *= settings.flow_drift if i < 3 else settings.flow_rates


@jit
def change_mode(a, mode):
    """Enter `mode` in this cycle."""
    a.previous_mode, a.mode = a.mode, mode
    a.switch_cycle = a.cycle


@jit
def autopilot_step(handle, settings, modes, sensors, plan, model, m, a, w, change, work):
    """Advance the autopilot record `a` by one cycle; its commands are a.u (8,), rad and rev/s.

    change: 1 when parameters or the hold state were changed since the last cycle, so that a ramp
    begins without a mode switch. work: scratch, at least 9 floats.
    """
    navigate(settings, sensors, m, a, work)
    if settings.estimate == 1:
        estimate_effectiveness(settings, sensors, model, m, a)
    smooth_flow(settings, a)
    if m.fresh == 1:
        filter_detection(settings, a, m.detected)
    point = work[6:9]
    observation_point(plan, a, point)
    a.range = hypot(point[0] - a.eta[0], point[1] - a.eta[1])
    if a.holding == 0:
        mode = supervise(settings, a, a.leg >= plan.n_legs)
        if mode != a.mode:
            change_mode(a, mode)
            change = 1
    guide(settings, plan, a, point, work)
    tracking_error(a)
    smooth_errors(settings, a)
    a.schedule = gain_share(settings, a)
    gains = modes[HOVER if a.holding == 1 else a.mode]
    if change == 1:
        begin_ramp(settings, gains, a)
    a.kappa = transition_factor(settings, a)
    believe_faults(settings, plan, a)
    demand(settings, gains, a)
    for k in range(6):
        a.tau_plus[k] *= model.controllable[k]
    blend(settings, gains, a)
    soften(settings, a)
    allocate(handle, settings, model, a, w)
    in_place = a.mode == HOVER and a.holding == 0 and a.range <= settings.d_rh_u
    a.hover_cycles = a.hover_cycles + 1 if in_place else 0
    a.cycle += 1
    a.time += settings.dt


@jit
def stop_actuators(settings, model, a):
    """Bring every actuator to rest as fast as its increment bound allows; nothing is demanded."""
    command_bounds(model, a.u, settings.dt, a.u_lower, a.u_upper, a.du_max)
    for i in range(model.n_u):
        a.u[i] = min(max(0.0, a.u_lower[i]), a.u_upper[i])
    for k in range(6):
        a.tau_d[k] = a.tau_plus[k] = a.tau_minus[k] = a.integral[k] = a.bias[k] = 0.0
    total_wrench(model, a.u, a.effectiveness, a.nu_r, a.tau_c)
    a.status, a.iterations, a.kkt, a.cost, a.solve_time = 1, 0, 0.0, 0.0, 0.0
    a.cycle += 1
    a.time += settings.dt
