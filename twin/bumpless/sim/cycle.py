"""The closed loop, compiled: one cycle at a time for the live node, a whole run for everything else.

Both are the same function, `fly`, so what is fast is also what flies.
"""

from math import hypot, nan

from bumpless.control.autopilot import autopilot_step, smooth_flow, stop_actuators
from bumpless.control.guidance import observation_point
from bumpless.control.navigation import navigate
from bumpless.jit import jit
from bumpless.physics.plant import step_plant
from bumpless.physics.sensors import measure

IDLE, RUNNING, PAUSED, COMPLETED, ABORTED = 1, 2, 3, 4, 5  # MissionPhase of the contract
SUBSTEPS = 2  # Runge-Kutta steps per control period


@jit
def write_row(settings, plan, truth, model, plant, m, a, phase, row, work):
    """Copy this cycle into a LOG row. work: scratch, at least 3 floats."""
    row.time, row.cycle, row.phase = a.time - settings.dt, a.cycle - 1, phase
    row.mode, row.previous_mode, row.kappa = a.mode, a.previous_mode, a.kappa
    since = max(0, a.cycle - 1 - max(a.switch_cycle, 0))
    row.time_in_mode = since * settings.dt
    waited = a.cycle - 1 - a.switch_cycle
    row.dwell_remaining = max(0, settings.n_dwell - waited) * settings.dt
    row.range, row.detected_raw, row.detected = a.range, m.detected, a.detected
    row.depth, row.cross_track, row.along_track = m.depth, a.cross_track, a.along_track
    row.leg, row.leg_count = a.leg, plan.n_legs
    row.status, row.iterations, row.kkt, row.cost = a.status, a.iterations, a.kkt, a.cost
    row.solve_time = a.solve_time
    total = 0.0
    for k in range(6):
        row.eta_hat[k], row.nu_hat[k] = a.eta[k], a.nu[k]
        row.reference[k], row.error[k] = a.reference[k], a.error[k]
        row.integral[k] = a.integral[k] + a.bias[k]
        row.tau_d[k], row.tau_plus[k], row.tau_minus[k] = a.tau_d[k], a.tau_plus[k], a.tau_minus[k]
        row.tau_c[k] = a.tau_c[k]
        row.slack[k] = a.slack[k]
        row.unexplained[k] = a.estimator.x[k, 1]
        row.eta[k], row.nu[k], row.tau[k] = plant.eta[k], plant.nu[k], plant.tau[k]
        total += a.Q[k] * (a.tau_d[k] - a.tau_c[k]) ** 2
    row.residual_norm = total**0.5
    row.faults = 0
    for i in range(model.n_u):
        row.u[i], row.u_feedback[i] = a.u[i], m.u_feedback[i]
        row.u_lower[i], row.u_upper[i], row.du_max[i] = a.u_lower[i], a.u_upper[i], a.du_max[i]
        row.effectiveness[i] = plant.effectiveness[i]
        estimated = 1.0 - a.estimator.loss[i]
        row.effectiveness_hat[i] = estimated if settings.estimate == 1 else a.effectiveness[i]
        row.fault_evidence[i] = a.estimator.evidence[i]
        row.faults |= a.estimator.faulty[i] << i
    observation_point(plan, a, row.observation_point)
    for k in range(3):
        row.nu_r_hat[k], row.current_hat[k] = a.flow[k], a.current[k]
        row.target_measured[k] = m.target[k] if m.detected == 1 else nan
        row.target[k] = a.target[k]
        row.current[k] = plant.current[k]
        row.target_true[k] = truth.target[k]
    row.target[3] = plan.target[3]
    observation_point(truth, truth, work)
    row.range_true = hypot(work[0] - plant.eta[0], work[1] - plant.eta[1])


@jit
def closed_loop(
    handle,
    settings,
    modes,
    sensors,
    plan,
    truth,
    model,
    plant_model,
    plant,
    m,
    a,
    w,
    phase,
    change,
    noise,
    row,
    work,
):
    """One control cycle of plant and autopilot; fills `row`. Returns the phase after it.

    plan and model are what the autopilot knows, truth and plant_model what is true; measurements `m` are the
    only way from the one to the other. noise (N_NOISE,): this cycle's standard normal samples. While idle the
    plant is moored.
    """
    if phase == IDLE:
        stop_actuators(settings, model, a)
        write_row(settings, plan, truth, model, plant, m, a, phase, row, work)
        return phase
    measure(sensors, truth, plant, a.cycle, noise, m)
    if phase == ABORTED:
        navigate(settings, sensors, m, a, work)
        smooth_flow(settings, a)
        stop_actuators(settings, model, a)
    else:
        autopilot_step(handle, settings, modes, sensors, plan, model, m, a, w, change, work)
    write_row(settings, plan, truth, model, plant, m, a, phase, row, work)
    step_plant(plant_model, truth, plant, a.u, settings.dt, SUBSTEPS, noise, work)
    if phase == RUNNING:
        if plan.hold_cycles > 0 and a.hover_cycles >= plan.hold_cycles:
            return COMPLETED
        if a.cycle >= plan.cycles:
            return COMPLETED
    return phase


@jit
def fly(
    handle,
    settings,
    modes,
    sensors,
    plan,
    truth,
    model,
    plant_model,
    plant,
    m,
    a,
    w,
    phase,
    change,
    noise,
    log,
    work,
):
    """Up to len(log) cycles, ending with the one that changes the phase: (rows written, phase after them).

    The records come as arrays of one, noise is (len(log), N_NOISE). Handed over as records they cost the
    live cycle four times what it takes to fly: NumPy describes each of some 300 fields at each call.
    """
    begun = phase
    for k in range(log.shape[0]):
        phase = closed_loop(
            handle,
            settings[0],
            modes,
            sensors[0],
            plan[0],
            truth[0],
            model[0],
            plant_model[0],
            plant[0],
            m[0],
            a[0],
            w[0],
            phase,
            change,
            noise[k],
            log[k],
            work,
        )
        change = 0
        if phase != begun:
            return k + 1, phase
    return log.shape[0], phase
