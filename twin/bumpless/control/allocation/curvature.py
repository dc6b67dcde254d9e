"""What Gauss-Newton leaves out: the second-order term of the allocator's cost.

Each actuator answers to its own commands alone, so G_m is separable and the term -sum_k Q_k r_k G_k''(x) is
diagonal, but for a coupling between the commands of one actuator. Fins have one; the thrust of a fixed screw
is linear. It matters in slow flow, where fins stall, and where the demand asks for more drag than the screw
can give: there the fins at rest are a saddle of the cost, every gradient is zero, and only a direction of
negative curvature leads out.

Source: Nocedal and Wright, Numerical Optimization, 2nd ed., eq. (10.5) and sec. 3.4.
"""

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.control.allocation.qp_memory import carray, stack_floats, stack_ints
from bumpless.jit import jit
from bumpless.physics.actuators import curve

_N = MAX_ACTUATORS
_NN = _N * _N


@jit
def residual_curvature(model, x, u_previous, effectiveness, nu_r, weight, out, coupling):
    """Fill out (8,) with -sum_k weight_k d2G_k/dx_i2 for weight (6,) = Q r, in the units of H, and coupling
    (8,) with the same of d2G_k/dx_i dx_i+1."""
    for i in range(model.n_u):
        out[i] = coupling[i] = 0.0
    for i in range(model.n_u):
        curve(model, i, x, u_previous, effectiveness[i], nu_r, weight, out, coupling)


@jit
def descent_curvature(H, curvature, coupling, free, n, z):
    """Factorise H + C over the variables with free[i] == 1, as L D L'.

    C has curvature (8,) on its diagonal and coupling[i] in (i, i + 1) and (i + 1, i). Returns True if the sum
    is positive definite. If not, z (8,) is a direction of negative curvature in those variables,
    z' (H + C) z < 0, and zero in the others.
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
            if used[b] == i - 1:
                v += coupling[i - 1]
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
