"""daqp as the QP solver, where it is installed: a dual active-set method.

The wheel's extension exports daqp's C function `daqp_quadprog`, which is called by address with
structures laid out as in daqp 0.11.0 (`types.h`, `api.h`). Any other version is used through its
Python API. Source: Arnstroem, Bemporad and Axehill, IEEE TAC 67 (2022) 4362.
"""

import ctypes
import importlib.metadata
import importlib.util

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.control.allocation.qp_handle import DAQP, FUNCTIONS, MEMORY, WORKSPACE, new_handle
from bumpless.control.allocation.qp_memory import call_3, carray, floats_at
from bumpless.control.allocation.qp_python import make_python_handle
from bumpless.control.allocation.qp_scaling import scale
from bumpless.control.allocation.qp_state import adopt
from bumpless.jit import jit

KNOWN_VERSIONS = ("0.11.0",)

_N = MAX_ACTUATORS
_i, _f, _p = ctypes.c_int, ctypes.c_double, ctypes.c_void_p


class _Problem(ctypes.Structure):
    _fields_ = [
        ("n", _i), ("m", _i), ("ms", _i), ("H", _p), ("f", _p), ("A", _p), ("bupper", _p),
        ("blower", _p), ("sense", _p), ("break_points", _p), ("nh", _i), ("problem_type", _i),
    ]  # fmt: skip


class _Result(ctypes.Structure):
    _fields_ = [
        ("x", _p), ("lam", _p), ("fval", _f), ("soft_slack", _f), ("exitflag", _i), ("iter", _i),
        ("nodes", _i), ("solve_time", _f), ("setup_time", _f),
    ]  # fmt: skip


class _Memory(ctypes.Structure):
    """The result and the arrays first: compiled code reads them by their place."""

    _fields_ = [
        ("result", _Result),  # nine words: x, lam, fval, soft_slack, (exitflag, iter), nodes, times
        ("H", _f * (_N * _N)), ("f", _f * _N), ("lower", _f * _N), ("upper", _f * _N),
        ("x", _f * _N), ("lam", _f * _N), ("d", _f * _N), ("P", _f * (_N * _N)),
        ("problem", _Problem),
    ]  # fmt: skip


_EXIT = _Result.exitflag.offset // 8
_H, _F, _L, _U, _X, _Y, _D, _P = (
    getattr(_Memory, name).offset // 8 for name in ("H", "f", "lower", "upper", "x", "lam", "d", "P")
)
_SIZE = _Memory.problem.offset // 8


def _native() -> np.ndarray | None:
    package = importlib.util.find_spec("daqp")
    if package is None or not package.origin or importlib.metadata.version("daqp") not in KNOWN_VERSIONS:
        return None
    try:
        function = ctypes.CDLL(package.origin).daqp_quadprog
    except (OSError, AttributeError):
        return None
    memory = _Memory()
    at = ctypes.addressof(memory)
    memory.result.x, memory.result.lam = at + 8 * _X, at + 8 * _Y
    problem = memory.problem
    problem.n = problem.m = problem.ms = _N
    problem.H, problem.f, problem.blower, problem.bupper = at + 8 * _H, at + 8 * _F, at + 8 * _L, at + 8 * _U
    handle = new_handle(DAQP, lambda kept: None, memory)
    handle[MEMORY] = at
    handle[WORKSPACE] = at + _Memory.problem.offset
    handle[FUNCTIONS + 1] = ctypes.cast(function, _p).value
    return handle


def _public() -> np.ndarray:
    import daqp

    rows, columns = np.triu_indices(_N)
    order = np.lexsort((rows, columns))
    H, none = np.zeros((_N, _N)), np.zeros((0, _N))

    def solve(P, q, lower, upper, x, y) -> int:
        H[rows[order], columns[order]] = P
        H[columns[order], rows[order]] = P
        found, _, flag, info = daqp.solve(H, q, none, upper, lower)
        if flag <= 0:
            return -1
        x[:], y[:] = found, info["lam"]
        return int(info["iterations"])

    return make_python_handle(DAQP, solve)


def make_daqp_handle() -> np.ndarray:
    """Handle of daqp. Raises ModuleNotFoundError where daqp is not installed."""
    if importlib.util.find_spec("daqp") is None:
        raise ModuleNotFoundError(
            "allocation.solver = 'daqp'; the package daqp must be installed", name="daqp"
        )
    native = _native()
    return native if native is not None else _public()


@jit
def quadprog(handle, H, g, lb, ub, x, n, state):
    """Solve by daqp_quadprog. Writes state and x as `qp_state.adopt` does. Returns its iterations,
    negative on failure (x and state are then untouched)."""
    memory = carray(floats_at(handle[MEMORY]), (_SIZE,))
    d, P, q, z, y = memory[_D:_P], memory[_P:], memory[_F:_L], memory[_X:_Y], memory[_Y:_D]
    lower, upper = memory[_L:_U], memory[_U:_X]
    scale(H, g, lb, ub, x, n, d, P, q, lower, upper, z)
    k = 0
    for j in range(_N):
        for i in range(j + 1):
            memory[_H + _N * i + j] = P[k]
            memory[_H + _N * j + i] = P[k]
            k += 1
    call_3(handle[FUNCTIONS + 1], handle[MEMORY], handle[WORKSPACE], 0)
    words = memory[_EXIT : _EXIT + 1].view(np.int32)
    if words[0] <= 0:
        return -1
    for i in range(n):
        if y[i] < 0.0:
            z[i] = lower[i]
        elif y[i] > 0.0:
            z[i] = upper[i]
    adopt(d, lower, upper, z, lb, ub, x, n, state)
    return np.int64(words[1])
