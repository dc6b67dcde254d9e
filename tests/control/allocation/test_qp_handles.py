"""Handles: one per thread, freed with the last reference, made anew in each process, quiet to signals."""

import gc
import os
import resource
import signal
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from bumpless.contract.enums import SOLVED
from bumpless.control.allocation import osqp_native, qp, qp_python
from bumpless.control.allocation.qp import make_handle, route, solve_box_qp
from bumpless.control.allocation.qp_active_set import solve_active_set
from bumpless.control.allocation.qp_handle import ACTIVE_SET, OSQP_PUBLIC, SOLVER
from bumpless.jit import jit
from tests.control.allocation.qp_problems import random_problem

ROOT = Path(__file__).parents[3]


def batch(seed, count=400):
    rng = np.random.default_rng(seed)
    made = [random_problem(rng, "plain") for _ in range(count)]
    return tuple(np.array([p[k] for p in made]) for k in range(6))


@jit
def solve_often(handle, H, g, lb, ub, x, n, times):
    good = 0
    for _ in range(times):
        for k in range(n.size):
            good += solve_box_qp(handle, H[k], g[k], lb[k], ub[k], x[k], n[k]) == SOLVED
    return good


def test_threads_with_their_own_handles():
    """Four threads without the GIL get what one gets; SIGINT still reaches Python afterwards.

    osqp_solve itself replaces the handler through one static variable, and loses it here."""
    before = signal.getsignal(signal.SIGINT)
    problems = [batch(seed) for seed in range(4)]
    expected = [p[4].copy() for p in problems]
    for p, x in zip(problems, expected, strict=True):
        for k in range(x.shape[0]):
            solve_active_set(p[0][k], p[1][k], p[2][k], p[3][k], x[k], p[5][k])
    good = [0] * 4

    def work(i):
        good[i] = solve_often(make_handle("osqp"), *problems[i], 20)

    solve_often(make_handle("osqp"), *batch(9, 2), 1)  # compile before the threads start
    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert good == [400 * 20] * 4
    for p, x in zip(problems, expected, strict=True):
        np.testing.assert_allclose(p[4], x, atol=1e-9)
    caught = []
    signal.signal(signal.SIGINT, lambda *_: caught.append(1))
    try:
        solve_often(make_handle("osqp"), *problems[0], 1)
        signal.raise_signal(signal.SIGINT)
    finally:
        signal.signal(signal.SIGINT, before)
    assert caught == [1]


def test_handles_are_freed():
    """Thousands of handles leave no workspace behind: a server makes one for each preview."""

    def churn(count):
        for _ in range(count):
            make_handle("osqp")
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # kB; bytes on macOS, then stricter

    churn(500)
    before = churn(10)
    assert churn(2000) - before < 4000  # one workspace takes about 15 kB
    alive = len(qp_python._alive)
    handle = qp_python.make_osqp_handle()
    assert len(qp_python._alive) == alive + 1
    del handle
    gc.collect()
    assert len(qp_python._alive) == alive


@pytest.fixture
def fresh_choice():
    """Let the choice of the route be made again, before and after."""
    qp._osqp_maker.cache_clear()
    osqp_native.library.cache_clear()
    yield
    qp._osqp_maker.cache_clear()
    osqp_native.library.cache_clear()


def test_the_locked_osqp_is_called_natively(fresh_choice):
    """The version that the lock file installs is the one whose layout is known."""
    if sys.platform == "linux":
        assert route() == "native"


def test_another_osqp_is_used_by_its_python_api(fresh_choice, monkeypatch):
    """Unknown version, missing symbols or a missing file: the public API, without any setting."""
    monkeypatch.setattr(osqp_native, "KNOWN_VERSIONS", (b"9.9.9",))
    assert route() == "public"
    assert make_handle("osqp")[SOLVER] == OSQP_PUBLIC


def test_a_changed_layout_is_noticed(fresh_choice, monkeypatch):
    """Iterates that are not where this code looks for them: not native."""
    monkeypatch.setattr(osqp_native, "_AT_X", osqp_native._AT_Y)
    assert osqp_native.make_native_handle() is None
    monkeypatch.undo()
    monkeypatch.setitem(osqp_native._DEFAULTS, "max_iter", 4001)
    osqp_native.library.cache_clear()
    assert osqp_native.library() is None


def test_without_osqp_the_active_set_answers(fresh_choice, monkeypatch):
    """No OSQP at all: simulations still run, and `route` says how."""

    def missing():
        raise ImportError("osqp")

    monkeypatch.setattr(osqp_native, "make_native_handle", lambda: None)
    monkeypatch.setattr(qp_python, "make_osqp_handle", missing)
    assert route() == "active_set"
    assert make_handle("osqp")[SOLVER] == ACTIVE_SET


PROBE = """
import numpy as np
from bumpless.control.allocation.qp import make_handle, solve_box_qp
x = np.zeros(8)
status = solve_box_qp(make_handle("osqp"), np.eye(8), np.full(8, 3.0), -np.ones(8), np.ones(8), x, 7)
assert status == 1 and (x[:7] == -1.0).all() and x[7] == 0.0
stats = solve_box_qp.stats
print(sum(stats.cache_hits.values()), sum(stats.cache_misses.values()))
"""


def test_compiled_code_is_cached_across_processes(tmp_path):
    """A second process loads the machine code and uses its own addresses in it."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(ROOT)}
    counts = []
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, "-c", PROBE], env=environment, capture_output=True, text=True, check=True
        )
        counts.append(tuple(int(v) for v in done.stdout.split()))
    assert counts == [(0, 1), (1, 0)]


def test_import_twin_stays_light():
    """`import twin` loads neither numba nor osqp nor SciPy."""
    code = "import sys, twin; print([m for m in ('numba', 'osqp', 'scipy', 'daqp') if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == "[]"
