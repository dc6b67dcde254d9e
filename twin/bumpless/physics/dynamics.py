"""Rigid body in water: M nu' + C(nu) nu + D(nu_r) nu_r + g(eta) = tau + tau_e.

Source: Gao et al. 2026, eq. (1)-(7); Fossen 2021, ch. 6, 8 and 10.
Differs: rigid-body terms use the velocity over ground, hydrodynamic terms the velocity through
water, M_RB nu' + C_RB(nu) nu + M_A nu_r' + C_A(nu_r) nu_r + D nu_r + g = tau + tau_w. Water that is
accelerated, as under waves, pushes the displaced volume along (tau_w, the Froude-Krylov force), so
that a neutrally buoyant body drifts with it.
"""

from math import cos, sin

from bumpless.jit import inline


@inline
def coriolis_force(M, nu, out):
    """Subtract C(nu) nu from out (6,), for any symmetric 6x6 inertia M. Source: Fossen 2021, eq. (3.46).

    C = [0, -S(M11 v + M12 w); -S(M11 v + M12 w), -S(M21 v + M22 w)], skew by construction.
    """
    a0 = a1 = a2 = b0 = b1 = b2 = 0.0
    for j in range(6):
        a0 += M[0, j] * nu[j]
        a1 += M[1, j] * nu[j]
        a2 += M[2, j] * nu[j]
        b0 += M[3, j] * nu[j]
        b1 += M[4, j] * nu[j]
        b2 += M[5, j] * nu[j]
    u, v, w, p, q, r = nu[0], nu[1], nu[2], nu[3], nu[4], nu[5]
    # C nu = [omega x a ; v x a + omega x b]
    out[0] -= q * a2 - r * a1
    out[1] -= r * a0 - p * a2
    out[2] -= p * a1 - q * a0
    out[3] -= v * a2 - w * a1 + q * b2 - r * b1
    out[4] -= w * a0 - u * a2 + r * b0 - p * b2
    out[5] -= u * a1 - v * a0 + p * b1 - q * b0


@inline
def damping_force(model, nu_r, out):
    """Subtract D(nu_r) nu_r from out (6,): linear, quadratic (cross-flow) and body-lift damping."""
    u = nu_r[0]
    for i in range(6):
        lift_speed = abs(u) if i < 3 else u
        total = 0.0
        for j in range(6):
            d = (
                model.D_linear[i, j]
                + model.D_quadratic[i, j] * abs(nu_r[j])
                + model.D_lift[i, j] * lift_speed
            )
            total += d * nu_r[j]
        out[i] -= total


@inline
def restoring_force(model, phi, theta, out):
    """Subtract g(eta) from out (6,). Source: Fossen 2021, eq. (4.6)."""
    W, B = model.weight, model.buoyancy
    rg, rb = model.r_g, model.r_b
    st, ct, sf, cf = sin(theta), cos(theta), sin(phi), cos(phi)
    out[0] -= (W - B) * st
    out[1] += (W - B) * ct * sf
    out[2] += (W - B) * ct * cf
    out[3] += (rg[1] * W - rb[1] * B) * ct * cf - (rg[2] * W - rb[2] * B) * ct * sf
    out[4] -= (rg[2] * W - rb[2] * B) * st + (rg[0] * W - rb[0] * B) * ct * cf
    out[5] += (rg[0] * W - rb[0] * B) * ct * sf + (rg[1] * W - rb[1] * B) * st


@inline
def displaced_water_force(model, acceleration, out):
    """Add the Froude-Krylov force to out (6,): the pressure gradient of water accelerated by
    `acceleration` (3,), m/s^2 in body axes, acts on the displaced mass at the centre of buoyancy.

    Source: Faltinsen 1990, ch. 3 (a body small against the wave's length).
    """
    displaced = model.M_RB[0, 0] * model.buoyancy / model.weight
    x, y, z = displaced * acceleration[0], displaced * acceleration[1], displaced * acceleration[2]
    r = model.r_b
    out[0] += x
    out[1] += y
    out[2] += z
    out[3] += r[1] * z - r[2] * y
    out[4] += r[2] * x - r[0] * z
    out[5] += r[0] * y - r[1] * x


@inline
def body_acceleration(model, eta, nu, nu_r, nu_c_dot, tau, force, out):
    """out (6,) = nu' from total applied wrench tau; `force` (6,) is scratch space.

    nu_c_dot (6,): rate of the current's velocity as seen in body axes, [-omega x v_c + R^T v_c'; 0].
    Part of its callers, so that sine and cosine of roll and pitch are taken once with theirs.
    Source: Gao et al. 2026, eq. (1)-(5).
    """
    for i in range(6):
        total = tau[i]
        for j in range(6):
            total += model.M_A[i, j] * nu_c_dot[j]
        force[i] = total
    coriolis_force(model.M_RB, nu, force)
    coriolis_force(model.M_A, nu_r, force)
    damping_force(model, nu_r, force)
    restoring_force(model, eta[3], eta[4], force)
    for i in range(6):
        total = 0.0
        for j in range(6):
            total += model.M_inv[i, j] * force[j]
        out[i] = total
