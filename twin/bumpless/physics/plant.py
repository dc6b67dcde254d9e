"""The true vehicle in the true water, advanced by one control period.

Source: Gao et al. 2026, eq. (1)-(20); classical Runge-Kutta 4 with the commands held (ZOH).
"""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n
from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.actuators import lag_rate, total_wrench
from bumpless.physics.dock.latch import can_touch, close_latch, feel_dock, steps_near
from bumpless.physics.dynamics import body_acceleration, displaced_water_force
from bumpless.physics.faults import blend_faults
from bumpless.physics.frames import body_to_ned, euler_rates, ned_to_body
from bumpless.physics.surface import lose_buoyancy
from bumpless.physics.water import step_gust, water_velocity

f8 = np.float64

N_STATE = 20  # eta, nu, actuator states

SEEN = np.dtype(  # follows from the state: nothing here is remembered
    [
        ("current", f8, 3),  # NED at the vehicle, m/s
        ("current_dot", f8, 3),
        ("tau", f8, 6),  # actuator wrench, N and N m
    ],
    align=True,
)

PLANT = np.dtype(
    [
        ("time", f8),
        ("eta", f8, 6),
        ("nu", f8, 6),
        ("u", f8, _n),  # where the actuators are, rad or rev/s
        ("gust", f8, 6),  # of the current, m/s; from 3 on eddies of unit deviation
        ("effectiveness", f8, _n),
        ("seen", SEEN),
    ],
    align=True,
)


@jit
def state_rate(model, environment, gust, effectiveness, time, x, command, rate):
    """rate (20,) = d/dt [eta nu u] at state x, commands held. Source: Gao et al. 2026, eq. (1)-(7)."""
    eta, nu, u = x[0:6], x[6:12], x[12:20]
    phi, theta, psi = eta[3], eta[4], eta[5]
    v_c, a_c, body = floats(3), floats(3), floats(3)
    nu_r, nu_c_dot, tau, force = floats(6), floats(6), floats(6), floats(6)
    water_velocity(environment, gust, time, eta, v_c, a_c)
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
        tau[k] += environment.tau_e[k]
    if environment.surface == 1:
        lose_buoyancy(model, environment, time, eta, tau)
    if can_touch(environment.dock, model.rings, eta):
        feel_dock(environment.dock, model.rings, eta, nu, time, tau)
    body_acceleration(model, eta, nu, nu_r, nu_c_dot, tau, force, rate[6:12])
    body_to_ned(phi, theta, psi, nu, rate)
    rate[3], rate[4], rate[5] = euler_rates(phi, theta, nu[3], nu[4], nu[5])
    for i in range(model.n_u):
        rate[12 + i] = lag_rate(model, i, command[i], u[i])
    for i in range(model.n_u, 8):
        rate[12 + i] = 0.0


@jit
def step_plant(model, environment, faults, plant, command, dt, substeps, noise):
    """Advance `plant` by dt seconds in `substeps` Runge-Kutta steps under held commands (8,); more at a dock.

    noise: the cycle's standard normal samples, for gusts and eddies.
    """
    step_gust(environment, plant.gust, dt, noise)
    environment.dock.felt.peak = 0.0
    x, k, mid, total = floats(N_STATE), floats(N_STATE), floats(N_STATE), floats(N_STATE)
    for i in range(6):
        x[i] = plant.eta[i]
        x[6 + i] = plant.nu[i]
    for i in range(8):
        x[12 + i] = plant.u[i]
    steps = steps_near(environment.dock, model.rings, plant.eta, plant.nu, dt, substeps)
    h = dt / steps
    for _ in range(steps):
        t = plant.time
        state_rate(model, environment, plant.gust, plant.effectiveness, t, x, command, k)
        for i in range(N_STATE):
            total[i] = k[i]
            mid[i] = x[i] + 0.5 * h * k[i]
        state_rate(model, environment, plant.gust, plant.effectiveness, t + 0.5 * h, mid, command, k)
        for i in range(N_STATE):
            total[i] += 2.0 * k[i]
            mid[i] = x[i] + 0.5 * h * k[i]
        state_rate(model, environment, plant.gust, plant.effectiveness, t + 0.5 * h, mid, command, k)
        for i in range(N_STATE):
            total[i] += 2.0 * k[i]
            mid[i] = x[i] + h * k[i]
        state_rate(model, environment, plant.gust, plant.effectiveness, t + h, mid, command, k)
        for i in range(N_STATE):
            x[i] += h / 6.0 * (total[i] + k[i])
        plant.time = t + h
    blend_faults(faults, plant.time, plant.effectiveness)
    for i in range(6):
        plant.eta[i] = x[i]
        plant.nu[i] = x[6 + i]
    for i in range(8):
        plant.u[i] = x[12 + i]
    observe_plant(model, environment, plant)


@jit
def observe_plant(model, environment, plant):
    """Fill plant.seen, present current and actuator wrench, and what a dock does, from the plant's state."""
    body, nu_r, seen = floats(3), floats(6), plant.seen
    water_velocity(environment, plant.gust, plant.time, plant.eta, seen.current, seen.current_dot)
    ned_to_body(plant.eta[3], plant.eta[4], plant.eta[5], seen.current, body)
    for i in range(3):
        nu_r[i] = plant.nu[i] - body[i]
        nu_r[3 + i] = plant.nu[3 + i]
    if environment.dock.present == 1:
        feel_dock(environment.dock, model.rings, plant.eta, plant.nu, plant.time, seen.tau)
        close_latch(environment.dock)
    total_wrench(model, plant.u, plant.effectiveness, nu_r, seen.tau)  # fills it anew
