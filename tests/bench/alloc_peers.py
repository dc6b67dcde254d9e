"""The allocator's QPs by this code and by its peers, in one run: `python -m tests.bench.alloc_peers`.

A trajectory of allocation problems (seven variables, five wrench components, slowly moving demand, a
share of it out of reach) is solved by each method. Printed per solve: median and 99th percentile of
CPU time in µs, how often slower than the fastest, and the 99th percentile of relative suboptimality.
CPU time of the calling thread, because the wall clock also measures the machine's other work.
Peers are optional: one that is not installed is left out and named.
"""

import argparse
import importlib
import time
from collections.abc import Callable

import numpy as np

from bumpless.control.allocation.qp import make_handle, solve_box_qp
from bumpless.control.allocation.qp_active_set import solve_active_set

N, WRENCH = 7, 5
LAMBDA = 1e-3

Solve = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def problems(count: int, seed: int = 0) -> list[tuple[np.ndarray, ...]]:
    """(H, g, lb, ub, G, r) along a trajectory: bound-normalised x, increments limited as in eq. (47)."""
    rng = np.random.default_rng(seed)
    G = rng.normal(size=(WRENCH, N))
    x, made = np.zeros(N), []
    phase = rng.uniform(0, 6.3, size=WRENCH)
    for k in range(count):
        G = G + 0.01 * rng.normal(size=G.shape)
        demand = 2.2 * np.sin(0.01 * k * (1 + np.arange(WRENCH)) + phase) + 0.05 * rng.normal(size=WRENCH)
        H, g = G.T @ G + LAMBDA * np.eye(N), -G.T @ demand
        lb, ub = np.maximum(-1.0, x - 0.2), np.minimum(1.0, x + 0.2)
        made.append((H, g, lb, ub, G, demand))
        solve_active_set(H, g, lb, ub, x, N)
    return made


def compiled(solver: str) -> Solve:
    """Ours, called from Python: subtract the row "empty call" for what compiled callers pay."""
    handle = make_handle(solver)

    def solve(H, g, lb, ub, x):
        solve_box_qp(handle, H, g, lb, ub, x, N)
        return x

    return solve


def paper_style() -> Solve:
    """As published: NumPy, a finite-difference Jacobian of the cost, OSQP set up anew each time."""
    import osqp
    from scipy import sparse

    def solve(H, g, lb, ub, x):
        def slope(v):
            base, step = 0.5 * v @ H @ v + g @ v, 1e-6
            return np.array([(0.5 * w @ H @ w + g @ w - base) / step for w in v + step * np.eye(N)])

        curvature = np.array([(slope(x + 1e-3 * e) - slope(x)) / 1e-3 for e in np.eye(N)])
        solver = osqp.OSQP()
        solver.setup(
            sparse.csc_matrix(np.triu((curvature + curvature.T) / 2)),
            slope(x),
            sparse.identity(N, format="csc"),
            lb - x,
            ub - x,
            verbose=False,
        )
        return np.clip(x + solver.solve(raise_error=False).x, lb, ub)

    return solve


def osqp_api() -> Solve:
    """OSQP's Python API at its best: one setup, update() and a warm start."""
    import osqp
    from scipy import sparse

    solver = osqp.OSQP()
    solver.setup(
        sparse.csc_matrix(np.triu(np.ones((N, N)) + N * np.eye(N))),
        np.zeros(N),
        sparse.identity(N, format="csc"),
        -np.ones(N),
        np.ones(N),
        verbose=False,
        eps_abs=1e-6,
        eps_rel=1e-6,
    )
    columns, rows = np.tril_indices(N)

    def solve(H, g, lb, ub, x):
        solver.update(Px=H[rows, columns], q=g, l=lb, u=ub)
        solver.warm_start(x=x)
        return np.clip(solver.solve(raise_error=False).x, lb, ub)

    return solve


def slsqp() -> Solve:
    """SciPy's SLSQP with the exact gradient."""
    from scipy.optimize import minimize

    def solve(H, g, lb, ub, x):
        found = minimize(
            lambda v: 0.5 * v @ H @ v + g @ v,
            np.clip(x, lb, ub),
            jac=lambda v: H @ v + g,
            bounds=np.stack([lb, ub], axis=1),
            method="SLSQP",
            options={"ftol": 1e-10},
        )
        return np.clip(found.x, lb, ub)

    return solve


def ipopt() -> Solve:
    """CasADi with IPOPT, built once, parameters for H and g."""
    casadi = importlib.import_module("casadi")
    v, H_, g_ = casadi.SX.sym("v", N), casadi.SX.sym("H", N, N), casadi.SX.sym("g", N)
    cost = 0.5 * v.T @ H_ @ v + g_.T @ v
    problem = {"x": v, "p": casadi.vertcat(casadi.vec(H_), g_), "f": cost}
    quiet = {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes", "ipopt.tol": 1e-9}
    solver = casadi.nlpsol("allocation", "ipopt", problem, quiet)

    def solve(H, g, lb, ub, x):
        found = solver(x0=x, p=np.concatenate([H.ravel(), g]), lbx=lb, ubx=ub)
        return np.clip(np.array(found["x"]).ravel(), lb, ub)

    return solve


def daqp_api() -> Solve:
    """daqp's Python API."""
    daqp = importlib.import_module("daqp")
    none = np.zeros((0, N))
    return lambda H, g, lb, ub, x: np.clip(daqp.solve(H, g, none, ub, lb)[0], lb, ub)


def qpsolvers_daqp() -> Solve:
    """qpsolvers with its fastest dense solver that is installed."""
    qpsolvers = importlib.import_module("qpsolvers")
    order = [s for s in ("daqp", "quadprog", "proxqp", "osqp") if s in qpsolvers.available_solvers]
    name = order[0]
    return lambda H, g, lb, ub, x: np.clip(qpsolvers.solve_qp(H, g, lb=lb, ub=ub, solver=name), lb, ub)


METHODS: dict[str, Callable[[], Solve]] = {
    "empty call": lambda: lambda H, g, lb, ub, x: x,
    "active_set": lambda: compiled("active_set"),
    "osqp (native, exact finish)": lambda: compiled("osqp"),
    "daqp (native, exact finish)": lambda: compiled("daqp"),
    "OSQP update()": osqp_api,
    "daqp": daqp_api,
    "qpsolvers": qpsolvers_daqp,
    "SciPy SLSQP": slsqp,
    "CasADi IPOPT": ipopt,
    "paper style": paper_style,
}


def measure(solve: Solve, trajectory: list) -> tuple[np.ndarray, np.ndarray]:
    """(CPU seconds, relative suboptimality) of each problem; the previous answer is the start."""
    seconds, gap = np.zeros(len(trajectory)), np.zeros(len(trajectory))
    x = np.zeros(N)
    for k, (H, g, lb, ub, G, demand) in enumerate(trajectory):
        start = x.copy()
        begin = time.thread_time_ns()
        x = solve(H, g, lb, ub, start)
        seconds[k] = (time.thread_time_ns() - begin) * 1e-9
        best = np.clip(x, lb, ub)
        solve_active_set(H, g, lb, ub, best, N)
        least = np.sum((demand - G @ best) ** 2) + LAMBDA * best @ best
        gap[k] = (np.sum((demand - G @ x) ** 2) + LAMBDA * x @ x - least) / (least + 1e-9)
    return seconds, gap


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cycles", type=int, default=2000)
    trajectory = problems(parser.parse_args().cycles)
    rows, missing = [], []
    for name, make in METHODS.items():
        try:
            solve = make()
            measure(solve, trajectory[:20])
        except ImportError as error:
            missing.append(f"{name}: {error}")
            continue
        seconds, gap = measure(solve, trajectory)
        rows.append((name, *np.percentile(seconds * 1e6, [50, 99]), np.percentile(gap, 99)))
    fastest = rows[1][1]
    print(f"{'method':30s} {'median µs':>10s} {'p99 µs':>10s} {'x active_set':>12s} {'subopt p99':>11s}")
    for name, median, tail, gap in rows:
        print(f"{name:30s} {median:10.1f} {tail:10.1f} {median / fastest:12.1f} {gap:11.1e}")
    for text in missing:
        print("left out,", text)


if __name__ == "__main__":
    main()
