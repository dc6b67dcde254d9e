"""What one actuator does: thrusters, fins, and their lag.

Source: Gao et al. 2026, eq. (8)-(20), (23)-(26).
Differs: K_T and K_Q are taken linear in the advance ratio, so that
T = rho D^4 K_T(J) n|n| becomes T_nn n|n| - T_nv |n| V_A, finite at n = 0. A fin's force keeps the
full drift angle beta, so that it is right in reversed flow and at rest; the paper sets alpha = delta.
"""

from math import atan, atan2, cos, pi, sin, sqrt

from bumpless.jit import inline, jit
from bumpless.physics.frames import wrap
from bumpless.physics.model_record import FIN as FIN
from bumpless.physics.model_record import THRUSTER as THRUSTER

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


@inline
def drift_angle(u, v):
    """beta = atan2(v, u), rad; where it will do by the arctangent of one number, in half the time."""
    return atan(v / u) if u > abs(v) else atan2(v, u)


@inline
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
        sa, ca = sin(a), cos(a)
        plate_l, plate_dl = 2.0 * sa * ca, 2.0 * (ca * ca - sa * sa)
        plate_d, plate_dd = model.C_D0[i] + 2.0 * sa * sa, 4.0 * sa * ca
        t = min(1.0, excess / STALL_WIDTH)
        s = t * t * (3.0 - 2.0 * t)
        ds = 6.0 * t * (1.0 - t) / STALL_WIDTH * (1.0 if a > 0.0 else -1.0)
        d_l = (1.0 - s) * d_l + s * plate_dl + ds * (plate_l - c_l)
        d_d = (1.0 - s) * d_d + s * plate_dd + ds * (plate_d - c_d)
        c_l = (1.0 - s) * c_l + s * plate_l
        c_d = (1.0 - s) * c_d + s * plate_d
    return c_l, c_d, d_l, d_d


@inline
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
    c_l, c_d, d_l, d_d = fin_coefficients(model, i, delta - drift_angle(u, v))
    qa = 0.5 * model.rho * sqrt(speed2) * model.fin_area[i]
    cb, sb = u, v  # times the speed that q lacks: no division
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


@inline
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


@inline
def wrench_of(model, i, command, nu_r):
    """(X, Y, Z, K, M, N) of actuator i, N and N m about O_b. Source: eq. (23)-(26).

    command: deflection (rad) or shaft speed (rev/s) as it is now; nu_r (6,) relative velocity.
    """
    ex, ey, ez = model.direction[i, 0], model.direction[i, 1], model.direction[i, 2]
    x, y, z = model.position[i, 0], model.position[i, 1], model.position[i, 2]
    if model.kind[i] == FIN:
        axial, force, _, _ = fin_force(model, i, command, nu_r)
        torque = 0.0
    else:
        force, torque = thruster_force(model, i, command, nu_r)
        axial = 0.0
    fx, fy, fz = axial + force * ex, force * ey, force * ez
    return (
        fx,
        fy,
        fz,
        y * fz - z * fy + torque * ex,
        z * fx - x * fz + torque * ey,
        x * fy - y * fx + torque * ez,
    )


@jit
def actuator_wrench(model, i, command, nu_r, out):
    """Add the wrench of actuator i to out (6,)."""
    X, Y, Z, K, M, N = wrench_of(model, i, command, nu_r)
    out[0] += X
    out[1] += Y
    out[2] += Z
    out[3] += K
    out[4] += M
    out[5] += N


@jit
def total_wrench(model, u, effectiveness, nu_r, out):
    """out (6,) = sum over actuators, each scaled by its effectiveness (1 = healthy).

    Summed in six numbers, not in memory: the compiler then keeps them, and nu_r, in registers.
    """
    X = Y = Z = K = M = N = 0.0
    for i in range(model.n_u):
        x, y, z, k, m, n = wrench_of(model, i, u[i], nu_r)
        share = effectiveness[i]
        X, Y, Z = X + share * x, Y + share * y, Z + share * z
        K, M, N = K + share * k, M + share * m, N + share * n
    out[0], out[1], out[2], out[3], out[4], out[5] = X, Y, Z, K, M, N


@inline
def lag_rate(model, i, command, u):
    """Rate of actuator state u towards its command: first-order lag within the rate limit."""
    rate = (command - u) / model.time_constant[i]
    limit = model.command_rate[i]
    return min(max(rate, -limit), limit)
