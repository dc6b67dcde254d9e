"""What Gauss-Newton leaves out: the second-order term of the allocator's cost.

Each actuator answers to its own command alone, so G_m is separable and the term -sum_k Q_k r_k G_k''(x) is
diagonal. Fins alone have one, the thrust variable is linear. It matters in slow flow, where fins stall, and
where the demand asks for more drag than the screw can give: there the fins at rest are a saddle of the cost,
every gradient is zero, and only a direction of negative curvature leads out.

Source: Nocedal and Wright, Numerical Optimization, 2nd ed., eq. (10.5) and sec. 3.4.
"""

from math import atan2, cos, pi, sin, sqrt

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.control.allocation.qp_memory import carray, stack_floats, stack_ints
from bumpless.jit import jit
from bumpless.physics.actuators import STALL_WIDTH, add_force, inflow_along
from bumpless.physics.frames import wrap
from bumpless.physics.model_record import FIN

_N = MAX_ACTUATORS
_NN = _N * _N


@jit
def fin_coefficient_curvature(model, i, alpha):
    """(d2C_L/dalpha2, d2C_D/dalpha2) of fin i at angle of attack alpha, rad: of `fin_coefficients`."""
    a = wrap(alpha)
    slope = model.C_La[i]
    if abs(a) > 0.5 * pi:
        a -= pi if a > 0.0 else -pi
        slope *= model.reverse_lift[i]
    dd_l, dd_d = 0.0, 2.0 * model.C_D2[i]
    excess = abs(a) - model.stall_angle[i]
    if excess > 0.0:
        t = min(1.0, excess / STALL_WIDTH)
        s = t * t * (3.0 - 2.0 * t)
        ds = 6.0 * t * (1.0 - t) / STALL_WIDTH * (1.0 if a > 0.0 else -1.0)
        dds = 6.0 * (1.0 - 2.0 * t) / STALL_WIDTH**2 if t < 1.0 else 0.0
        gap_l = sin(2.0 * a) - slope * a
        gap_d = 2.0 * sin(a) ** 2 - model.C_D2[i] * a * a
        dgap_l = 2.0 * cos(2.0 * a) - slope
        dgap_d = 2.0 * sin(2.0 * a) - 2.0 * model.C_D2[i] * a
        dd_l = -4.0 * s * sin(2.0 * a) + 2.0 * ds * dgap_l + dds * gap_l
        dd_d = (1.0 - s) * dd_d + 4.0 * s * cos(2.0 * a) + 2.0 * ds * dgap_d + dds * gap_d
    return dd_l, dd_d


@jit
def residual_curvature(model, x, effectiveness, nu_r, weight, out):
    """Fill out (8,) with -sum_k weight_k d2G_k/dx_i2 for weight (6,) = Q r, in the units of H."""
    column = carray(stack_floats(6), (6,))
    for i in range(model.n_u):
        out[i] = 0.0
        if model.kind[i] != FIN:
            continue
        e, scale = model.direction[i], model.command_max[i]
        u = inflow_along(model, i, nu_r, 1.0, 0.0, 0.0)
        v = inflow_along(model, i, nu_r, e[0], e[1], e[2])
        speed2 = u * u + v * v
        if speed2 < 1e-12:
            continue
        dd_l, dd_d = fin_coefficient_curvature(model, i, x[i] * scale - atan2(v, u))
        g = effectiveness[i] * scale * scale * 0.5 * model.rho * sqrt(speed2) * model.fin_area[i]
        fx, fe = g * (-dd_d * u - dd_l * v), g * (-dd_d * v + dd_l * u)
        if model.fins_coast == 1:
            fx = 0.0
        for k in range(6):
            column[k] = 0.0
        add_force(model, i, fx + fe * e[0], fe * e[1], fe * e[2], column)
        for k in range(6):
            out[i] -= weight[k] * column[k]


@jit
def descent_curvature(H, curvature, free, n, z):
    """Factorise H + diag(curvature) over the variables with free[i] == 1, as L D L'.

    Returns True if it is positive definite. If not, z (8,) is a direction of negative curvature in those
    variables, z' (H + diag) z < 0, and zero in the others.
    """
    L = carray(stack_floats(_NN), (_N, _N))
    used = carray(stack_ints(_N), (_N,))
    m = 0
    for i in range(n):
        z[i] = 0.0
    for i in range(n):
        if free[i] == 0:
            continue
        used[m] = i
        d = H[i, i] + curvature[i]
        for b in range(m):
            v = H[i, used[b]]
            for c in range(b):
                v -= L[m, c] * L[b, c]
            w = v * L[b, b]
            d -= v * w
            L[m, b] = v
        for b in range(m):
            L[m, b] *= L[b, b]
        if not d > 1e-12 * H[i, i]:
            z[i] = 1.0
            for b in range(m - 1, -1, -1):
                v = -L[m, b]
                for c in range(b + 1, m):
                    v -= L[c, b] * z[used[c]]
                z[used[b]] = v
            return False
        L[m, m] = 1.0 / d
        m += 1
    return True
