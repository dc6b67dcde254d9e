"""The allocator's wrench map tau_c = G_m(x) and its analytic Jacobian.

Decision variables x are bound-normalised so that every actuator answers from rest: a fin's
deflection over its largest, and a thruster's *bollard thrust* T_nn n|n| over its largest. In shaft
speed the map has zero slope at n = 0 and Gauss-Newton could not start a stopped thruster.
Bounds in x are exact images of the bounds on deflection and shaft speed, because n -> n|n| is monotone.

Source: Gao et al. 2026, eq. (21)-(22), (27)-(36), (46), (50).
Differs: the inflow term T_nv |n| V_A is taken at the previous command, one cycle old. As an option
(`smoothing`, x_0) a screw passes through zero with a finite slope: n|n| = x holds far from zero only,
n ~ x (x^2 + x_0^2)^-1/4 everywhere, which misses at most 0.3 x_0 of the largest thrust.
As another (`fins_coast`) the fins' drag is taken as given, at the last command: fins do not brake.
"""

from math import sqrt

from bumpless.jit import inline, jit
from bumpless.physics.actuators import add_force, bollard_thrust, fin_force, inflow_along, shaft_speed
from bumpless.physics.model_record import FIN


@inline
def thrust_scale(model, i):
    """Bollard thrust at the upper command bound, N: the unit of a thruster's x."""
    return model.T_nn[i] * model.command_max[i] * model.command_max[i]


@inline
def to_x(model, i, command):
    """Normalised decision variable of a command (rad or rev/s)."""
    if model.kind[i] == FIN:
        return command / model.command_max[i]
    x = bollard_thrust(model, i, command) / thrust_scale(model, i)
    if model.smoothing > 0.0:
        y = x * x
        x = sqrt(0.5 * (y + sqrt(y * (y + 4.0 * model.smoothing**2)))) * (1.0 if x >= 0.0 else -1.0)
    return x


@inline
def to_command(model, i, x):
    """Command (rad or rev/s) of a normalised decision variable."""
    if model.kind[i] == FIN:
        return x * model.command_max[i]
    if model.smoothing > 0.0:
        x *= abs(x) / sqrt(x * x + model.smoothing**2)
    return shaft_speed(model, i, x * thrust_scale(model, i))


@jit
def wrench_map(model, x, u_previous, effectiveness, nu_r, tau, jacobian):
    """Fill tau (6,) = G(x) and jacobian (6, 8) = dG/dx, N and N m per unit of x.

    u_previous (8,): last command, for the inflow term; effectiveness (8,): as the allocator believes
    it to be; nu_r (6,): estimated velocity through water.
    """
    for k in range(6):
        tau[k] = 0.0
        for i in range(jacobian.shape[1]):
            jacobian[k, i] = 0.0
    column = jacobian.T
    for i in range(model.n_u):
        e = model.direction[i]
        alpha = effectiveness[i]
        if model.kind[i] == FIN:
            scale = model.command_max[i]
            fx, fe, dx, de = fin_force(model, i, x[i] * scale, nu_r)
            if model.fins_coast == 1:
                fx, _, _, _ = fin_force(model, i, u_previous[i], nu_r)
                dx = 0.0
            add_force(model, i, alpha * (fx + fe * e[0]), alpha * fe * e[1], alpha * fe * e[2], tau)
            g = alpha * scale
            add_force(model, i, g * (dx + de * e[0]), g * de * e[1], g * de * e[2], column[i])
        else:
            scale = thrust_scale(model, i)
            z = x[i] * scale
            speed = abs(u_previous[i])
            inflow = inflow_along(model, i, nu_r, e[0], e[1], e[2])
            thrust = alpha * (z - model.T_nv[i] * speed * inflow)
            arm = model.Q_nn[i] / (model.T_nn[i] if z >= 0.0 else model.T_nn_reverse[i])
            torque = alpha * (arm * z - model.Q_nv[i] * speed * inflow)
            add_force(model, i, thrust * e[0], thrust * e[1], thrust * e[2], tau)
            g = alpha * scale
            add_force(model, i, g * e[0], g * e[1], g * e[2], column[i])
            for k in range(3):
                tau[3 + k] += torque * e[k]
                column[i, 3 + k] += g * arm * e[k]
