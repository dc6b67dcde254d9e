"""How far a point is from the optimum of a box QP, in one number per cycle."""

from bumpless.jit import inline, jit


@jit
def kkt_residual(H, g, lb, ub, x, n):
    """Largest |x_i - clip(x_i - grad_i / H_ii, lb_i, ub_i)|: zero at the optimum and only there.

    H (>=n, >=n), g, lb, ub, x (>=n). Unit: that of x, so in bound-normalised commands it reads as
    the share of its range by which a single command is still off; it does not depend on the units
    of the cost. Source: the natural residual of the box KKT system, Facchinei and Pang (2003),
    section 1.5, with Jacobi scaling.
    """
    largest = 0.0
    for i in range(n):
        largest = max(largest, H[i, i])
    worst = 0.0
    for i in range(n):
        s = g[i]
        for j in range(n):
            s += H[i, j] * x[j]
        r = _off(x[i], s, H[i, i], largest, lb[i], ub[i])
        if not r <= worst:
            worst = r
    return worst


@jit
def residual_at_zero(diagonal, g, lb, ub, n):
    """The same at x = 0, where the diagonal of H (>=n,) will do."""
    largest, worst = 0.0, 0.0
    for i in range(n):
        largest = max(largest, diagonal[i])
    for i in range(n):
        r = _off(0.0, g[i], diagonal[i], largest, lb[i], ub[i])
        if not r <= worst:
            worst = r
    return worst


@inline
def _off(x, slope, stiffness, largest, low, high):
    """|x - clip(x - slope / stiffness, low, high)| of one variable."""
    # a variable without curvature moves as the stiffest one would
    d = stiffness if stiffness > 1e-14 * largest else largest
    v = x - slope / d if d > 0.0 else x - slope
    return abs(x - min(max(v, low), high))
