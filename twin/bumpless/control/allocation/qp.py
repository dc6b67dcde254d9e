"""One entry for every small box QP of the allocator, whichever solver answers it.

    handle = make_handle("osqp")                             # Python, once per simulation and thread
    status = solve_box_qp(handle, H, g, lb, ub, x, n)        # compiled code, every cycle
    rounds = handle[ITERATIONS]

A handle is an int64 array: compiled code takes it like any other argument and stays cacheable. It
holds addresses of this process, so it is made anew in each process, and serves one thread at a
time. A copied handle is recognised and answered by the built-in active set.
"""

import functools
from collections.abc import Callable

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.contract.enums import FALLBACK, SOLVED
from bumpless.control.allocation import osqp_native, qp_daqp, qp_python
from bumpless.control.allocation.qp_active_set import (
    LOWER,
    UPPER,
    admit,
    confirm,
    finish,
    solve_active_set,
)
from bumpless.control.allocation.qp_handle import (
    ACTIVE_SET,
    DAQP,
    FIRST_ORDER,
    FUNCTIONS,
    ITERATIONS,
    OSQP_NATIVE,
    OSQP_PUBLIC,
    SELF,
    SOLVER,
    new_handle,
)
from bumpless.control.allocation.qp_memory import carray, stack_floats, stack_ints
from bumpless.jit import allocating, jit

_N = MAX_ACTUATORS
_NN = _N * _N

SOLVERS = ("osqp", "active_set", "daqp")


def make_handle(solver: str = "osqp") -> np.ndarray:
    """Workspace of a solver, as an int64 array for `solve_box_qp`.

    solver: one of SOLVERS. Raises ValueError on any other name, ModuleNotFoundError for daqp where
    it is not installed; osqp takes the fastest way that works here, see `route`. What the solver
    allocated is freed when the last reference to the array goes.
    """
    if solver == "osqp":
        handle = _osqp_maker()()
        return new_handle(ACTIVE_SET) if handle is None else handle
    if solver == "active_set":
        return new_handle(ACTIVE_SET)
    if solver == "daqp":
        return qp_daqp.make_daqp_handle()
    raise ValueError(f"allocation.solver = {solver!r}; must be one of {', '.join(SOLVERS)}")


def route() -> str:
    """How "osqp" is answered in this process: "native", "public" or "active_set"."""
    return {OSQP_NATIVE: "native", OSQP_PUBLIC: "public"}.get(int(make_handle("osqp")[SOLVER]), "active_set")


@functools.cache
def _osqp_maker() -> Callable[[], np.ndarray | None]:
    """The first way to OSQP that gives right answers on problems with known optimum."""
    for make in (osqp_native.make_native_handle, qp_python.make_osqp_handle):
        try:
            handle = make()
        except Exception:  # an osqp of another generation may fail in any way: try the next route
            continue
        if handle is not None and _answers_rightly(handle):
            return make
    return functools.partial(new_handle, ACTIVE_SET)


def _answers_rightly(handle: np.ndarray) -> bool:
    """True if the solver alone, without the exact finish, finds the bounds that hold at the optimum."""
    rng = np.random.default_rng(20260514)
    right = 0
    for _ in range(24):
        G = rng.normal(size=(MAX_ACTUATORS, MAX_ACTUATORS))
        H = G.T @ G + MAX_ACTUATORS * np.eye(MAX_ACTUATORS)
        g = rng.normal(size=MAX_ACTUATORS) * MAX_ACTUATORS
        ub = rng.uniform(0.1, 1.0, size=MAX_ACTUATORS)
        right += right_guesses(handle, H, g, -ub, ub)
    return right >= 0.8 * 24 * MAX_ACTUATORS


@jit
def start(handle, H, g, lb, ub, x, n, state):
    """Let the handle's solver move x near the optimum and guess the bounds that hold there.

    Returns its iterations, negative if it failed, cannot be trusted or is none: x is then untouched.
    """
    if handle[SELF] != handle.ctypes.data:
        return -1
    if handle[SOLVER] == OSQP_NATIVE:
        return osqp_native.iterate(handle, H, g, lb, ub, x, n, state)
    if handle[SOLVER] == DAQP and handle[FUNCTIONS + 1] != 0:
        return qp_daqp.quadprog(handle, H, g, lb, ub, x, n, state)
    if handle[SOLVER] == OSQP_PUBLIC or handle[SOLVER] == DAQP:
        return qp_python.ask(handle, H, g, lb, ub, x, n, state)
    return -1


@allocating
def right_guesses(handle, H, g, lb, ub):
    """For how many variables the handle's solver knows whether and which bound holds; -1000 if it failed."""
    exact, x, state = np.zeros(_N), np.zeros(_N), np.zeros(_N, np.int64)
    if start(handle, H, g, lb, ub, x, _N, state) < 1:
        return -1000
    solve_active_set(H, g, lb, ub, exact, _N)
    right = 0
    for i in range(_N):
        right += (state[i] == LOWER) == (exact[i] == lb[i]) and (state[i] == UPPER) == (exact[i] == ub[i])
    return right


@jit
def _solve(handle, H, g, lb, ub, x, n):
    handle[FIRST_ORDER] = 0
    if handle[SOLVER] == ACTIVE_SET:
        status, rounds = solve_active_set(H, g, lb, ub, x, n)
        handle[ITERATIONS] = rounds
        return status
    handle[ITERATIONS] = 0
    status = admit(H, g, lb, ub, x, n)
    if status != SOLVED:
        return status
    if confirm(H, g, lb, ub, x, n):  # the bounds of the last cycle still hold: nothing to search
        handle[ITERATIONS] = 1
        return status
    state = carray(stack_ints(_N), (_N,))
    iterations = start(handle, H, g, lb, ub, x, n, state)
    if iterations < 0:
        status, rounds = solve_active_set(H, g, lb, ub, x, n)
        handle[ITERATIONS] = rounds
        return FALLBACK if status == SOLVED else status
    status, rounds = finish(H, g, lb, ub, x, state, n)
    handle[FIRST_ORDER] = iterations
    handle[ITERATIONS] = iterations + rounds
    return status


@jit
def solve_box_qp(handle, H, g, lb, ub, x, n):
    """Minimise 1/2 x'Hx + g'x over lb <= x <= ub; return a SolveStatus (`contract.enums`).

    H (>=n, >=n) symmetric positive definite, g, lb, ub, x (>=n) float64, n <= MAX_ACTUATORS;
    entries beyond n are ignored. x is the start (any values) and the answer: inside its bounds and
    never NaN, whatever the status. Bounds may be equal or infinite. Never raises. Every solver's
    answer is finished by the exact active set, so all give the same optimum; none is asked where the bounds
    that hold at the start hold at the optimum too.
    """
    # copies of one memory layout: whatever arrays the callers have, the solvers are compiled once
    A = carray(stack_floats(_NN), (_N, _N))
    b, lower = carray(stack_floats(_N), (_N,)), carray(stack_floats(_N), (_N,))
    upper, y = carray(stack_floats(_N), (_N,)), carray(stack_floats(_N), (_N,))
    for i in range(n):
        b[i], lower[i], upper[i], y[i] = g[i], lb[i], ub[i], x[i]
        for j in range(n):
            A[i, j] = H[i, j]
    status = _solve(handle, A, b, lower, upper, y, np.int64(n))
    for i in range(n):
        x[i] = y[i]
    return status
