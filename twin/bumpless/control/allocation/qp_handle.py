"""What the int64 array holds that stands for a QP solver in compiled code."""

import weakref
from collections.abc import Callable

import numpy as np

HANDLE_SIZE = 32

SOLVER = 0  # one of the four below
SELF = 1  # address of the array itself: a copy or a pickle does not match, and is not trusted
ITERATIONS = 2  # rounds of the last solve: first-order iterations and active-set rounds
FIRST_ORDER = 3  # of these, the chosen solver's own iterations
# addresses: a workspace of the chosen library, memory it works on, and functions
WORKSPACE = 4
MEMORY = 5
FUNCTIONS = 8  # first of up to 12 function addresses

ACTIVE_SET, OSQP_NATIVE, OSQP_PUBLIC, DAQP = 0, 1, 2, 3


def new_handle(solver: int, release: Callable[..., object] | None = None, *arguments: object) -> np.ndarray:
    """Zeroed handle of `solver`; `release(*arguments)` runs when its last reference goes."""
    handle = np.zeros(HANDLE_SIZE, dtype=np.int64)
    handle[SOLVER] = solver
    handle[SELF] = handle.ctypes.data
    if release is not None:
        # the process's end frees everything anyway, in an order that is not ours to choose
        weakref.finalize(handle, release, *arguments).atexit = False
    return handle
