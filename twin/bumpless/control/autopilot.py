"""One control cycle, fit to run on a real vehicle: measurements in, commands out.

Order of the paper's loop (Gao et al. 2026, fig. 7 and 8): navigation, supervisor, guidance, PID,
switching, allocation. `autopilot_cycle` is handed the ONBOARD record and a MEASUREMENT and nothing else; the
commands are onboard.state.allocation.u (8,), rad and rev/s.
"""

from math import hypot, sqrt

from bumpless.contract.enums import ABORTED, COMPLETED, FORWARD, HOLD, HOVER, IDLE, PAUSED, RUNNING
from bumpless.control.allocation.allocate import achieve, allocate
from bumpless.control.allocation.slack import report_slack, soften
from bumpless.control.docking.creep import note_capture, note_still
from bumpless.control.docking.step import (
    is_in_place,
    look_docking,
    refer_docking,
    stage_mode,
    start_as_found,
    trim_docking,
)
from bumpless.control.docking.trim import leave_heave_to_pitch, weigh_slow_moments
from bumpless.control.effectiveness.step import believe_faults, estimate_effectiveness
from bumpless.control.flow import see_flow, smooth_flow
from bumpless.control.guidance.guide import guide
from bumpless.control.guidance.station import observation_point
from bumpless.control.navigation import navigate
from bumpless.control.pid import (
    align_integrals,
    carry_integrals,
    demand,
    note_unmet,
    smooth_errors,
    tracking_error,
)
from bumpless.control.schedule import gain_share, schedule_gains
from bumpless.control.stop import stop_actuators
from bumpless.control.supervisor import change_mode, count_hover, filter_detection, in_range, supervise
from bumpless.control.switching import begin_ramp, blend, limit_increments, transition_factor
from bumpless.jit import jit


@jit
def autopilot_cycle(handle, onboard, m):
    """Advance the ONBOARD record by one cycle in whatever phase it is, with the MEASUREMENT m.

    handle: of the QP solver, see `allocation.qp`. While IDLE the measurement is not looked at.
    """
    settings, orders, s, out = onboard.settings, onboard.orders, onboard.state, onboard.output
    phase = orders.phase
    if phase != IDLE:
        locate(settings, onboard.sensors, onboard.model, m, s, out.navigation)
    captured = phase != IDLE and m.captured == 1
    if captured:
        note_capture(s.clock.cycle, s.docking)
        count_hover(True, s.supervisor)
    if phase == IDLE or phase == ABORTED or captured:
        see_flow(settings.guidance, s.navigation.smooth_nu_r, out.navigation.nu_flow)
        stop_actuators(settings.dt, onboard.model, out.navigation.nu_flow, s, out)
    else:
        fly_cycle(handle, onboard, m)
    orders.change = 0
    s.clock.cycle += 1
    s.clock.time += settings.dt
    if phase == RUNNING and is_completed(onboard.plan, s.clock.cycle, s):
        orders.phase = COMPLETED


@jit
def is_completed(plan, cycle, s):
    """Whether the mission's hold has lasted, docking is given up, or its time is up. s: STATE."""
    held = plan.hold_cycles > 0 and s.supervisor.hover_cycles >= plan.hold_cycles
    return held or s.docking.stage == HOLD or cycle >= plan.cycles


@jit
def locate(settings, sensors, model, m, s, out):
    """Where the vehicle is and how it moves through water; fills the NAVIGATION_OUTPUT. s: STATE."""
    navigation, first = s.navigation, s.clock.cycle == 0
    dt, believed = settings.dt, s.belief.effectiveness
    navigate(dt, settings.navigation, s.clock, sensors, model, believed, m, navigation, out)
    smooth_flow(dt, settings.guidance, first, out.nu_r, navigation.smooth_nu_r)


@jit
def fly_cycle(handle, onboard, m):
    """From a located vehicle to its commands."""
    settings, plan, model, s = onboard.settings, onboard.plan, onboard.model, onboard.state
    out, cycle, dt = onboard.output, onboard.state.clock.cycle, onboard.settings.dt
    docks, phase = settings.docking.enabled == 1, onboard.orders.phase
    holding = is_holding(phase, docks, s.supervisor.mode)
    if settings.allocation.estimate == 1:
        estimate_effectiveness(
            dt, settings.allocation.fault_evidence, onboard.sensors, model, m, s.navigation,
            s.estimator, onboard.scratch.estimator,
        )  # fmt: skip
    if m.fresh == 1:
        filter_detection(settings.supervisor, out.navigation.sighted, s.supervisor)
    situation = out.situation
    switched = onboard.orders.change == 1
    if docks:
        look_docking(
            dt, plan, model, m.u_feedback, out.navigation.sighted, s, situation, out.docking
        )  # fmt: skip
        if cycle == 0:
            start_as_found(model, m, s)
    else:
        look(plan, s.navigation, situation)
    if phase != PAUSED and (docks or phase != COMPLETED):
        mode = choose_mode(onboard)
        if mode != s.supervisor.mode:
            change_mode(mode, cycle, s.supervisor)
            switched = True
    if docks:
        in_place = is_in_place(s, holding, situation.range, out.docking)
    else:
        in_place = in_range(settings.supervisor, situation.range, holding, s.supervisor)
    if plan.dock == 1:
        note_still(in_place, s.docking)
        in_place = False  # it is when captured
    count_hover(in_place, s.supervisor)
    orient(settings.supervisor, onboard.orders, holding, s, situation)
    sway = model.controllable[1] > 0.0
    if docks:
        refer_docking(settings, plan, s, situation, sway, out.docking, out.guidance)
    else:
        guide(dt, settings.guidance, plan, s.navigation, situation, sway, s.guidance, out.guidance)
    regulate(settings, plan, model, situation.mode, switched, s, out)
    command(handle, onboard)


@jit
def is_holding(phase, docks, mode):
    """Whether station is held at `orders.hold_point`, in H: in a pause, and after a mission that is over
    elsewhere than in H. The docking automaton has a hold of its own.
    """
    return phase == PAUSED or (phase == COMPLETED and not docks and mode != HOVER)


@jit
def choose_mode(onboard):
    """The mode for this cycle: by the docking automaton, or by the published one."""
    settings, plan, s, situation = onboard.settings, onboard.plan, onboard.state, onboard.output.situation
    if settings.docking.enabled == 1:
        phase, view = onboard.orders.phase, onboard.output.docking
        return stage_mode(settings, plan, onboard.model, phase, s, situation, view)
    going_around = s.guidance.leg >= plan.n_legs
    return supervise(settings.supervisor, s.supervisor, s.clock.cycle, situation.range, going_around)


@jit
def look(plan, navigation, situation):
    """Fill the observation point and the range to it, m."""
    station, eta = situation.station, navigation.eta
    observation_point(navigation.target, plan.target[3], plan.standoff, station)
    station[3] = plan.target[3]
    situation.range = hypot(station[0] - eta[0], station[1] - eta[1])


@jit
def orient(settings, orders, holding, s, situation):
    """Fill the rest of the SITUATION. settings: SUPERVISOR_SETTINGS; s: STATE."""
    situation.mode = HOVER if holding else s.supervisor.mode
    situation.holding = 1 if holding else 0
    if holding:
        for k in range(4):
            situation.station[k] = orders.hold_point[k]
    situation.detected = s.supervisor.detected
    situation.slow = 1 if situation.range < settings.d_fr_l else 0
    situation.u_r = s.navigation.smooth_nu_r[0]
    situation.adapt = 1 if s.switching.kappa >= 1.0 else 0
    situation.first = 1 if s.clock.cycle == 0 and s.docking.stage == 0 else 0


@jit
def regulate(settings, plan, model, mode, switched, s, out):
    """From references to the demand in force, s.switching.now.

    mode: whose gains and weights count; switched: a ramp into them begins in this cycle. s: STATE; out:
    OUTPUT. What no actuator can push is not demanded. Source: Gao et al. 2026, eq. (22).
    """
    navigation, pid, switching, gains = s.navigation, s.pid, s.switching, out.gains
    errors, chosen = pid.smooth, settings.modes[mode - FORWARD]
    cycle, dt = s.clock.cycle, settings.dt
    tracking_error(s.guidance.reference, navigation.eta, navigation.nu, out.navigation.depth_rate, out.errors)
    smooth_errors(dt, settings.guidance, cycle == 0, out.errors, errors)
    share = gain_share(settings.guidance, navigation.smooth_nu_r[0])
    if switched:
        begin_ramp(cycle, chosen, switching)
        carry_integrals(settings.bumpless.integral_at_switch, chosen, pid)
        if settings.bumpless.align == 1:
            schedule_gains(settings, chosen, share, s.belief.fault_share, switching.kappa, gains)
            align_integrals(settings.bumpless, chosen, gains, errors, s.allocation.tau_c, pid)
    switching.kappa = transition_factor(settings.bumpless, cycle, switching)
    believe_faults(settings.allocation, dt, s.clock.time, plan.faults, s.estimator, s.belief)
    schedule_gains(settings, chosen, share, s.belief.fault_share, switching.kappa, gains)
    if settings.docking.enabled == 1:
        trim_docking(settings, model, share, s, out.docking, gains)
    demand(gains, errors, pid, out.tau_plus)
    for k in range(6):
        out.tau_plus[k] *= model.controllable[k]
    blend(chosen, out.tau_plus, switching)
    limit_increments(settings.bumpless, settings.allocation.increment_price, switching, out.switching)


@jit
def pose(settings, s, out):
    """Fill the PROBLEM but for its bounds and tau_d, from what is in force. s: STATE; out: OUTPUT."""
    p, now = out.problem, s.switching.now
    p.dt, p.warm, p.refused = settings.dt, settings.bumpless.project, s.allocation.refused
    p.lam, p.increment_price, p.fin_rate = now.lam, out.switching.increment_price, 0.0
    see_flow(settings.guidance, s.navigation.smooth_nu_r, out.navigation.nu_flow)
    for k in range(6):
        p.nu_flow[k] = out.navigation.nu_flow[k]
    for i in range(p.R.shape[0]):
        p.R[i], p.u_previous[i] = now.R[i], s.allocation.u[i]
        p.effectiveness[i] = s.belief.effectiveness[i]
    soften(settings.allocation, now.Q, s.belief.fault_share, p.Q)


@jit
def command(handle, onboard):
    """From the demand to commands, and to what is remembered of how well it was met."""
    settings, model, s, out = onboard.settings, onboard.model, onboard.state, onboard.output
    p, solution, w = out.problem, out.solution, onboard.scratch.allocation
    memory, now = s.allocation, s.switching.now
    pose(settings, s, out)
    share = gain_share(settings.guidance, s.navigation.smooth_nu_r[0])
    surge = settings.guidance.schedule_speed * sqrt(share)
    step_share = out.switching.step_share
    if settings.docking.enabled == 1:
        view = out.docking
        p.fin_rate = 0.0 if out.situation.mode == FORWARD else settings.docking.fin_rate
        weigh_slow_moments(settings.docking, p, s.docking)
        leave_heave_to_pitch(model, p, now.tau_d, view, s.docking)
        allocate(handle, settings.allocation, model, view.asked, step_share, surge, p, solution, w)
        achieve(model, p, solution, memory.tau_c, w)
        memory.tau_c[2] -= view.lift
    else:
        allocate(handle, settings.allocation, model, now.tau_d, step_share, surge, p, solution, w)
        achieve(model, p, solution, memory.tau_c, w)
    report_slack(settings.allocation, now.Q, s.belief.fault_share, now.tau_d, memory.tau_c, solution.slack)
    note_unmet(now.tau_d, memory.tau_c, w.limited, s.pid)
    memory.refused = solution.refused
    for i in range(model.n_u):
        memory.u[i] = solution.u[i]
