"""One entry for every small box QP of the allocator, whichever solver answers it.

    handle = make_handle("osqp")                             # Python, once per simulation and thread
    status = solve_box_qp(handle, H, g, lb, ub, x, n)        # compiled code, every cycle
    rounds = handle[ITERATIONS]

A handle is an int64 array: compiled code takes it like any other argument and stays cacheable. It
holds addresses of this process, so it is made anew in each process, and serves one thread at a
time. A copied handle is recognised and answered by the built-in active set.
"""

import numpy as np
from numba import carray, njit

from twin.allocation import osqp_native
from twin.allocation.qp_active_set import admit, finish, solve_active_set
from twin.allocation.qp_handle import (
    ACTIVE_SET,
    FIRST_ORDER,
    ITERATIONS,
    OSQP_NATIVE,
    SELF,
    SOLVER,
    new_handle,
)
from twin.allocation.qp_memory import stack_ints
from twin.allocation.qp_status import FALLBACK, SOLVED
from twin.records import MAX_ACTUATORS


def make_handle(solver: str = "osqp") -> np.ndarray:
    """Workspace of a solver, as an int64 array for `solve_box_qp`.

    solver: "active_set", "osqp" or "daqp". Raises ValueError on any other name. What the solver
    allocated is freed when the last reference to the array goes.
    """
    if solver == "active_set":
        return new_handle(ACTIVE_SET)
    if solver == "osqp":
        return osqp_native.make_native_handle()
    raise ValueError(f"allocation.solver = {solver!r}; must be active_set, osqp or daqp")


@njit(cache=True, nogil=True, error_model="numpy")
def solve_box_qp(handle, H, g, lb, ub, x, n):
    """Minimise 1/2 x'Hx + g'x over lb <= x <= ub; return a status of `qp_status`.

    H (>=n, >=n) symmetric positive definite, g, lb, ub, x (>=n) float64, n <= MAX_ACTUATORS;
    entries beyond n are ignored. x is the start (any values) and the answer: inside its bounds and
    never NaN, whatever the status. Bounds may be equal or infinite. Never raises.
    """
    handle[FIRST_ORDER] = 0
    if handle[SOLVER] == ACTIVE_SET:
        status, rounds = solve_active_set(H, g, lb, ub, x, n)
        handle[ITERATIONS] = rounds
        return status
    handle[ITERATIONS] = 0
    status = admit(H, g, lb, ub, x, n)
    if status != SOLVED:
        return status
    first = -1
    state = carray(stack_ints(MAX_ACTUATORS), (MAX_ACTUATORS,))
    if handle[SELF] == handle.ctypes.data:
        if handle[SOLVER] == OSQP_NATIVE:
            first = osqp_native.iterate(handle, H, g, lb, ub, x, n, state)
    if first < 0:
        status, rounds = solve_active_set(H, g, lb, ub, x, n)
        handle[ITERATIONS] = rounds
        return FALLBACK if status == SOLVED else status
    status, rounds = finish(H, g, lb, ub, x, state, n)
    handle[FIRST_ORDER] = first
    handle[ITERATIONS] = first + rounds
    return status
