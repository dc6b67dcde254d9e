"""Flow at an actuator, and the wrench of a force that is applied there: what every kind builds on."""

from bumpless.jit import inline


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
def force_against(model, i, fx, fy, fz, weight):
    """-weight . [f ; r x f] of a force applied at actuator i, for weight (6,)."""
    x, y, z = model.position[i, 0], model.position[i, 1], model.position[i, 2]
    s = 0.0
    s -= weight[0] * fx
    s -= weight[1] * fy
    s -= weight[2] * fz
    s -= weight[3] * (y * fz - z * fy)
    s -= weight[4] * (z * fx - x * fz)
    s -= weight[5] * (x * fy - y * fx)
    return s
