"""MD-CA: one constrained SQP for all modes.

u* = argmin ||tau_d - G_m(u)||_Q^2 + lambda ||u||_R^2 over the cycle's bounds, eq. (47)-(52) of
Gao et al. 2026, in the decision variables of `wrench_map`. Each step solves a box QP; a step is
accepted only if the true cost falls (backtracking on eta_j), so that the answer is never worse than
the projected start.
Beyond the paper: a price mu ||u - u_prev||^2 on increments of the commands over their bounds; and the fins'
second-order term (`curvature`), in the QP where it leaves that convex, and as a way out of a saddle.
"""

from math import isfinite

from bumpless.config.capacity import MAX_ACTUATORS as _N
from bumpless.contract.enums import BUDGET_SPENT, FALLBACK, REFUSED, SOLVED
from bumpless.control.allocation.curvature import descent_curvature, residual_curvature
from bumpless.control.allocation.kkt import residual_at_zero
from bumpless.control.allocation.qp import solve_box_qp
from bumpless.control.allocation.qp_active_set import solve_active_set
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.jit import inline, jit
from bumpless.jit.memory import floats
from bumpless.physics.actuators import command_slope, to_command, to_x

_BACKTRACKS = 6
_NEAR = 1e-3  # KKT residual from which a saddle is looked for: Newton's steps towards one are wasted
_ROOM = 1e-6  # share of its range that a command must have on both sides to count as free
_DOUBT = 1e-9  # of a stiffness: what is added to it is known to be there whatever rounding does
_ROUNDING = 1e-12  # share of the cost that no step can gain any more
_HOLD = 1.0  # s for which the last command is held when demands are refused


@jit
def increment_prices(model, mu, x_previous, n, price):
    """price (8,) = mu (du/dx)^2 at the last command: what an increment of x costs, so that mu prices those of
    commands over their bounds. A screw near zero, where its speed changes fastest, pays most."""
    for i in range(n):
        slope = command_slope(model, i, x_previous[i]) if mu > 0.0 else 1.0
        price[i] = mu * slope * slope


@jit
def increment_cost(price, x, x_previous, n):
    """Sum of price (x - x_prev)^2."""
    cost = 0.0
    for i in range(n):
        cost += price[i] * (x[i] - x_previous[i]) ** 2
    return cost


@jit
def price_increments(price, x, x_previous, n, H, g):
    """Add the increments' prices to the (halved) normal equations."""
    for i in range(n):
        H[i, i] += price[i]
        g[i] += price[i] * (x[i] - x_previous[i])


@jit
def allocation_cost(Q, R, lam, tau_d, tau, x, n):
    """||tau_d - tau||_Q^2 + lambda ||x||_R^2 with diagonal Q (6,) and R (8,).

    Source: Gao et al. 2026, eq. (47).
    """
    cost = 0.0
    for k in range(6):
        r = tau_d[k] - tau[k]
        cost += Q[k] * r * r
    for i in range(n):
        cost += lam * R[i] * x[i] * x[i]
    return cost


@inline
def slope_and_stiffness(Q, R, lam, tau_d, tau, jacobian, x, i):
    """(g_i, H_ii) of `normal_equations`."""
    s, h = lam * R[i] * x[i], 0.0
    for k in range(6):
        weighted = jacobian[k, i] * Q[k]
        s -= weighted * (tau_d[k] - tau[k])
        h += weighted * jacobian[k, i]
    return s, h + (lam * R[i] + 1e-9)


@jit
def normal_equations(Q, R, lam, tau_d, tau, jacobian, x, n, H, g):
    """Gauss-Newton Hessian H = G'QG + lambda R and gradient g = -G'Q r + lambda R x (halved cost).

    Source: Gao et al. 2026, eq. (51).
    """
    row = floats(_N)
    for i in range(n):
        for j in range(_N):
            row[j] = 0.0
        for k in range(6):
            weighted = jacobian[k, i] * Q[k]
            for j in range(_N):  # all of them, for the compiler takes several at a time
                row[j] += weighted * jacobian[k, j]
        for j in range(i):
            H[i, j] = row[j]
            H[j, i] = row[j]
        g[i], H[i, i] = slope_and_stiffness(Q, R, lam, tau_d, tau, jacobian, x, i)


@jit
def find_curvature(model, problem, w, x, n):
    """Fill w.curvature and w.coupling with the second-order term at x (8,)."""
    p = problem
    for k in range(6):
        w.weight[k] = p.Q[k] * (p.tau_d[k] - w.tau[k])
    residual_curvature(model, x, p.u_previous, p.effectiveness, p.nu_flow, w.weight, w.curvature, w.coupling)


@jit
def look_around(problem, w, x, n):
    """Fill w.g, and w.diagonal with H_ii, all of the second-order term included; True where that sum is
    positive definite beyond doubt: prices and regularisation then outweigh what of the term is negative.
    """
    p, sure = problem, True
    for i in range(n):
        w.g[i], stiffness = slope_and_stiffness(p.Q, p.R, p.lam, p.tau_d, w.tau, w.jacobian, x, i)
        stiffness += w.price[i]
        w.g[i] += w.price[i] * (x[i] - w.x_previous[i])
        w.diagonal[i] = stiffness + w.curvature[i]
        added = 0.5 * (p.lam * p.R[i] + w.price[i])
        sure = sure and added > _DOUBT * stiffness and added + w.curvature[i] >= 0.0 and w.coupling[i] == 0.0
    return sure


@jit
def add_curvature(w, n):
    """Add the second-order term to w.H: all of it where H stays positive definite, else what is positive."""
    least = 0.0
    for i in range(n):
        w.free[i] = 1
        least = min(least, w.curvature[i], -abs(w.coupling[i]))
    convex = least == 0.0 or descent_curvature(w.H, w.curvature, w.coupling, w.free, n, w.trial)
    for i in range(n):
        added = w.curvature[i] if convex else max(w.curvature[i], 0.0)
        w.H[i, i] += added
        w.curvature[i] -= added
        if convex and w.coupling[i] != 0.0:
            w.H[i, i + 1] += w.coupling[i]
            w.H[i + 1, i] += w.coupling[i]
            w.coupling[i] = 0.0


@jit
def assemble(problem, w, x, n):
    """Fill w.H, w.g and w.diagonal: normal equations, prices, second-order term."""
    p = problem
    normal_equations(p.Q, p.R, p.lam, p.tau_d, w.tau, w.jacobian, x, n, w.H, w.g)
    price_increments(w.price, x, w.x_previous, n, w.H, w.g)
    add_curvature(w, n)
    for i in range(n):
        w.diagonal[i] = w.H[i, i]


@jit
def cost_at(model, problem, w, x, n):
    """Cost of the PROBLEM at x (8,); w.tau and w.jacobian are filled."""
    p = problem
    wrench_map(model, x, p.u_previous, p.effectiveness, p.nu_flow, w.tau, w.jacobian)
    cost = allocation_cost(p.Q, p.R, p.lam, p.tau_d, w.tau, x, n)
    return cost + increment_cost(w.price, x, w.x_previous, n)


@jit
def leave_saddle(model, problem, w, x, cost, n):
    """Move x down a direction of negative curvature in the free commands, if there is one; returns the cost.

    Tried from the first bound that the direction meets inwards, on both sides. Where it does not find less,
    x and cost stay as they are.
    """
    least = 0.0
    for i in range(n):
        room = min(x[i] - w.lower[i], w.upper[i] - x[i])
        w.free[i] = 1 if room > _ROOM else 0
        least = min(least, w.curvature[i], -abs(w.coupling[i]))
    if least == 0.0 or descent_curvature(w.H, w.curvature, w.coupling, w.free, n, w.step):
        return cost
    reach = 1e9
    for i in range(n):
        if w.step[i] != 0.0:
            reach = min(reach, min(x[i] - w.lower[i], w.upper[i] - x[i]) / abs(w.step[i]))
    for _ in range(_BACKTRACKS):
        for _ in range(2):
            reach = -reach
            for i in range(n):
                w.trial[i] = x[i] + reach * w.step[i]
            trial_cost = cost_at(model, problem, w, w.trial, n)
            if trial_cost < cost:
                for i in range(n):
                    x[i] = w.trial[i]
                return trial_cost
        reach *= 0.5
    return cost


@jit
def refuse(model, problem, solution):
    """Hold the last command within this cycle's bounds and say so; after a second come to rest."""
    solution.refused = problem.refused + 1
    keep = 1.0 if solution.refused * problem.dt <= _HOLD else 0.0
    for i in range(model.n_u):
        u = keep * problem.u_previous[i]
        solution.u[i] = min(max(u, problem.u_lower[i]), problem.u_upper[i])
    solution.status, solution.iterations = REFUSED, 0
    solution.kkt = solution.cost = 0.0


@jit
def allocate_mdca(handle, settings, model, problem, solution, w):
    """Solve one cycle's PROBLEM: the SOLUTION's commands, status, iterations, kkt and cost.

    settings: ALLOCATION_SETTINGS; w: ALLOCATION_WORK. A demand that is not finite is refused.
    Source: Gao et al. 2026, eq. (45)-(52), (57): the start is the last command within the new bounds.
    """
    n, p = model.n_u, problem
    for k in range(6):
        if not isfinite(p.tau_d[k]) or not isfinite(p.nu_flow[k]):
            refuse(model, p, solution)
            return
    solution.refused = 0
    x, lower, upper, step, trial = w.x, w.lower, w.upper, w.step, w.trial
    for i in range(n):
        lower[i], upper[i] = to_x(model, i, p.u_lower[i]), to_x(model, i, p.u_upper[i])
        w.x_previous[i] = to_x(model, i, p.u_previous[i])
        start = w.x_previous[i] if p.warm == 1 else 0.0
        x[i] = min(max(start, lower[i]), upper[i])
    increment_prices(model, p.increment_price, w.x_previous, n, w.price)
    cost = cost_at(model, p, w, x, n)
    fallback = False
    iterations, kkt = 0, 0.0
    escapes = 0
    while True:
        find_curvature(model, p, w, x, n)
        convex = look_around(p, w, x, n)
        if not convex:
            assemble(p, w, x, n)
        for i in range(n):
            w.lb[i], w.ub[i] = lower[i] - x[i], upper[i] - x[i]
        kkt = residual_at_zero(w.diagonal, w.g, w.lb, w.ub, n)
        if kkt <= _NEAR and escapes < settings.escapes:
            escapes += 1
            if not convex:
                escaped = leave_saddle(model, p, w, x, cost, n)
                if escaped < cost:
                    cost = escaped
                    continue
        status = SOLVED if kkt <= settings.kkt_tolerance else BUDGET_SPENT
        if status == SOLVED or iterations >= settings.sqp_iterations:
            break
        iterations += 1
        if convex:
            assemble(p, w, x, n)
        for i in range(n):
            step[i] = 0.0
        if iterations == 1:
            fallback = solve_box_qp(handle, w.H, w.g, w.lb, w.ub, step, n) != SOLVED
        else:  # the bounds that hold are known but for a few: the exact finish alone finds those
            answer, _ = solve_active_set(w.H, w.g, w.lb, w.ub, step, n)
            fallback = fallback or answer != SOLVED
        eta, accepted = 1.0, False
        for _ in range(_BACKTRACKS):
            for i in range(n):
                trial[i] = min(max(x[i] + eta * step[i], lower[i]), upper[i])
            trial_cost = cost_at(model, p, w, trial, n)
            if trial_cost < cost:
                accepted = True
                break
            eta *= 0.5
        if not accepted:
            slope = 0.0
            for i in range(n):
                slope -= w.g[i] * step[i]
            if slope <= _ROUNDING * cost:
                status = SOLVED
            break
        cost = trial_cost
        for i in range(n):
            x[i] = trial[i]
    for i in range(n):
        solution.u[i] = min(max(to_command(model, i, x[i]), p.u_lower[i]), p.u_upper[i])
    solution.iterations, solution.kkt, solution.cost = iterations, kkt, cost
    solution.status = FALLBACK if fallback else status
