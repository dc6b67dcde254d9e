"""Solvers behind their public Python API, callable from compiled code without the GIL.

Compiled code writes the scaled problem into memory that the handle owns and calls a C callback;
the callback takes the GIL, lets the Python library solve, and leaves iterate and multipliers in
the same memory. No numba object mode is involved, so the callers stay cacheable. Slow (about a
hundred microseconds), but it needs nothing of a library's inside.
"""

import ctypes
import itertools
import signal
import threading
from collections.abc import Callable

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.control.allocation.qp_handle import FUNCTIONS, MEMORY, OSQP_PUBLIC, new_handle
from bumpless.control.allocation.qp_memory import call_1, carray, floats_at
from bumpless.control.allocation.qp_scaling import UPPER_TRIANGLE, scale
from bumpless.control.allocation.qp_state import adopt
from bumpless.jit import jit

MAX_ITERATIONS = 50
_INTERRUPTED = 10  # OSQP_SIGINT of osqp_api_constants.h

_N = MAX_ACTUATORS
_P, _Q, _L, _U, _X, _Y, _D = (0, *range(UPPER_TRIANGLE, UPPER_TRIANGLE + 6 * _N, _N))
_SIZE = _D + _N

_Callback = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int64)
_alive: dict[int, tuple] = {}  # what a handle's addresses point to, until the handle goes
_keys = itertools.count()


def make_python_handle(kind: int, solve: Callable[..., int]) -> np.ndarray:
    """Handle whose solver is `solve(P, q, lower, upper, x, y) -> iterations`, negative on failure.

    P: upper triangle of the Hessian, column by column; x: start and answer; y: multipliers, negative
    at a lower bound. All are views of one array, MAX_ACTUATORS each, P UPPER_TRIANGLE.
    """
    memory = np.zeros(_SIZE)
    parts = [memory[_P:_Q], *(memory[k : k + _N] for k in (_Q, _L, _U, _X, _Y))]

    def answer(_: int) -> int:
        try:
            return solve(*parts)
        except Exception:  # nothing may cross the boundary to compiled code
            return -1

    callback = _Callback(answer)
    key = next(_keys)
    _alive[key] = (memory, callback)
    handle = new_handle(kind, _alive.pop, key, None)
    handle[MEMORY] = memory.ctypes.data
    handle[FUNCTIONS] = ctypes.cast(callback, ctypes.c_void_p).value
    return handle


# osqp_solve swaps the SIGINT handler through one static variable: one at a time
_one_at_a_time = threading.Lock()


def make_osqp_handle() -> np.ndarray:
    """Handle of OSQP's Python API with a workspace of its own. Raises ImportError without osqp."""
    import osqp
    from scipy import sparse

    solver = osqp.OSQP()
    solver.setup(
        sparse.csc_matrix(np.triu(np.ones((_N, _N)) + _N * np.eye(_N))),
        np.zeros(_N),
        sparse.identity(_N, format="csc"),
        -np.ones(_N),
        np.ones(_N),
        verbose=False,
        scaling=0,
        polishing=False,
        max_iter=MAX_ITERATIONS,
        check_termination=5,
        adaptive_rho_interval=5,
        eps_abs=1e-4,
        eps_rel=1e-4,
    )

    def solve(P, q, lower, upper, x, y) -> int:
        with _one_at_a_time:
            solver.update(Px=P, q=q, l=lower, u=upper)
            solver.warm_start(x=x)
            result = solver.solve(raise_error=False)
        if result.info.status_val == _INTERRUPTED:
            signal.raise_signal(signal.SIGINT)  # OSQP swallowed a Ctrl-C that was not for it
        if result.x is None or not (np.isfinite(result.x).all() and np.isfinite(result.y).all()):
            return -1
        x[:], y[:] = result.x, result.y
        return int(result.info.iter)

    return make_python_handle(OSQP_PUBLIC, solve)


@jit
def ask(handle, H, g, lb, ub, x, n, state):
    """Let the handle's Python solver answer. Writes state and x as `qp_state.adopt` does. Returns its
    iterations, negative on failure (x and state are then untouched)."""
    memory = carray(floats_at(handle[MEMORY]), (_SIZE,))
    d, q, y, z = memory[_D:], memory[_Q:_L], memory[_Y:_D], memory[_X:_Y]
    lower, upper = memory[_L:_U], memory[_U:_X]
    scale(H, g, lb, ub, x, n, d, memory, q, lower, upper, z)
    iterations = call_1(handle[FUNCTIONS], 0)
    if iterations < 0:
        return -1
    for i in range(n):
        # a multiplier beyond the distance to its bound means that the bound holds (OSQP, section 4)
        if z[i] - lower[i] < -y[i]:
            z[i] = lower[i]
        elif upper[i] - z[i] < y[i]:
            z[i] = upper[i]
    adopt(d, lower, upper, z, lb, ub, x, n, state)
    return iterations
