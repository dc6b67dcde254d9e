"""Random box QPs of every kind that allocation meets, and an optimum found in another way."""

import itertools

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.jit import jit

KINDS = ("plain", "saturated", "narrow", "rank deficient", "degenerate", "dead actuator", "scaled")


def random_problem(rng: np.random.Generator, kind: str):
    """(H, g, lb, ub, x, n), arrays of MAX_ACTUATORS; what lies beyond n is NaN on purpose."""
    n = int(rng.integers(1, MAX_ACTUATORS + 1))
    rows = int(rng.integers(1, 4)) if kind == "rank deficient" else 5
    G = rng.normal(size=(rows, n))
    lam = 10.0 ** rng.uniform(-6, -1)
    if kind == "scaled":
        G *= 10.0 ** rng.uniform(-4, 4, size=(1, n))
    if kind == "dead actuator":
        G[:, rng.integers(n)] = 0.0
    demand = rng.normal(size=rows) * (30.0 if kind == "saturated" else 2.0)
    if kind == "scaled":
        lam *= np.diag(G.T @ G).max()
    block = G.T @ G + lam * np.eye(n)
    slope = -G.T @ demand
    width = 10.0 ** rng.uniform(-3, 1, size=n) if kind == "narrow" else rng.uniform(0.2, 2.0, size=n)
    centre = rng.normal(size=n) * 0.3
    if kind == "degenerate":
        # the unbounded optimum lies exactly on some bounds; other bounds leave no room at all
        inside = np.linalg.solve(block, -slope)
        lower, upper = inside - width, inside + width
        pinned = rng.random(n)
        lower = np.where(pinned < 0.4, inside, lower)
        upper = np.where(pinned > 0.8, lower, upper)
    else:
        lower, upper = centre - width, centre + width
    H = np.full((MAX_ACTUATORS, MAX_ACTUATORS), np.nan)
    g, lb, ub, x = (np.full(MAX_ACTUATORS, np.nan) for _ in range(4))
    H[:n, :n], g[:n], lb[:n], ub[:n] = block, slope, lower, upper
    x[:n] = rng.normal(size=n) * 3.0
    return H, g, lb, ub, x, n


@jit
def cost(H, g, x, n):
    """1/2 x'Hx + g'x."""
    total = 0.0
    for i in range(n):
        total += g[i] * x[i]
        for j in range(n):
            total += 0.5 * x[i] * H[i, j] * x[j]
    return total


@jit
def descended(H, g, lb, ub, x, n, sweeps):
    """Reference: projected coordinate descent, run until it stands still. Linear, and hard to get wrong."""
    for _ in range(sweeps):
        moved = 0.0
        for i in range(n):
            s = g[i]
            for j in range(n):
                s += H[i, j] * x[j]
            v = min(max(x[i] - s / H[i, i], lb[i]), ub[i])
            moved = max(moved, abs(v - x[i]))
            x[i] = v
        if moved == 0.0:
            break


def enumerated(H, g, lb, ub, n):
    """Reference: the best of all combinations of active bounds, for small n."""
    best, best_cost = np.clip(np.zeros(n), lb[:n], ub[:n]), np.inf
    for sides in itertools.product((-1, 0, 1), repeat=n):
        side = np.array(sides)
        x = np.where(side < 0, lb[:n], np.where(side > 0, ub[:n], 0.0))
        free = np.flatnonzero(side == 0)
        if free.size:
            rest = g[:n][free] + H[:n, :n][np.ix_(free, np.flatnonzero(side))] @ x[side != 0]
            x[free] = np.linalg.solve(H[:n, :n][np.ix_(free, free)], -rest)
        if (x >= lb[:n] - 1e-12).all() and (x <= ub[:n] + 1e-12).all():
            value = 0.5 * x @ H[:n, :n] @ x + g[:n] @ x
            if value < best_cost:
                best, best_cost = x, value
    return best
