"""The true vehicle in the true water, advanced by one control period.

Source: Gao et al. 2026, eq. (1)-(20); classical Runge-Kutta 4 with the commands held (ZOH).
"""

import numpy as np

from bumpless.jit import jit
from bumpless.physics.actuators import lag_rate, total_wrench
from bumpless.physics.dynamics import body_acceleration, displaced_water_force
from bumpless.physics.frames import body_to_ned, euler_rates, ned_to_body
from bumpless.physics.water import step_gust, water_velocity

N_STATE = 20  # eta, nu, actuator states
N_WORK = 128  # scratch floats that `step_plant` needs


@jit
def state_rate(model, truth, gust, effectiveness, time, x, command, rate, work):
    """rate (20,) = d/dt [eta nu u] at state x, commands held. work: scratch, at least 48 floats."""
    eta, nu, u = x[0:6], x[6:12], x[12:20]
    phi, theta, psi = eta[3], eta[4], eta[5]
    v_c, a_c = work[0:3], work[3:6]
    nu_r, nu_c_dot, tau, force, body = work[6:12], work[12:18], work[18:24], work[24:30], work[30:33]
    water_velocity(truth, gust, time, eta, v_c, a_c)
    ned_to_body(phi, theta, psi, v_c, body)
    for k in range(3):
        nu_r[k] = nu[k] - body[k]
        nu_r[3 + k] = nu[3 + k]
        nu_c_dot[3 + k] = 0.0
    total_wrench(model, u, effectiveness, nu_r, tau)
    ned_to_body(phi, theta, psi, a_c, nu_c_dot)
    displaced_water_force(model, nu_c_dot, tau)
    nu_c_dot[0] -= nu[4] * body[2] - nu[5] * body[1]
    nu_c_dot[1] -= nu[5] * body[0] - nu[3] * body[2]
    nu_c_dot[2] -= nu[3] * body[1] - nu[4] * body[0]
    for k in range(6):
        tau[k] += truth.tau_e[k]
    body_acceleration(model, eta, nu, nu_r, nu_c_dot, tau, force, rate[6:12])
    body_to_ned(phi, theta, psi, nu, rate)
    rate[3], rate[4], rate[5] = euler_rates(phi, theta, nu[3], nu[4], nu[5])
    for i in range(model.n_u):
        rate[12 + i] = lag_rate(model, i, command[i], u[i])
    for i in range(model.n_u, 8):
        rate[12 + i] = 0.0


@jit
def apply_faults(truth, time, effectiveness):
    """Effectiveness (8,) of each actuator at `time`; each fault is blended in over its own time."""
    for i in range(effectiveness.shape[0]):
        effectiveness[i] = 1.0
    for f in range(truth.n_faults):
        elapsed = time - truth.fault_time[f]
        if elapsed > 0.0:
            share = min(1.0, elapsed / truth.fault_blend[f]) if truth.fault_blend[f] > 0.0 else 1.0
            effectiveness[truth.fault_actuator[f]] = 1.0 + share * (truth.fault_effectiveness[f] - 1.0)


@jit
def step_plant(model, truth, plant, command, dt, substeps, noise, work):
    """Advance `plant` by dt seconds in `substeps` Runge-Kutta steps under held commands (8,).

    noise: at least 3 standard normal samples for the gusts; work: scratch of N_WORK floats.
    """
    step_gust(truth, plant.gust, dt, noise)
    x, k, mid, total = work[0:20], work[20:40], work[40:60], work[60:80]
    inner = work[80:128]
    for i in range(6):
        x[i] = plant.eta[i]
        x[6 + i] = plant.nu[i]
    for i in range(8):
        x[12 + i] = plant.u[i]
    h = dt / substeps
    for _ in range(substeps):
        t = plant.time
        state_rate(model, truth, plant.gust, plant.effectiveness, t, x, command, k, inner)
        for i in range(N_STATE):
            total[i] = k[i]
            mid[i] = x[i] + 0.5 * h * k[i]
        state_rate(model, truth, plant.gust, plant.effectiveness, t + 0.5 * h, mid, command, k, inner)
        for i in range(N_STATE):
            total[i] += 2.0 * k[i]
            mid[i] = x[i] + 0.5 * h * k[i]
        state_rate(model, truth, plant.gust, plant.effectiveness, t + 0.5 * h, mid, command, k, inner)
        for i in range(N_STATE):
            total[i] += 2.0 * k[i]
            mid[i] = x[i] + h * k[i]
        state_rate(model, truth, plant.gust, plant.effectiveness, t + h, mid, command, k, inner)
        for i in range(N_STATE):
            x[i] += h / 6.0 * (total[i] + k[i])
        plant.time = t + h
    apply_faults(truth, plant.time, plant.effectiveness)
    for i in range(6):
        plant.eta[i] = x[i]
        plant.nu[i] = x[6 + i]
    for i in range(8):
        plant.u[i] = x[12 + i]
    observe_plant(model, truth, plant, inner)


@jit
def observe_plant(model, truth, plant, work):
    """Fill the plant's present current and actuator wrench from its state."""
    body, nu_r = work[0:3], work[3:9]
    water_velocity(truth, plant.gust, plant.time, plant.eta, plant.current, plant.current_dot)
    ned_to_body(plant.eta[3], plant.eta[4], plant.eta[5], plant.current, body)
    for i in range(3):
        nu_r[i] = plant.nu[i] - body[i]
        nu_r[3 + i] = plant.nu[3 + i]
    total_wrench(model, plant.u, plant.effectiveness, nu_r, plant.tau)


def new_work() -> np.ndarray:
    """Scratch space for `step_plant`."""
    return np.zeros(N_WORK)
