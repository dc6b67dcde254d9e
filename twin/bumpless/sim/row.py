"""One cycle as a row of the log: what the autopilot thought, beside what was true."""

from math import hypot, nan

from bumpless.contract.enums import ABORTED, IDLE
from bumpless.control.guidance.station import observation_point
from bumpless.jit import jit
from bumpless.jit.memory import floats


@jit
def write_row(onboard, world, phase, row):
    """Fill a LOG row after a cycle that was flown in `phase`, before the plant moves on."""
    s, out, m = onboard.state, onboard.output, world.measurement
    settings, plan = onboard.settings, onboard.plan
    cycle = s.clock.cycle - 1
    row.time, row.cycle, row.phase = s.clock.time - settings.dt, cycle, phase
    row.leg, row.leg_count = s.guidance.leg, plan.n_legs
    row.detected_raw, row.depth = m.detected, m.depth
    row.range = out.situation.range
    row.cross_track, row.along_track = out.guidance.cross_track, out.guidance.along_track
    write_supervisor(settings, cycle, s, row)
    row.flown = 0 if phase == IDLE or phase == ABORTED else out.situation.mode
    write_navigation(s.navigation, row)
    write_control(s, out, row)
    write_allocation(onboard.model, s, out, row)
    write_faults(settings.allocation, onboard.model, s, row)
    heading = plan.target[3] if s.docking.stage == 0 else s.docking.heading
    observation_point(s.navigation.target, heading, plan.standoff, row.observation_point)
    for k in range(3):
        row.target_measured[k] = m.target[k] if m.detected == 1 else nan
    for i in range(onboard.model.n_u):
        row.u_feedback[i] = m.u_feedback[i]
    row.target[3] = heading
    write_docking(settings, s.docking, out.docking, row)
    row.held = s.supervisor.hover_cycles * settings.dt
    write_truth(onboard.model.n_u, world.truth, world.plant, row)
    write_dock(world.truth.environment.dock, row)
    if s.docking.stage > 0:
        write_true_range(world.truth, world.plant, heading, row)


@jit
def write_docking(settings, docking, view, row):
    """Stage, tries and reason. settings: SETTINGS; view: DOCKING_OUTPUT."""
    row.stage, row.tried, row.reason = docking.stage, docking.tried, docking.reason
    row.tries = settings.docking.tries if docking.stage > 0 else 0
    row.cleared = 1 if docking.cleared == 1 and view.left <= settings.docking.gate_distance else 0
    row.approach, row.fix_age = docking.heading, docking.fix_age * settings.dt


@jit
def write_true_range(truth, plant, heading, row):
    """The true range in docking: 3-D, to the observation point for the approach heading in use, rad."""
    point = floats(3)
    observation_point(truth.target, heading, truth.standoff, point)
    flat = hypot(point[0] - plant.eta[0], point[1] - plant.eta[1])
    row.range_true = hypot(flat, point[2] - plant.eta[2])


@jit
def write_supervisor(settings, cycle, s, row):
    """Mode, and how long it lasts and must last. s: STATE."""
    supervisor = s.supervisor
    row.mode, row.previous_mode = supervisor.mode, supervisor.previous_mode
    row.kappa, row.detected = s.switching.kappa, supervisor.detected
    row.time_in_mode = max(0, cycle - max(supervisor.switch_cycle, 0)) * settings.dt
    row.hits, bits = 0, supervisor.history
    while bits:
        bits &= bits - 1
        row.hits += 1
    row.hold_left = supervisor.hold_left
    waited = cycle - supervisor.switch_cycle
    row.dwell_remaining = max(0, settings.supervisor.n_dwell - waited) * settings.dt


@jit
def write_navigation(navigation, row):
    """The estimate."""
    for k in range(6):
        row.eta_hat[k], row.nu_hat[k] = navigation.eta[k], navigation.nu[k]
    for k in range(3):
        row.nu_r_hat[k], row.current_hat[k] = navigation.smooth_nu_r[k], navigation.current[k]
        row.target[k] = navigation.target[k]


@jit
def write_control(s, out, row):
    """References, errors and demands. s: STATE; out: OUTPUT."""
    for k in range(6):
        row.reference[k], row.error[k] = s.guidance.reference[k], out.errors.e[k]
        row.integral[k] = s.pid.integral[k] + s.pid.bias[k]
        row.tau_d[k], row.tau_minus[k] = s.switching.now.tau_d[k], s.switching.minus.tau_d[k]
        row.tau_plus[k], row.tau_c[k] = out.tau_plus[k], s.allocation.tau_c[k]


@jit
def write_allocation(model, s, out, row):
    """What was solved and how well. s: STATE; out: OUTPUT."""
    p, solution, total = out.problem, out.solution, 0.0
    row.status, row.iterations, row.kkt, row.cost = (
        solution.status,
        solution.iterations,
        solution.kkt,
        solution.cost,
    )
    row.solve_time = solution.solve_time
    for k in range(6):
        row.slack[k] = solution.slack[k]
        total += p.Q[k] * (s.switching.now.tau_d[k] - s.allocation.tau_c[k]) ** 2
    row.residual_norm = total**0.5
    for i in range(model.n_u):
        row.u[i] = s.allocation.u[i]
        row.u_lower[i], row.u_upper[i], row.du_max[i] = p.u_lower[i], p.u_upper[i], p.du_max[i]


@jit
def write_faults(settings, model, s, row):
    """Effectiveness as estimated, or as told. settings: ALLOCATION_SETTINGS; s: STATE."""
    e, row.faults = s.estimator, 0
    for k in range(6):
        row.unexplained[k] = e.x[k, 1]
    for i in range(model.n_u):
        estimated = 1.0 - e.loss[i]
        row.effectiveness_hat[i] = estimated if settings.estimate == 1 else s.belief.effectiveness[i]
        row.fault_evidence[i] = e.evidence[i]
        row.faults |= e.faulty[i] << i


@jit
def write_dock(dock, row):
    """How the hull meets a dock to enter."""
    row.captured, row.contact_most = dock.captured, dock.force_most
    row.contact_force, row.nose_depth = dock.felt.peak, dock.felt.nose_depth
    row.nose_offset = dock.felt.nose_offset


@jit
def write_truth(n_u, truth, plant, row):
    """What only a simulation can tell."""
    point = floats(3)
    for k in range(6):
        row.eta[k], row.nu[k], row.tau[k] = plant.eta[k], plant.nu[k], plant.seen.tau[k]
    for i in range(n_u):
        row.effectiveness[i] = plant.effectiveness[i]
    for k in range(3):
        row.current[k], row.target_true[k] = plant.seen.current[k], truth.target[k]
    observation_point(truth.target, truth.target[3], truth.standoff, point)
    row.range_true = hypot(point[0] - plant.eta[0], point[1] - plant.eta[1])
