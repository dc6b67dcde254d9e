"""One entry for every small box QP of the allocator, whichever solver answers it.

    handle = make_handle("active_set")                       # Python, once per simulation and thread
    status = solve_box_qp(handle, H, g, lb, ub, x, n)        # compiled code, every cycle
    rounds = handle[ITERATIONS]

A handle is an int64 array: compiled code takes it like any other argument and stays cacheable. It
holds addresses of this process, so it is made anew in each process, and serves one thread at a time.
"""

import numpy as np
from numba import njit

from twin.allocation.qp_active_set import solve_active_set

# entries of a handle
SOLVER = 0
ITERATIONS = 1  # rounds of the last solve, all methods together
HANDLE_SIZE = 16

# values of handle[SOLVER]
ACTIVE_SET, OSQP_NATIVE, OSQP_PUBLIC, DAQP = 0, 1, 2, 3


def make_handle(solver: str = "active_set") -> np.ndarray:
    """Workspace of a solver, as an int64 array for `solve_box_qp`.

    solver: "active_set", "osqp" or "daqp". Raises ValueError on any other name. What the solver
    allocated is freed when the last reference to the array goes.
    """
    if solver not in ("active_set",):
        raise ValueError(f"allocation.solver = {solver!r}; must be active_set, osqp or daqp")
    return np.zeros(HANDLE_SIZE, dtype=np.int64)


@njit(cache=True, nogil=True, error_model="numpy")
def solve_box_qp(handle, H, g, lb, ub, x, n):
    """Minimise 1/2 x'Hx + g'x over lb <= x <= ub; return a status of `qp_status`.

    H (>=n, >=n) symmetric positive definite, g, lb, ub, x (>=n) float64, n <= MAX_ACTUATORS;
    entries beyond n are ignored. x is the start (any values) and the answer: inside its bounds and
    never NaN, whatever the status. Bounds may be equal or infinite. Never raises.
    """
    status, rounds = solve_active_set(H, g, lb, ub, x, n)
    handle[ITERATIONS] = rounds
    return status
