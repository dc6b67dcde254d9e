"""From another solver's iterate to the start of the exact active-set finish."""

from bumpless.control.allocation.qp_active_set import FREE, LOWER, UPPER
from bumpless.jit import jit


@jit
def adopt(d, lower, upper, z, lb, ub, x, n, state):
    """Take over z, an iterate in the units y = x / d, as guess of active bounds and point inside them.

    lower, upper: the bounds in z's units; lb, ub: in x's. Writes state and x, n entries each.
    """
    for i in range(n):
        if z[i] <= lower[i] and lb[i] > -1e300:
            state[i], x[i] = LOWER, lb[i]
        elif z[i] >= upper[i] and ub[i] < 1e300:
            state[i], x[i] = UPPER, ub[i]
        else:
            state[i], x[i] = FREE, min(max(z[i] * d[i], lb[i]), ub[i])
