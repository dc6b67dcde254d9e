"""Other ways to solve a cycle's allocation problem: the same cost, bounds and start, their own iterations.

Each maker returns `solve(problem, x, lower, upper) -> x`. SQP peers use the same budget, tolerance and
backtracking as ours and differ in how the QP is solved. A peer that is not installed raises ImportError.
"""

import importlib
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np

from bumpless.control.allocation.kkt import kkt_residual
from bumpless.control.allocation.mdca import normal_equations
from tests.bench.generic_map import numpy_operations, parts, wrench
from tests.bench.stream import cost_at

Solve = Callable[[Any, np.ndarray, np.ndarray, np.ndarray], np.ndarray]
BUDGET, TOLERANCE = 8, 1e-6
PAPER_BUDGET = 3


def paper_style(model: np.void) -> Solve:
    """As published: NumPy, a finite-difference Jacobian, OSQP set up anew in each of three iterations."""
    import osqp
    from scipy import sparse

    ops, m = numpy_operations(), parts(model)
    identity = sparse.identity(m.n, format="csc")

    def solve(p: Any, x: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
        Q, R = np.diag(p["Q"]), p["lam"] * np.diag(p["R"][: m.n])
        previous, effect, nu = p["u_previous"][: m.n], p["effectiveness"][: m.n], p["nu_flow"]

        def G(v: np.ndarray) -> np.ndarray:
            return np.array(wrench(ops, m, v, previous, effect, nu))

        for _ in range(PAPER_BUDGET):
            tau = G(x)
            J = np.array([(G(x + 1e-6 * e) - tau) / 1e-6 for e in np.eye(m.n)]).T
            H, g = J.T @ Q @ J + R, -J.T @ Q @ (p["tau_d"] - tau) + R @ x
            solver = osqp.OSQP()
            solver.setup(sparse.csc_matrix(np.triu(H)), g, identity, lower - x, upper - x, verbose=False)
            step = np.clip(x + solver.solve(raise_error=False).x, lower, upper) - x
            x = x + step
            if np.abs(step).max() < TOLERANCE:
                break
        return x

    return solve


def _sqp(model: np.void, qp: Callable[..., np.ndarray | None]) -> Solve:
    """Our SQP written in Python around compiled G_m and normal equations; `qp(H, g, lb, ub)` is the peer."""
    n = int(model["n_u"])
    tau, J, H, g = np.zeros(6), np.zeros((6, 8)), np.zeros((8, 8)), np.zeros(8)
    none = np.zeros(8)

    def solve(p: Any, x: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
        x = np.append(x, np.zeros(8 - n))
        cost = cost_at(model, p, x, tau, J)
        for _ in range(BUDGET):
            normal_equations(p["Q"], p["R"], p["lam"], p["tau_d"], tau, J, x, n, H, g)
            lb, ub = lower - x[:n], upper - x[:n]
            if kkt_residual(H, g, lb, ub, none, n) <= TOLERANCE:
                break
            answer = qp(H[:n, :n], g[:n], lb, ub)
            if answer is None:  # the peer gave up on this QP
                break
            step = np.clip(answer, lb, ub)
            for k in range(6):
                trial = x.copy()
                trial[:n] += 0.5**k * step
                there = cost_at(model, p, trial, tau, J)
                if there < cost:
                    break
            else:
                break
            x, cost = trial, there
        return x[:n]

    return solve


def daqp_api(model: np.void) -> Solve:
    """The same SQP with daqp's Python API."""
    daqp = importlib.import_module("daqp")
    none = np.zeros((0, int(model["n_u"])))
    return _sqp(model, lambda H, g, lb, ub: daqp.solve(np.ascontiguousarray(H), g, none, ub, lb)[0])


def qpsolvers_api(model: np.void) -> Solve:
    """The same SQP with qpsolvers: its daqp, and its OSQP where that gives up."""
    qpsolvers = importlib.import_module("qpsolvers")
    order = [s for s in ("daqp", "quadprog", "osqp") if s in qpsolvers.available_solvers]

    def solve(H: np.ndarray, g: np.ndarray, lb: np.ndarray, ub: np.ndarray) -> np.ndarray | None:
        for name in order:
            if (x := qpsolvers.solve_qp(H, g, lb=lb, ub=ub, solver=name)) is not None:
                return x
        return None

    return _sqp(model, solve)


def slsqp(model: np.void) -> Solve:
    """SciPy's SLSQP with compiled cost and exact gradient."""
    from scipy.optimize import minimize

    n = int(model["n_u"])
    tau, J, H, g = np.zeros(6), np.zeros((6, 8)), np.zeros((8, 8)), np.zeros(8)

    def solve(p: Any, x: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
        def cost(v: np.ndarray) -> tuple[float, np.ndarray]:
            value = cost_at(model, p, v, tau, J)
            normal_equations(p["Q"], p["R"], p["lam"], p["tau_d"], tau, J, v, n, H, g)
            return value, 2.0 * g[:n]

        bounds = np.stack([lower, upper], axis=1)
        found = minimize(cost, x, jac=True, bounds=bounds, method="SLSQP", options={"ftol": 1e-9})
        return np.clip(found.x, lower, upper)

    return solve


def ipopt(model: np.void) -> Solve:
    """CasADi's derivatives with IPOPT, built once, the cycle's data as parameters."""
    ca = importlib.import_module("casadi")
    ops = SimpleNamespace(where=ca.if_else, sin=ca.sin, atan2=ca.atan2, sqrt=ca.sqrt, abs=ca.fabs,
                          minimum=ca.fmin, maximum=ca.fmax,
                          mod=lambda a, b: a - b * ca.floor(a / b))  # fmt: skip
    m = parts(model)
    n = m.n
    x, q = ca.SX.sym("x", n), ca.SX.sym("q", 19 + 3 * n)
    tau_d, nu, Q, lam = q[0:6], q[6:12], q[12:18], q[18]
    R, previous, effect = q[19 : 19 + n], q[19 + n : 19 + 2 * n], q[19 + 2 * n :]
    each = SimpleNamespace(n=1, rho=m.rho)
    tau = [0.0] * 6
    for i in range(n):  # if_else wants scalars
        for name, value in vars(m).items():
            if isinstance(value, np.ndarray):
                setattr(each, name, value[i : i + 1])
        one = wrench(ops, each, x[i], previous[i], effect[i], nu)
        tau = [a + b for a, b in zip(tau, one, strict=True)]
    cost = sum(Q[k] * (tau_d[k] - tau[k]) ** 2 for k in range(6)) + lam * ca.sum1(R * x**2)
    quiet = {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes", "ipopt.tol": 1e-8}
    solver = ca.nlpsol("allocation", "ipopt", {"x": x, "p": q, "f": cost}, quiet)

    def solve(p: Any, start: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
        data = np.concatenate([p["tau_d"], p["nu_flow"], p["Q"], [p["lam"]], p["R"][:n],
                               p["u_previous"][:n], p["effectiveness"][:n]])  # fmt: skip
        found = solver(x0=start, p=data, lbx=lower, ubx=upper)
        return np.clip(np.array(found["x"]).ravel(), lower, upper)

    return solve


PEERS: dict[str, tuple[str, Callable[[np.void], Solve]]] = {
    "paper": ("paper style: NumPy, finite differences, OSQP setup()", paper_style),
    "daqp": ("SQP with daqp's Python API", daqp_api),
    "qpsolvers": ("SQP with qpsolvers", qpsolvers_api),
    "slsqp": ("SciPy SLSQP", slsqp),
    "ipopt": ("CasADi + IPOPT", ipopt),
}
