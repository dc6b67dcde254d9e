"""How far a point is from the optimum of a box QP, in one number per cycle."""

from bumpless.jit import jit


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
        # a variable without curvature moves as the stiffest one would
        d = H[i, i] if H[i, i] > 1e-14 * largest else largest
        v = x[i] - s / d if d > 0.0 else x[i] - s
        r = abs(x[i] - min(max(v, lb[i]), ub[i]))
        if not r <= worst:
            worst = r
    return worst
