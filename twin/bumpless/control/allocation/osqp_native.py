"""OSQP's own iterations, called from compiled code through the wheel's extension module.

The wheel's extension exports OSQP's C functions. Calling them by address costs a few microseconds
where the Python API costs a hundred. Two things are done differently from `osqp_solve`:

* the loop over ADMM iterations is ours, made of OSQP's exported steps. `osqp_solve` replaces the
  process's SIGINT handler during each call through one static variable, so that concurrent solves
  can lose Ctrl-C for good, and pays two system calls for it;
* the loop ends when the set of bounds that hold stays the same, because the exact active-set
  finish needs no more than that.

Everything that reaches into the library is in this file. It relies on the layout of OSQP 1.0.0
(`osqp_api_types.h`, `types.h`; wheels 1.0 and 1.1), with 32-bit OSQPInt and double OSQPFloat, and
checks what it finds before use: `library()` is None where anything differs.

Source: Stellato et al., OSQP, Math. Prog. Comp. 12 (2020) 637, algorithm 1.
"""

import ctypes
import functools
import importlib.machinery
import importlib.util
import math
from pathlib import Path

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.control.allocation.qp_handle import FUNCTIONS, MEMORY, OSQP_NATIVE, WORKSPACE, new_handle
from bumpless.control.allocation.qp_memory import (
    address_of,
    call_1,
    call_2,
    call_3,
    call_4,
    call_7,
    carray,
    floats_at,
    ints_at,
    stack_floats,
)
from bumpless.control.allocation.qp_scaling import UPPER_TRIANGLE, scale
from bumpless.control.allocation.qp_state import adopt
from bumpless.jit import jit

KNOWN_VERSIONS = (b"1.0.0",)
MAX_ITERATIONS = 10
STEADY_ITERATIONS = 1  # further iterations that must repeat the guess of active bounds
RHO_INTERVAL = 5  # iterations between adaptations of rho

_N = MAX_ACTUATORS
_i, _f, _p = ctypes.c_int, ctypes.c_double, ctypes.c_void_p

# order of the addresses in a handle, from FUNCTIONS on
_STEPS = (
    "osqp_update_data_mat",
    "osqp_update_data_vec",
    "osqp_warm_start",
    "update_xz_tilde",
    "update_x",
    "update_z",
    "update_y",
    "update_info",
    "adapt_rho",
    "osqp_cold_start",
)
_UPDATE_MATRIX, _UPDATE_VECTORS, _WARM_START, _XZ, _X, _Z, _Y, _INFO, _ADAPT, _COLD = range(
    FUNCTIONS, FUNCTIONS + len(_STEPS)
)
# words of OSQPWorkspace that point to the iterates
_AT_X, _AT_Y, _AT_Z, _AT_X_PREVIOUS, _AT_Z_PREVIOUS = 6, 7, 8, 12, 13


class _Settings(ctypes.Structure):
    _fields_ = [
        ("device", _i), ("linsys_solver", _i), ("allocate_solution", _i), ("verbose", _i),
        ("profiler_level", _i), ("warm_starting", _i), ("scaling", _i), ("polishing", _i),
        ("rho", _f), ("rho_is_vec", _i), ("sigma", _f), ("alpha", _f),
        ("cg_max_iter", _i), ("cg_tol_reduction", _i), ("cg_tol_fraction", _f), ("cg_precond", _i),
        ("adaptive_rho", _i), ("adaptive_rho_interval", _i), ("adaptive_rho_fraction", _f),
        ("adaptive_rho_tolerance", _f), ("max_iter", _i), ("eps_abs", _f), ("eps_rel", _f),
        ("eps_prim_inf", _f), ("eps_dual_inf", _f), ("scaled_termination", _i),
        ("check_termination", _i), ("check_dualgap", _i), ("time_limit", _f), ("delta", _f),
        ("polish_refine_iter", _i),
    ]  # fmt: skip


class _Solver(ctypes.Structure):
    _fields_ = [("settings", ctypes.POINTER(_Settings)), ("solution", _p), ("info", _p), ("work", _p)]


_DEFAULTS = {"warm_starting": 1, "scaling": 10, "rho": 0.1, "rho_is_vec": 1, "sigma": 1e-6, "alpha": 1.6,
             "adaptive_rho_interval": 50, "max_iter": 4000, "eps_abs": 1e-3, "check_termination": 25,
             "delta": 1e-6, "polish_refine_iter": 3}  # fmt: skip


def _find() -> Path | None:
    """The extension module of the installed osqp package, without importing either."""
    package = importlib.util.find_spec("osqp")
    for folder in (package.submodule_search_locations or ()) if package else ():
        for suffix in importlib.machinery.EXTENSION_SUFFIXES:
            file = Path(folder) / f"ext_builtin{suffix}"
            if file.is_file():
                return file
    return None


@functools.cache
def library() -> ctypes.CDLL | None:
    """The C library inside the osqp wheel, or None if it is absent or not as this file expects."""
    file = _find()
    if file is None or ctypes.sizeof(_p) != 8:
        return None
    try:
        lib = ctypes.CDLL(str(file))
        for name in (*_STEPS, "osqp_setup", "osqp_cleanup", "osqp_get_dimensions", "OSQPSettings_free"):
            getattr(lib, name)
        lib.osqp_version.restype = ctypes.c_char_p
        lib.OSQPSettings_new.restype = ctypes.POINTER(_Settings)
        lib.OSQPCscMatrix_new.restype = _p
        lib.OSQPVectorf_data.restype = _p
        lib.OSQPVectorf_length.restype = _i
        lib.OSQPVectorf_data.argtypes = lib.OSQPVectorf_length.argtypes = [_p]
        lib.OSQPSettings_free.argtypes = [ctypes.POINTER(_Settings)]
        lib.OSQPCscMatrix_new.argtypes = [_i, _i, _i, _p, _p, _p]
        lib.OSQPCscMatrix_free.argtypes = [_p]
        lib.osqp_cleanup.argtypes = [_p]
        lib.osqp_warm_start.argtypes = [_p, _p, _p]
        lib.osqp_get_dimensions.argtypes = [_p, _p, _p]
        lib.osqp_setup.argtypes = [_p, _p, _p, _p, _p, _p, _i, _i, ctypes.POINTER(_Settings)]
    except (OSError, AttributeError):
        return None
    if lib.osqp_version() not in KNOWN_VERSIONS:
        return None
    settings = lib.OSQPSettings_new()
    as_expected = all(getattr(settings.contents, name) == value for name, value in _DEFAULTS.items())
    lib.OSQPSettings_free(settings)
    return lib if as_expected else None


def _setup(lib: ctypes.CDLL) -> ctypes.c_void_p:
    """A solver of size MAX_ACTUATORS with a dense P and A = I. Raises OSError if it cannot be had."""
    columns = np.arange(_N + 1, dtype=np.int32)
    p_start = (columns * (columns + 1) // 2).astype(np.int32)
    p_rows = np.concatenate([np.arange(j + 1, dtype=np.int32) for j in range(_N)])
    p_values = np.concatenate([np.eye(_N)[: j + 1, j] for j in range(_N)])
    ones, zeros = np.ones(_N), np.zeros(_N)
    lower = -ones
    P = lib.OSQPCscMatrix_new(
        _N, _N, UPPER_TRIANGLE, p_values.ctypes.data, p_rows.ctypes.data, p_start.ctypes.data
    )
    A = lib.OSQPCscMatrix_new(_N, _N, _N, ones.ctypes.data, columns.ctypes.data, columns.ctypes.data)
    settings = lib.OSQPSettings_new()
    chosen = settings.contents
    chosen.verbose = chosen.scaling = chosen.polishing = chosen.rho_is_vec = 0
    chosen.check_termination = 0
    chosen.max_iter = MAX_ITERATIONS
    chosen.adaptive_rho_interval = RHO_INTERVAL
    chosen.rho = 0.1
    solver = ctypes.c_void_p()
    error = lib.osqp_setup(
        ctypes.byref(solver), P, zeros.ctypes.data, A, lower.ctypes.data, ones.ctypes.data, _N, _N, settings
    )
    lib.OSQPCscMatrix_free(P)
    lib.OSQPCscMatrix_free(A)
    lib.OSQPSettings_free(settings)
    if error or not solver.value:
        raise OSError(f"osqp_setup returned {error}")
    return solver


def _layout_holds(lib: ctypes.CDLL, solver: ctypes.c_void_p) -> bool:
    """Write known iterates by the public API and find them where the compiled loop will look."""
    wide = np.full(2, -1, dtype=np.int64)  # a 32-bit OSQPInt leaves the upper half alone
    lib.osqp_get_dimensions(solver, wide[:1].ctypes.data, wide[1:].ctypes.data)
    if tuple(wide.view(np.int32)) != (_N, -1, _N, -1):
        return False
    x, y = np.arange(1.0, _N + 1), -np.arange(1.0, _N + 1)
    if lib.osqp_warm_start(solver, x.ctypes.data, y.ctypes.data):
        return False
    work = ctypes.cast(solver, ctypes.POINTER(_Solver)).contents.work
    words = (ctypes.c_size_t * 14).from_address(work)
    places = (_AT_X, _AT_Y, _AT_Z, _AT_X_PREVIOUS, _AT_Z_PREVIOUS)
    if len({words[k] for k in places}) != len(places):
        return False
    for k in places:
        values = lib.OSQPVectorf_data(words[k])
        if values != ctypes.c_size_t.from_address(words[k]).value or lib.OSQPVectorf_length(words[k]) != _N:
            return False
    found = [np.array((_f * _N).from_address(lib.OSQPVectorf_data(words[k]))) for k in places[:3]]
    return bool((found[0] == x).all() and (found[1] == y).all() and (found[2] == x).all())


def make_native_handle() -> np.ndarray | None:
    """Handle with an OSQP workspace of its own, or None where the library cannot be used this way."""
    lib = library()
    if lib is None:
        return None
    try:
        solver = _setup(lib)
    except OSError:
        return None
    if not _layout_holds(lib, solver):
        lib.osqp_cleanup(solver)
        return None
    lib.osqp_cold_start(solver)
    handle = new_handle(OSQP_NATIVE, lib.osqp_cleanup, solver)
    handle[WORKSPACE] = solver.value
    handle[MEMORY] = ctypes.cast(solver, ctypes.POINTER(_Solver)).contents.work
    for k, name in enumerate(_STEPS):
        handle[FUNCTIONS + k] = ctypes.cast(getattr(lib, name), _p).value
    return handle


@jit
def iterate(handle, H, g, lb, ub, x, n, state):
    """Up to MAX_ITERATIONS of ADMM from x. Writes state and x as `qp_state.adopt` does. Returns the
    iterations, negative on failure (x and state are then untouched)."""
    solver = handle[WORKSPACE]
    at_d, at_P, at_q = stack_floats(_N), stack_floats(UPPER_TRIANGLE), stack_floats(_N)
    at_l, at_u, at_s = stack_floats(_N), stack_floats(_N), stack_floats(_N)
    d, q, s = carray(at_d, (_N,)), carray(at_q, (_N,)), carray(at_s, (_N,))
    lower, upper = carray(at_l, (_N,)), carray(at_u, (_N,))
    scale(H, g, lb, ub, x, n, d, carray(at_P, (UPPER_TRIANGLE,)), q, lower, upper, s)
    error = call_7(handle[_UPDATE_MATRIX], solver, address_of(at_P), 0, UPPER_TRIANGLE, 0, 0, 0)
    if error == 0:
        error = call_4(handle[_UPDATE_VECTORS], solver, address_of(at_q), address_of(at_l), address_of(at_u))
    if error == 0:
        error = call_3(handle[_WARM_START], solver, address_of(at_s), 0)
    if error != 0:
        return -1
    work = carray(ints_at(handle[MEMORY]), (14,))
    steady, previous, k = 0, -1, 0
    while k < MAX_ITERATIONS and steady < STEADY_ITERATIONS:
        k += 1
        work[_AT_X], work[_AT_X_PREVIOUS] = work[_AT_X_PREVIOUS], work[_AT_X]
        work[_AT_Z], work[_AT_Z_PREVIOUS] = work[_AT_Z_PREVIOUS], work[_AT_Z]
        call_2(handle[_XZ], solver, k)
        call_1(handle[_X], solver)
        call_1(handle[_Z], solver)
        call_1(handle[_Y], solver)
        z = carray(floats_at(carray(ints_at(work[_AT_Z]), (1,))[0]), (_N,))
        pattern = 0
        for i in range(n):
            pattern = 3 * pattern + (0 if z[i] <= lower[i] else (2 if z[i] >= upper[i] else 1))
        steady = steady + 1 if pattern == previous else 0
        previous = pattern
        if k % RHO_INTERVAL == 0:
            call_3(handle[_INFO], solver, k, 0)
            if call_1(handle[_ADAPT], solver) != 0:
                return -k
    z = carray(floats_at(carray(ints_at(work[_AT_Z]), (1,))[0]), (_N,))
    y = carray(floats_at(carray(ints_at(work[_AT_Y]), (1,))[0]), (_N,))
    for i in range(n):
        if not (math.isfinite(z[i]) and math.isfinite(y[i])):
            call_1(handle[_COLD], solver)
            return -k
    adopt(d, lower, upper, z, lb, ub, x, n, state)
    return k
