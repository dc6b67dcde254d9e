"""What one actuator does: thrusters, fins, and their lag.

Source: Gao et al. 2026, eq. (8)-(20), (23)-(26).
Differs: K_T and K_Q are taken linear in the advance ratio, so that
T = rho D^4 K_T(J) n|n| becomes T_nn n|n| - T_nv |n| V_A, finite at n = 0. A fin's force keeps the
full drift angle beta, so that it is right in reversed flow and at rest; the paper sets alpha = delta.
"""

from math import atan2, cos, pi, sin, sqrt

from twin.compiled import inline, jit
from twin.frames import wrap
from twin.records import FIN

STALL_WIDTH = 0.12  # rad over which attached flow gives way to a flat plate's


@inline
def inflow_along(model, i, nu_r, ex, ey, ez):
    """Speed of actuator i through the water along (ex, ey, ez), m/s: (nu_1 + omega x r_i) . e"""
    x, y, z = model.position[i, 0], model.position[i, 1], model.position[i, 2]
    return (
        ex * (nu_r[0] + nu_r[4] * z - nu_r[5] * y)
        + ey * (nu_r[1] + nu_r[5] * x - nu_r[3] * z)
        + ez * (nu_r[2] + nu_r[3] * y - nu_r[4] * x)
    )


@jit
def fin_coefficients(model, i, alpha):
    """(C_L, C_D, dC_L/dalpha, dC_D/dalpha) of fin i at angle of attack alpha, rad, any alpha.

    Attached flow: C_L linear, C_D parabolic. Beyond the stall angle: a flat plate,
    C_L = sin 2 alpha, C_D = 2 sin^2 alpha, blended in over 0.12 rad. Flow from the trailing edge
    leaves only the share `reverse_lift` of the lift slope.
    """
    a = wrap(alpha)
    slope = model.C_La[i]
    if a > 0.5 * pi:
        a -= pi
        slope *= model.reverse_lift[i]
    elif a < -0.5 * pi:
        a += pi
        slope *= model.reverse_lift[i]
    c_l, d_l = slope * a, slope
    c_d, d_d = model.C_D0[i] + model.C_D2[i] * a * a, 2.0 * model.C_D2[i] * a
    excess = abs(a) - model.stall_angle[i]
    if excess > 0.0:
        plate_l, plate_dl = sin(2.0 * a), 2.0 * cos(2.0 * a)
        plate_d, plate_dd = model.C_D0[i] + 2.0 * sin(a) ** 2, 2.0 * sin(2.0 * a)
        t = min(1.0, excess / STALL_WIDTH)
        s = t * t * (3.0 - 2.0 * t)
        ds = 6.0 * t * (1.0 - t) / STALL_WIDTH * (1.0 if a > 0.0 else -1.0)
        d_l = (1.0 - s) * d_l + s * plate_dl + ds * (plate_l - c_l)
        d_d = (1.0 - s) * d_d + s * plate_dd + ds * (plate_d - c_d)
        c_l = (1.0 - s) * c_l + s * plate_l
        c_d = (1.0 - s) * c_d + s * plate_d
    return c_l, c_d, d_l, d_d


@jit
def fin_force(model, i, delta, nu_r):
    """(F_x, F_e, dF_x/ddelta, dF_e/ddelta): force of fin i along x_b and along its lift direction, N.

    delta in rad, nu_r (6,) relative velocity in body axes. Source: eq. (14)-(20).
    """
    e = model.direction[i]
    u = inflow_along(model, i, nu_r, 1.0, 0.0, 0.0)
    v = inflow_along(model, i, nu_r, e[0], e[1], e[2])
    speed2 = u * u + v * v
    if speed2 < 1e-12:
        return 0.0, 0.0, 0.0, 0.0
    c_l, c_d, d_l, d_d = fin_coefficients(model, i, delta - atan2(v, u))
    speed = sqrt(speed2)
    cb, sb = u / speed, v / speed
    qa = 0.5 * model.rho * speed2 * model.fin_area[i]
    return (
        qa * (-c_d * cb - c_l * sb),
        qa * (-c_d * sb + c_l * cb),
        qa * (-d_d * cb - d_l * sb),
        qa * (-d_d * sb + d_l * cb),
    )


@inline
def bollard_thrust(model, i, n):
    """T_nn n|n|: thrust of thruster i at shaft speed n (rev/s) in still water, N."""
    return (model.T_nn[i] if n >= 0.0 else model.T_nn_reverse[i]) * n * abs(n)


@inline
def shaft_speed(model, i, thrust):
    """Inverse of `bollard_thrust`, rev/s."""
    if thrust >= 0.0:
        return sqrt(thrust / model.T_nn[i])
    return -sqrt(-thrust / model.T_nn_reverse[i])


@jit
def thruster_force(model, i, n, nu_r):
    """(T, Q): thrust (N) and shaft torque (N m) of thruster i along its direction. Source: eq. (9)."""
    d = model.direction[i]
    inflow = inflow_along(model, i, nu_r, d[0], d[1], d[2])
    thrust = bollard_thrust(model, i, n) - model.T_nv[i] * abs(n) * inflow
    torque = model.Q_nn[i] * n * abs(n) - model.Q_nv[i] * abs(n) * inflow
    return thrust, torque


@inline
def add_force(model, i, fx, fy, fz, out):
    """Add force (fx, fy, fz) applied at actuator i, [f ; r x f], to the wrench out (6,)."""
    x, y, z = model.position[i, 0], model.position[i, 1], model.position[i, 2]
    out[0] += fx
    out[1] += fy
    out[2] += fz
    out[3] += y * fz - z * fy
    out[4] += z * fx - x * fz
    out[5] += x * fy - y * fx


@jit
def add_wrench(model, i, command, nu_r, share, out):
    """Add `share` of the wrench of actuator i to out (6,), N and N m about O_b. Source: eq. (23)-(26).

    command: deflection (rad) or shaft speed (rev/s) as it is now; nu_r (6,) relative velocity.
    """
    ex, ey, ez = model.direction[i, 0], model.direction[i, 1], model.direction[i, 2]
    if model.kind[i] == FIN:
        fx, fe, _, _ = fin_force(model, i, command, nu_r)
        fx, fe = share * fx, share * fe
        add_force(model, i, fx + fe * ex, fe * ey, fe * ez, out)
    else:
        thrust, torque = thruster_force(model, i, command, nu_r)
        thrust, torque = share * thrust, share * torque
        add_force(model, i, thrust * ex, thrust * ey, thrust * ez, out)
        out[3] += torque * ex
        out[4] += torque * ey
        out[5] += torque * ez


@jit
def actuator_wrench(model, i, command, nu_r, out):
    """Add the wrench of actuator i, all of it, to out (6,)."""
    add_wrench(model, i, command, nu_r, 1.0, out)


@jit
def total_wrench(model, u, effectiveness, nu_r, out):
    """out (6,) = sum over actuators, each scaled by its effectiveness (1 = healthy)."""
    for k in range(6):
        out[k] = 0.0
    for i in range(model.n_u):
        add_wrench(model, i, u[i], nu_r, effectiveness[i], out)


@inline
def lag_rate(model, i, command, u):
    """Rate of actuator state u towards its command: first-order lag within the rate limit."""
    rate = (command - u) / model.time_constant[i]
    limit = model.command_rate[i]
    return min(max(rate, -limit), limit)
