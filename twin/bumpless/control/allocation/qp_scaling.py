"""A box QP in the units that suit a first-order method: unit diagonal, padded to full size."""

import math

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.jit import jit

UPPER_TRIANGLE = MAX_ACTUATORS * (MAX_ACTUATORS + 1) // 2
INFINITY = 1e30  # OSQP's own

_N = MAX_ACTUATORS


@jit
def scale(H, g, lb, ub, x, n, d, P, q, lower, upper, start):
    """Fill d, P, q, lower, upper, start with the problem in y = x / d, d_i = 1 / sqrt(H_ii).

    P: upper triangle of the scaled H, column by column (UPPER_TRIANGLE). The rest: MAX_ACTUATORS
    entries each; the variables beyond n are decoupled, with their optimum at zero.
    """
    for i in range(_N):
        if i < n:
            d[i] = 1.0 / math.sqrt(H[i, i]) if H[i, i] > 0.0 else 1.0
            q[i] = d[i] * g[i]
            lower[i] = max(lb[i] / d[i], -INFINITY)
            upper[i] = min(ub[i] / d[i], INFINITY)
            start[i] = x[i] / d[i]
        else:
            d[i] = 1.0
            q[i] = 0.0
            lower[i] = -1.0
            upper[i] = 1.0
            start[i] = 0.0
    k = 0
    for j in range(_N):
        for i in range(j + 1):
            if j < n:
                P[k] = d[i] * H[i, j] * d[j]
            else:
                P[k] = 1.0 if i == j else 0.0
            k += 1
