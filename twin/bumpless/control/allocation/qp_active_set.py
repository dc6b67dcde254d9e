"""Exact solution of a small strictly convex box QP, compiled, without heap allocation.

    minimise 1/2 x'Hx + g'x  over  lb <= x <= ub,   n <= MAX_ACTUATORS

Two phases share one factorisation:

1. primal-dual active set (a semismooth Newton method): guess which bounds hold, solve the rest
   exactly, correct every wrong guess at once. Two or three rounds from a warm start, but no
   guarantee of termination for a general H, so its rounds are counted;
2. primal active set: one bound added or released at a time; the cost falls, hence finite. Should
   rounding make it cycle, projected coordinate descent has the last word.

Source: Hintermueller, Ito and Kunisch, SIAM J. Optim. 13 (2003) 865 (phase 1);
Nocedal and Wright, Numerical Optimization, 2nd ed., algorithm 16.3 (phase 2).
"""

import math

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.contract.enums import BUDGET_SPENT, INFEASIBLE, REFUSED, SOLVED
from bumpless.control.allocation.qp_memory import carray, stack_floats, stack_ints
from bumpless.jit import jit

LOWER, FREE, UPPER, FIXED = -1, 0, 1, 2
NEWTON_ROUNDS = 6  # phase 1 settles in 2-3 rounds, or cycles
PRIMAL_ROUNDS = 60  # phase 2 needs about n rounds
DESCENT_SWEEPS = 200
PIVOT_LOST = 1e-14  # of the diagonal entry that the pivot started from: the rest is rounding
DUAL_TOLERANCE = 1e-14  # of a multiplier, relative to the terms that it is summed from
OPTIMALITY = 1e-9  # the same, for the answer to be called solved

_N = MAX_ACTUATORS
_NN = _N * _N


@jit
def minimise_free(H, g, x, state, n, L, free, z):
    """Write into z the minimiser over the FREE variables, the others held at x; return their number.

    H = L D L' on the free block: L unit lower triangular, 1/D on its diagonal. A pivot lost in
    rounding (a zero column, a dependent one) is lifted, so that its variable runs into a bound.
    """
    m = 0
    largest = 0.0
    for i in range(n):
        z[i] = x[i]
        if state[i] == FREE:
            free[m] = i
            m += 1
            largest = max(largest, H[i, i])
    for a in range(m):
        i = free[a]
        r = -g[i]
        for j in range(n):
            if state[j] != FREE:
                r -= H[i, j] * x[j]
        for b in range(a):
            v = H[i, free[b]]
            for c in range(b):
                v -= L[a, c] * L[b, c]
            L[a, b] = v
        d = H[i, i]
        for b in range(a):
            v = L[a, b]
            w = v * L[b, b]
            d -= v * w
            L[a, b] = w
            r -= w * z[free[b]]
        if not d > PIVOT_LOST * H[i, i]:
            d = PIVOT_LOST * largest + 1e-150
        L[a, a] = 1.0 / d
        z[i] = r
    for a in range(m - 1, -1, -1):
        v = z[free[a]] * L[a, a]
        for b in range(a + 1, m):
            v -= L[b, a] * z[free[b]]
        z[free[a]] = v
    return m


@jit
def slope(H, g, x, i, n):
    """(gradient of the cost along x_i, what of it rounding may have made)."""
    s = g[i]
    size = abs(g[i])
    for j in range(n):
        t = H[i, j] * x[j]
        s += t
        size += abs(t)
    return s, DUAL_TOLERANCE * size


@jit
def is_optimal(H, g, lb, ub, x, n):
    """True where no admissible change of one variable lowers the cost beyond OPTIMALITY."""
    for i in range(n):
        s, noise = slope(H, g, x, i, n)
        room = x[i] - lb[i] if s > 0.0 else ub[i] - x[i]
        gain = min(abs(s), room * H[i, i]) if H[i, i] > 0.0 or room == 0.0 else abs(s)
        if not gain <= OPTIMALITY / DUAL_TOLERANCE * noise:
            return False
    return True


@jit
def _newton(most, H, g, lb, ub, x, state, n, L, free, z):
    """Phase 1, of `most` rounds. Returns those used, negative when it did not settle: x is untouched then."""
    for k in range(1, most + 1):
        for i in range(n):
            if state[i] == LOWER or state[i] == FIXED:
                z[i] = lb[i]
            elif state[i] == UPPER:
                z[i] = ub[i]
            else:
                z[i] = x[i]
        minimise_free(H, g, z, state, n, L, free, z)
        settled = True
        for i in range(n):
            if state[i] == FREE:
                if not math.isfinite(z[i]):
                    return -k
                if z[i] < lb[i]:
                    state[i] = LOWER
                    settled = False
                elif z[i] > ub[i]:
                    state[i] = UPPER
                    settled = False
            elif state[i] != FIXED:
                s, noise = slope(H, g, z, i, n)
                if s * state[i] > noise:
                    state[i] = FREE
                    settled = False
        if settled:
            for i in range(n):
                x[i] = z[i]
            return k
    return -most


@jit
def _primal(H, g, lb, ub, x, state, n, L, free, z):
    """Phase 2, from a feasible x. Returns the rounds used, negative at the cap."""
    for i in range(n):
        if state[i] != FIXED:
            state[i] = LOWER if x[i] <= lb[i] else (UPPER if x[i] >= ub[i] else FREE)
    for k in range(1, PRIMAL_ROUNDS + 1):
        m = minimise_free(H, g, x, state, n, L, free, z)
        share, block = 1.0, -1
        for a in range(m):
            i = free[a]
            p = z[i] - x[i]
            if not math.isfinite(p):
                return -k
            if z[i] < lb[i] and (lb[i] - x[i]) > share * p:
                share, block = (lb[i] - x[i]) / p, i
            elif z[i] > ub[i] and (ub[i] - x[i]) < share * p:
                share, block = (ub[i] - x[i]) / p, i
        for a in range(m):
            i = free[a]
            # a full step lands on z to the last bit: the answer depends on the final set alone
            x[i] = min(max(x[i] + share * (z[i] - x[i]), lb[i]), ub[i]) if block >= 0 else z[i]
        if block >= 0:
            state[block] = LOWER if z[block] < lb[block] else UPPER
            x[block] = lb[block] if z[block] < lb[block] else ub[block]
            continue
        worst, leaving = 0.0, -1
        for i in range(n):
            if state[i] == LOWER or state[i] == UPPER:
                s, noise = slope(H, g, x, i, n)
                s *= state[i]
                if s > noise and s * s > worst * (H[i, i] + 1e-150):
                    worst, leaving = s * s / (H[i, i] + 1e-150), i
        if leaving < 0:
            return k
        state[leaving] = FREE
    return -PRIMAL_ROUNDS


@jit
def _descend(H, g, lb, ub, x, n):
    """Projected coordinate descent: slow, but it never raises the cost."""
    for _ in range(DESCENT_SWEEPS):
        moved = 0.0
        for i in range(n):
            s, noise = slope(H, g, x, i, n)
            if abs(s) > noise:
                v = min(max(x[i] - s / (H[i, i] + 1e-150), lb[i]), ub[i])
                if math.isfinite(v):
                    moved = max(moved, abs(v - x[i]) - 1e-14 * abs(v))
                    x[i] = v
        if moved <= 0.0:
            break


@jit
def admit(H, g, lb, ub, x, n):
    """Check the data and move x inside its bounds. SOLVED means: fit to be solved.

    Contradicting bounds: x goes to the nearest point of the gap between them. A start that is not
    a number counts as zero, then clipped.
    """
    status = SOLVED
    for i in range(n):
        if math.isnan(lb[i]) or math.isnan(ub[i]) or not math.isfinite(g[i]):
            status = REFUSED
        for j in range(n):
            if not math.isfinite(H[i, j]):
                status = REFUSED
    for i in range(n):
        v = x[i] if math.isfinite(x[i]) else 0.0
        if lb[i] > ub[i]:
            v = min(max(v, ub[i]), lb[i])
            if status == SOLVED:
                status = INFEASIBLE
        else:
            if v < lb[i]:
                v = lb[i]
            if v > ub[i]:
                v = ub[i]
        if not math.isfinite(v):
            v = 0.0
            status = REFUSED
        x[i] = v
    return status


@jit
def guess(H, g, lb, ub, x, state, n):
    """Fill state (int64, n): the bounds that x is at and that its gradient presses it against."""
    for i in range(n):
        state[i] = FREE
        if x[i] <= lb[i] or x[i] >= ub[i]:
            s, _ = slope(H, g, x, i, n)
            if x[i] <= lb[i] and s >= 0.0:
                state[i] = LOWER
            elif x[i] >= ub[i] and s <= 0.0:
                state[i] = UPPER


@jit
def confirm(H, g, lb, ub, x, n):
    """Move a feasible start x to the optimum, where that has the bounds at which x is held; True if so.

    One round of phase 1, nothing searched; elsewhere x stays the start.
    """
    L = carray(stack_floats(_NN), (_N, _N))
    z, begun = carray(stack_floats(_N), (_N,)), carray(stack_floats(_N), (_N,))
    free, state = carray(stack_ints(_N), (_N,)), carray(stack_ints(_N), (_N,))
    guess(H, g, lb, ub, x, state, n)
    for i in range(n):
        begun[i] = x[i]
        if lb[i] == ub[i]:
            state[i] = FIXED
    if _newton(1, H, g, lb, ub, x, state, n, L, free, z) > 0 and is_optimal(H, g, lb, ub, x, n):
        return True
    for i in range(n):
        x[i] = begun[i]
    return False


@jit
def finish(H, g, lb, ub, x, state, n):
    """Solve exactly from a feasible x and a guess of which bounds hold.

    `state` (int64, n): LOWER, FREE or UPPER; overwritten. Returns (status, rounds).
    """
    L = carray(stack_floats(_NN), (_N, _N))
    z = carray(stack_floats(_N), (_N,))
    free = carray(stack_ints(_N), (_N,))
    for i in range(n):
        if lb[i] == ub[i]:
            state[i] = FIXED
        elif (state[i] == LOWER and lb[i] == -math.inf) or (state[i] == UPPER and ub[i] == math.inf):
            state[i] = FREE
    rounds = _newton(NEWTON_ROUNDS, H, g, lb, ub, x, state, n, L, free, z)
    if rounds > 0 and is_optimal(H, g, lb, ub, x, n):
        return SOLVED, rounds
    rounds = abs(rounds)
    more = _primal(H, g, lb, ub, x, state, n, L, free, z)
    rounds += abs(more)
    if more > 0 and is_optimal(H, g, lb, ub, x, n):
        return SOLVED, rounds
    _descend(H, g, lb, ub, x, n)
    return (SOLVED if is_optimal(H, g, lb, ub, x, n) else BUDGET_SPENT), rounds


@jit
def solve_active_set(H, g, lb, ub, x, n):
    """Minimise 1/2 x'Hx + g'x over lb <= x <= ub; x is the start and the answer.

    H (>=n, >=n) symmetric positive definite, g, lb, ub, x (>=n): float64, used up to n. Bounds may
    be equal or infinite. Returns (SolveStatus, rounds). x ends inside its bounds always.
    """
    status = admit(H, g, lb, ub, x, n)
    if status != SOLVED:
        return status, 0
    state = carray(stack_ints(_N), (_N,))
    guess(H, g, lb, ub, x, state, n)
    return finish(H, g, lb, ub, x, state, n)
