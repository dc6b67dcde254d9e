"""Data that no QP can be made of: the answer stays inside its bounds and the status says why."""

import math

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS as N
from bumpless.contract.enums import BUDGET_SPENT, FALLBACK, INFEASIBLE, REFUSED, SOLVED
from bumpless.control.allocation.qp import SOLVERS, make_handle, solve_box_qp
from bumpless.control.allocation.qp_active_set import solve_active_set
from bumpless.control.allocation.qp_handle import OSQP_PUBLIC
from bumpless.control.allocation.qp_python import make_python_handle


def problem():
    """Optimum (1, -0.5, 0, ...): the first variable at its bound."""
    H = np.eye(N) * 2.0
    g = np.zeros(N)
    g[0], g[1] = -10.0, 1.0
    return H, g, -np.ones(N), np.ones(N), np.zeros(N)


@pytest.fixture(params=[s for s in SOLVERS if s != "daqp"])
def handle(request):
    return make_handle(request.param)


@pytest.mark.parametrize("field", ["H", "g", "lb", "ub"])
@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_not_a_number_is_refused(handle, field, value):
    """A NaN demand holds the start, moved inside the bounds that are left."""
    H, g, lb, ub, x = problem()
    data = {"H": H, "g": g, "lb": lb, "ub": ub}
    data[field].flat[1] = value
    if field == "ub" and math.isinf(value):
        assert solve_box_qp(handle, H, g, lb, ub, x, N) == SOLVED  # no bound is a bound
        return
    x[:] = [0.3, 0.4, 5.0, -5.0, 0, 0, 0, 0]
    assert solve_box_qp(handle, H, g, lb, ub, x, N) in (REFUSED, INFEASIBLE)
    assert np.isfinite(x[[0, 2, 3]]).all() and np.isfinite(x).all()
    assert x[0] == 0.3 and x[2] == 1.0 and x[3] == -1.0


def test_a_start_that_is_no_number_does_not_matter(handle):
    """NaN or infinite starts give the same optimum."""
    for value in (math.nan, math.inf, -math.inf, 1e300):
        H, g, lb, ub, x = problem()
        x[:] = value
        assert solve_box_qp(handle, H, g, lb, ub, x, N) == SOLVED
        np.testing.assert_allclose(x[:3], [1.0, -0.5, 0.0], atol=1e-12)


def test_contradicting_bounds(handle):
    """lb > ub: infeasible, and the start goes to the nearest point of the gap."""
    H, g, lb, ub, x = problem()
    lb[2], ub[2], x[2], x[3] = 0.5, 0.2, 0.9, 7.0
    assert solve_box_qp(handle, H, g, lb, ub, x, N) == INFEASIBLE
    assert x[2] == 0.5 and x[3] == 1.0


def test_equal_bounds_hold_exactly(handle):
    """A failed actuator is frozen by equal bounds; all of them frozen is a problem too."""
    H, g, lb, ub, x = problem()
    lb[0] = ub[0] = 0.123
    assert solve_box_qp(handle, H, g, lb, ub, x, N) == SOLVED
    assert x[0] == 0.123 and abs(x[1] + 0.5) < 1e-12
    lb[:] = ub[:] = 0.25
    assert solve_box_qp(handle, H, g, lb, ub, x, N) == SOLVED
    assert (x == 0.25).all()


def test_no_curvature(handle):
    """Without curvature the slope alone decides: to the bound, or nowhere."""
    x = np.full(N, 0.2)
    g = np.zeros(N)
    g[0], g[1] = 1.0, -1.0
    assert solve_box_qp(handle, np.zeros((N, N)), g, -np.ones(N), np.ones(N), x, N) == SOLVED
    assert x[0] == -1.0 and x[1] == 1.0
    assert (np.abs(x) <= 1.0).all()


def test_no_variables(handle):
    """n = 0 is solved."""
    assert solve_box_qp(handle, *problem(), 0) == SOLVED


def test_extreme_scales(handle):
    """Curvature from 1e-200 to 1e200 neither overflows into the answer nor leaves the bounds."""
    for scale in (1e-200, 1e-30, 1e30, 1e150):
        H, g, lb, ub, x = problem()
        status = solve_box_qp(handle, H * scale, g * scale, lb, ub, x, N)
        assert status == SOLVED
        np.testing.assert_allclose(x[:3], [1.0, -0.5, 0.0], atol=1e-12)
    rng = np.random.default_rng(5)
    for _ in range(300):
        d = 10.0 ** rng.uniform(-150, 150, size=N)
        G = rng.normal(size=(5, N))
        H = d[:, None] * (G.T @ G) * d + np.diag(d * d) * 1e-3
        g = rng.normal(size=N) * 10.0 ** rng.uniform(-150, 150, size=N)
        lb, x = -1.0 / d, rng.normal(size=N)
        assert solve_box_qp(handle, H, g, lb, -lb, x, N) in (SOLVED, BUDGET_SPENT, FALLBACK)
        assert (x >= lb).all() and (x <= -lb).all()


def test_a_copied_handle_is_not_trusted():
    """Its addresses may be stale: the built-in active set answers and says so."""
    H, g, lb, ub, x = problem()
    original = make_handle("osqp")
    copy = original.copy()
    del original
    assert solve_box_qp(copy, H, g, lb, ub, x, N) == FALLBACK
    np.testing.assert_allclose(x[:2], [1.0, -0.5])


def test_a_failing_solver_falls_back():
    """An exception or a failure in the Python solver ends in the active set's answer."""

    def broken(*_):
        raise RuntimeError("no")

    for handle in (make_python_handle(OSQP_PUBLIC, broken), make_python_handle(OSQP_PUBLIC, lambda *_: -1)):
        H, g, lb, ub, x = problem()
        assert solve_box_qp(handle, H, g, lb, ub, x, N) == FALLBACK
        np.testing.assert_allclose(x[:2], [1.0, -0.5])


def test_a_lying_solver_is_corrected():
    """A wrong iterate and wrong multipliers cost rounds, never the optimum."""

    def liar(P, q, lower, upper, x, y):
        x[:], y[:] = upper + 1.0, -1e3
        return 1

    H, g, lb, ub, x = problem()
    assert solve_box_qp(make_python_handle(OSQP_PUBLIC, liar), H, g, lb, ub, x, N) == SOLVED
    np.testing.assert_allclose(x[:3], [1.0, -0.5, 0.0], atol=1e-12)


def test_unknown_solver():
    """The message names the field, the value and the rule."""
    with pytest.raises(ValueError, match=r"allocation\.solver = 'ipopt'; must be one of"):
        make_handle("ipopt")


def test_fields_of_records():
    """Rows of records are strided views: they are accepted as they are."""
    H, g, lb, ub, _ = problem()
    block = np.zeros(3, dtype=[("x", float, N), ("lb", float, N), ("ub", float, N), ("g", float, N)])
    block["lb"], block["ub"], block["g"] = lb, ub, g
    x = block["x"][1]
    status, rounds = solve_active_set(H, block["g"][1], block["lb"][1], block["ub"][1], x, N)
    assert status == SOLVED and rounds >= 1
    np.testing.assert_allclose(x[:3], [1.0, -0.5, 0.0], atol=1e-12)
