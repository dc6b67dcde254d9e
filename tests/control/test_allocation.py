"""MD-CA: bounds, Jacobian, optimality, a stopped thruster, faults, and demands that make no sense."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.contract.enums import BUDGET_SPENT, REFUSED, SOLVED
from bumpless.control.allocation.bounds import command_bounds
from bumpless.control.allocation.mdca import allocate_mdca, allocation_cost
from bumpless.control.allocation.qp import make_handle
from bumpless.control.allocation.record import ALLOCATION_SETTINGS, ALLOCATION_WORK, PROBLEM, SOLUTION
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.physics.actuators import to_command, to_x

N = MAX_ACTUATORS
unit = st.floats(-1.0, 1.0)


class Posed:
    """A problem to be changed, its allocator, and the answer: `solve` goes on from the last command."""

    def __init__(self, model, surge=0.4, solver="active_set"):
        self.model, self.handle = model, make_handle(solver)
        self.settings, self.problem, self.solution, self.work = (
            np.zeros(1, kind)[0] for kind in (ALLOCATION_SETTINGS, PROBLEM, SOLUTION, ALLOCATION_WORK)
        )
        self.settings["sqp_iterations"], self.settings["kkt_tolerance"] = 6, 1e-6
        p = self.problem
        p["dt"], p["warm"], p["effectiveness"] = 0.05, 1, 1.0
        p["Q"], p["R"], p["lam"] = [1, 0, 2, 4, 4, 4], 1.0, 1e-3
        p["nu_flow"][0] = surge

    def solve(self):
        p, solution = self.problem, self.solution
        command_bounds(self.model, p["u_previous"], p["dt"], p["u_lower"], p["u_upper"], p["du_max"])
        allocate_mdca(self.handle, self.settings, self.model, p, solution, self.work)
        return solution

    def solve_on(self, cycles):
        """So many cycles, each from the command of the one before."""
        for _ in range(cycles):
            solution = self.solve()
            self.problem["u_previous"], self.problem["refused"] = solution["u"], solution["refused"]
        return self.solution


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
    posed = Posed(model, surge)
    p = posed.problem
    p["u_previous"][:7] = np.array(u) * model["command_max"][:7]
    p["tau_d"] = np.array(tau_d) * model["controllable"]
    before = p["u_previous"]
    x0 = np.array([to_x(model, i, before[i]) for i in range(7)] + [0.0])
    tau, J = np.zeros(6), np.zeros((6, N))
    wrench_map(model, x0, before, p["effectiveness"], p["nu_flow"], tau, J)
    start = allocation_cost(p["Q"], p["R"], p["lam"], p["tau_d"], tau, x0, 7)
    found = posed.solve()
    assert (found["u"] >= p["u_lower"] - 1e-12).all() and (found["u"] <= p["u_upper"] + 1e-12).all()
    assert found["cost"] <= start + 1e-12 and found["status"] in (SOLVED, BUDGET_SPENT)


def test_a_stopped_thruster_starts(model):
    """Protects: the thrust variable: T ~ n|n| has no slope at n = 0, yet Gauss-Newton must leave it."""
    posed = Posed(model, 0.0)
    p = posed.problem
    p["tau_d"][0] = 2.0
    u = posed.solve_on(60)["u"]
    tau, J = np.zeros(6), np.zeros((6, N))
    x = np.array([to_x(model, i, u[i]) for i in range(7)] + [0.0])
    wrench_map(model, x, u, p["effectiveness"], p["nu_flow"], tau, J)
    assert tau[0] == pytest.approx(2.0, abs=0.05)


def test_affine_map_is_solved_in_one_iteration(model):
    """Protects: the paper's statement that the SQP recovers the convex QP when G is affine (fins at rest)."""
    posed = Posed(model, 0.0)
    posed.problem["tau_d"][:] = [0.1, 0, 0.05, 0.01, 0, 0]
    found = posed.solve()
    assert found["iterations"] == 1 and found["status"] == SOLVED


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_a_demand_that_is_no_number_is_refused(model, bad):
    """Protects: the last command is held within its bounds and the status says so."""
    posed = Posed(model)
    p = posed.problem
    p["u_previous"][:7] = 0.1
    p["tau_d"][2] = bad
    before = p["u_previous"].copy()
    found = posed.solve_on(1)
    assert found["status"] == REFUSED and (found["u"] == before).all()
    found = posed.solve_on(60)
    assert found["status"] == REFUSED and not found["u"].any()  # it does not drive on blindly
    p["tau_d"][2] = 0.1
    found = posed.solve_on(1)
    assert found["status"] != REFUSED and found["refused"] == 0


def test_a_command_outside_its_amplitude_comes_back_by_its_increment(model):
    """Protects: contradicting bounds: the increment bound wins, the command moves towards its amplitude."""
    u = np.zeros(N)
    u[0] = model["command_max"][0] + 0.3
    lower, upper, du = np.zeros(N), np.zeros(N), np.zeros(N)
    assert not command_bounds(model, u, 0.05, lower, upper, du)
    assert lower[0] == upper[0] == pytest.approx(u[0] - du[0])


@pytest.mark.parametrize("solver", ["active_set", "osqp"])
def test_solvers_agree_on_a_flight_of_demands(model, solver):
    """Protects: whichever solver the operator chooses, the commands are the same optimum."""
    rng = np.random.default_rng(5)
    ours, exact = Posed(model, solver=solver), Posed(model)
    for _ in range(300):
        tau_d = rng.normal(0, [1.5, 0, 0.6, 0.3, 2, 2])
        for posed in (ours, exact):
            posed.problem["tau_d"] = tau_d
            posed.solve()
        assert ours.solution["cost"] == pytest.approx(exact.solution["cost"], rel=1e-4, abs=1e-7)
        ours.problem["u_previous"] = exact.problem["u_previous"] = exact.solution["u"]


def test_a_dead_actuator_is_left_alone_and_the_others_take_over(model):
    """Protects: the degraded map: with one vertical dead the other heaves, the fins hold the roll."""
    posed = Posed(model, 0.7)
    posed.problem["effectiveness"][5] = 0.0
    posed.problem["tau_d"][2] = 0.3
    u = posed.solve_on(80)["u"]
    assert abs(u[5]) < 0.05 * model["command_max"][5]
    assert u[6] > 0.3 * model["command_max"][6]
