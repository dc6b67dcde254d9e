"""Every solver choice finds the optimum of 10,000 random QPs: the allocator's accuracy rests on it."""

import importlib.util

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.contract.enums import SOLVED
from bumpless.control.allocation.kkt import kkt_residual
from bumpless.control.allocation.qp import make_handle, solve_box_qp
from bumpless.control.allocation.qp_handle import FIRST_ORDER, ITERATIONS
from bumpless.control.allocation.qp_python import make_osqp_handle
from bumpless.jit import jit
from tests.control.allocation.qp_problems import KINDS, cost, descended, enumerated, random_problem

PROBLEMS = 10_000
SOLVERS = ["active_set", "osqp", *(["daqp"] if importlib.util.find_spec("daqp") else [])]


@pytest.fixture(scope="module")
def problems():
    rng = np.random.default_rng(3)
    made = [random_problem(rng, KINDS[k % len(KINDS)]) for k in range(PROBLEMS)]
    return tuple(np.array([p[k] for p in made]) for k in range(6))


@pytest.fixture(scope="module")
def reference(problems):
    """Optimal costs: coordinate descent to standstill from the best point that any method knows."""
    H, g, lb, ub, x, n = (a.copy() for a in problems)
    for k in range(PROBLEMS):
        x[k, : n[k]] = np.clip(x[k, : n[k]], lb[k, : n[k]], ub[k, : n[k]])
        descended(H[k], g[k], lb[k], ub[k], x[k], n[k], 3000)
    return x


@jit
def solve_all(handle, H, g, lb, ub, x, n, status, rounds):
    for k in range(n.size):
        status[k] = solve_box_qp(handle, H[k], g[k], lb[k], ub[k], x[k], n[k])
        rounds[k] = handle[ITERATIONS]


def solved(handle, problems, count=PROBLEMS):
    H, g, lb, ub, x, n = (a[:count].copy() for a in problems)
    status, rounds = np.zeros(count, dtype=np.int64), np.zeros(count, dtype=np.int64)
    solve_all(handle, H, g, lb, ub, x, n, status, rounds)
    return x, status, rounds


@pytest.mark.parametrize("solver", SOLVERS)
def test_ten_thousand_problems(solver, problems, reference):
    """Saturated, narrow, rank-deficient, degenerate, badly scaled: optimal and inside the bounds."""
    x, status, _ = solved(make_handle(solver), problems)
    H, g, lb, ub, _, n = problems
    assert (status == SOLVED).mean() > 0.999
    used = np.arange(MAX_ACTUATORS) < n[:, None]
    assert (x >= lb)[used].all() and (x <= ub)[used].all()
    for k in range(PROBLEMS):
        span = max(abs(cost(H[k], g[k], reference[k], n[k])), 1e-12)
        assert cost(H[k], g[k], x[k], n[k]) <= cost(H[k], g[k], reference[k], n[k]) + 1e-9 * span, k
        assert kkt_residual(H[k], g[k], lb[k], ub[k], x[k], n[k]) < 1e-8, k


def test_against_enumeration(problems):
    """For up to four variables the optimum is the best of all combinations of active bounds."""
    x, _, _ = solved(make_handle("active_set"), problems, 1500)
    H, g, lb, ub, _, n = problems
    compared = 0
    for k in np.flatnonzero(n[:1500] <= 4):
        best = enumerated(H[k], g[k], lb[k], ub[k], n[k])
        assert cost(H[k], g[k], x[k], n[k]) <= cost(H[k], g[k], best, n[k]) + 1e-9 * (
            1e-9 + abs(cost(H[k], g[k], best, n[k]))
        )
        compared += 1
    assert compared > 500


def test_all_routes_give_the_same_answer(problems):
    """OSQP native, OSQP by its Python API, daqp and the active set agree to the last digits."""
    count = 600
    base, _, _ = solved(make_handle("active_set"), problems, count)
    for handle in (make_osqp_handle(), *(make_handle(s) for s in SOLVERS[1:])):
        x, status, _ = solved(handle, problems, count)
        assert (status == SOLVED).mean() > 0.99
        np.testing.assert_allclose(x, base, rtol=1e-9, atol=1e-9)


def test_a_warm_start_at_the_optimum_costs_one_round(problems):
    """A controller that has settled must not pay for the search again."""
    x, _, _ = solved(make_handle("active_set"), problems)
    H, g, lb, ub, _, n = problems
    again, _, rounds = solved(make_handle("active_set"), (H, g, lb, ub, x, n))
    assert np.mean(rounds == 1) > 0.98
    np.testing.assert_allclose(again, x, rtol=1e-9, atol=1e-9)


def test_osqp_does_the_work(problems):
    """The exact finish must not hide an OSQP that is never asked or never right."""
    handle = make_handle("osqp")
    H, g, lb, ub, x, n = (a.copy() for a in problems)
    solve_box_qp(handle, H[0], g[0], lb[0], ub[0], x[0], n[0])
    assert 1 <= handle[FIRST_ORDER] <= 10


def test_no_solver_is_asked_where_the_bounds_still_hold(problems):
    """Protects: a cycle with the bounds of the last pays for one factorisation, and gets the same bits."""
    handle = make_handle("osqp")
    x, _, _ = solved(handle, problems)
    H, g, lb, ub, _, n = problems
    again, _, rounds = solved(handle, (H, g, lb, ub, x, n))
    assert np.mean(rounds == 1) > 0.98
    bare, _, _ = solved(make_handle("active_set"), (H, g, lb, ub, x, n))
    assert np.array_equal(again[rounds == 1], bare[rounds == 1], equal_nan=True)
