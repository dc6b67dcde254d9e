"""MD-CA: bounds, Jacobian, optimality, a stopped thruster, faults, and demands that make no sense."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bumpless import records
from bumpless.control.allocation.bounds import command_bounds
from bumpless.control.allocation.mdca import allocate_mdca, allocation_cost
from bumpless.control.allocation.qp import make_handle
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.physics.actuators import to_command, to_x

N = records.MAX_ACTUATORS
unit = st.floats(-1.0, 1.0)


def new_autopilot(model, surge=0.4):
    s, a, w = (np.zeros(1, d)[0] for d in (records.SETTINGS, records.AUTOPILOT, records.ALLOCATION_WORK))
    s["dt"], s["project"], s["sqp_iterations"], s["kkt_tolerance"] = 0.05, 1, 6, 1e-6
    a["Q"], a["R"], a["lam"] = [1, 0, 2, 4, 4, 4], 1.0, 1e-3
    a["nu_r"][0] = surge
    a["effectiveness"] = 1.0
    return s, a, w


def allocate(handle, s, model, a, w):
    command_bounds(model, a["u"].copy(), s["dt"], a["u_lower"], a["u_upper"], a["du_max"])
    allocate_mdca(handle, s, model, a, w)


@settings(deadline=None)
@given(st.lists(unit, min_size=N, max_size=N), st.lists(st.floats(-0.8, 0.8), min_size=6, max_size=6))
def test_jacobian_equals_finite_differences(model, x, nu):
    """Protects: the analytic Jacobian of G_m, away from the kink where a screw reverses."""
    x, nu = np.array(x), np.array(nu)
    x = np.where(np.abs(x) < 1e-3, 0.01, x)
    previous, healthy = np.full(N, 1.0), np.full(N, 0.8)
    tau, J, up, down, scratch = np.zeros(6), np.zeros((6, N)), np.zeros(6), np.zeros(6), np.zeros((6, N))
    wrench_map(model, x, previous, healthy, nu, tau, J)
    h = 1e-6
    for i in range(int(model["n_u"])):
        step = np.zeros(N)
        step[i] = h
        wrench_map(model, x + step, previous, healthy, nu, up, scratch)
        wrench_map(model, x - step, previous, healthy, nu, down, scratch)
        np.testing.assert_allclose((up - down) / (2 * h), J[:, i], atol=2e-4 * (1 + np.abs(J[:, i]).max()))


@given(unit, st.integers(0, 6))
def test_normalised_commands_invert(model, x, i):
    """Protects: x -> command -> x, so that bounds in x are exact images of bounds in deg and rpm."""
    assert to_x(model, i, to_command(model, i, x)) == pytest.approx(x, abs=1e-12)


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.floats(-30, 30), min_size=6, max_size=6),
    st.lists(unit, min_size=7, max_size=7),
    st.floats(-0.8, 0.8),
)
def test_any_demand_stays_inside_the_bounds_and_never_costs_more_than_doing_nothing(model, tau_d, u, surge):
    """Protects: feasibility in every cycle and step acceptance, saturated demands included."""
    s, a, w = new_autopilot(model, surge)
    a["u"][:7] = np.array(u) * model["command_max"][:7]
    a["tau_d"] = np.array(tau_d) * model["controllable"]
    before = a["u"].copy()
    x0 = np.array([to_x(model, i, before[i]) for i in range(7)] + [0.0])
    tau, J = np.zeros(6), np.zeros((6, N))
    wrench_map(model, x0, before, a["effectiveness"], a["nu_r"], tau, J)
    start = allocation_cost(a["Q"], a["R"], a["lam"], a["tau_d"], tau, x0, 7)
    allocate(make_handle("active_set"), s, model, a, w)
    assert (a["u"] >= a["u_lower"] - 1e-12).all() and (a["u"] <= a["u_upper"] + 1e-12).all()
    assert a["cost"] <= start + 1e-12 and a["status"] in (1, 2)


def test_a_stopped_thruster_starts(model):
    """Protects: the thrust variable: T ~ n|n| has no slope at n = 0, yet Gauss-Newton must leave it."""
    s, a, w = new_autopilot(model, 0.0)
    a["tau_d"][0] = 2.0
    handle = make_handle("active_set")
    for _ in range(60):
        allocate(handle, s, model, a, w)
    tau, J = np.zeros(6), np.zeros((6, N))
    x = np.array([to_x(model, i, a["u"][i]) for i in range(7)] + [0.0])
    wrench_map(model, x, a["u"], a["effectiveness"], a["nu_r"], tau, J)
    assert tau[0] == pytest.approx(2.0, abs=0.05)


def test_affine_map_is_solved_in_one_iteration(model):
    """Protects: the paper's statement that the SQP recovers the convex QP when G is affine (fins at rest)."""
    s, a, w = new_autopilot(model, 0.0)
    a["tau_d"][:] = [0.1, 0, 0.05, 0.01, 0, 0]
    allocate(make_handle("active_set"), s, model, a, w)
    assert a["iterations"] == 1 and a["status"] == 1


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_a_demand_that_is_no_number_is_refused(model, bad):
    """Protects: the last command is held within its bounds and the status says so."""
    s, a, w = new_autopilot(model)
    a["u"][:7] = 0.1
    a["tau_d"][2] = bad
    before = a["u"].copy()
    allocate(make_handle("active_set"), s, model, a, w)
    assert a["status"] == 5 and (a["u"] == before).all()
    for _ in range(60):
        allocate(make_handle("active_set"), s, model, a, w)
    assert a["status"] == 5 and not a["u"].any()  # it does not drive on blindly
    a["tau_d"][2] = 0.1
    allocate(make_handle("active_set"), s, model, a, w)
    assert a["status"] != 5 and a["refused"] == 0


def test_a_command_outside_its_amplitude_comes_back_by_its_increment(model):
    """Protects: contradicting bounds: the increment bound wins, the command moves towards its amplitude."""
    _, a, _ = new_autopilot(model)
    a["u"][0] = model["command_max"][0] + 0.3
    lower, upper, du = np.zeros(N), np.zeros(N), np.zeros(N)
    assert not command_bounds(model, a["u"], 0.05, lower, upper, du)
    assert lower[0] == upper[0] == pytest.approx(a["u"][0] - du[0])


@pytest.mark.parametrize("solver", ["active_set", "osqp"])
def test_solvers_agree_on_a_flight_of_demands(model, solver):
    """Protects: whichever solver the operator chooses, the commands are the same optimum."""
    rng = np.random.default_rng(5)
    s, a, w = new_autopilot(model)
    reference = new_autopilot(model)
    exact, handle = make_handle("active_set"), make_handle(solver)
    for _ in range(300):
        tau_d = rng.normal(0, [1.5, 0, 0.6, 0.3, 2, 2])
        for h, (ss, aa, ww) in ((handle, (s, a, w)), (exact, reference)):
            aa["tau_d"] = tau_d
            allocate(h, ss, model, aa, ww)
        assert a["cost"] == pytest.approx(reference[1]["cost"], rel=1e-4, abs=1e-7)
        a["u"] = reference[1]["u"]


def test_a_dead_actuator_is_left_alone_and_the_others_take_over(model):
    """Protects: the degraded map: with one vertical dead the other heaves, the fins hold the roll."""
    s, a, w = new_autopilot(model, 0.7)
    a["effectiveness"][5] = 0.0
    a["tau_d"][2] = 0.3
    handle = make_handle("active_set")
    for _ in range(80):
        allocate(handle, s, model, a, w)
    assert abs(a["u"][5]) < 0.05 * model["command_max"][5]
    assert a["u"][6] > 0.3 * model["command_max"][6]
