"""MD-CA, whichever solver answers its QPs, on 10,000 random problems against a tight reference optimum."""

import importlib.util

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import BUDGET_SPENT, REFUSED, SOLVED
from bumpless.control.allocation.curvature import descent_curvature, residual_curvature
from bumpless.control.allocation.mdca import allocate_mdca
from bumpless.control.allocation.qp import make_handle
from bumpless.control.allocation.record import ALLOCATION_WORK, PROBLEM, SOLUTION
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.control.settings import SETTINGS
from bumpless.physics.actuators import FIN, to_command
from bumpless.physics.actuators.fin import STALL_WIDTH
from bumpless.physics.actuators.geometry import inflow_along
from bumpless.sim.settings import fill_settings
from bumpless.sim.twin import one
from tests.bench import stream
from tests.control.allocation.mdca_problems import KINDS, random_problems

PROBLEMS = 10_000
SOLVERS = ["active_set", "osqp", *(["daqp"] if importlib.util.find_spec("daqp") else [])]
N = MAX_ACTUATORS


@pytest.fixture(scope="module")
def ts100():
    return load_vehicle("ts100")


@pytest.fixture(scope="module")
def model(ts100):
    return stream.model_of(ts100)


@pytest.fixture(scope="module")
def problems(model):
    return random_problems(model, PROBLEMS, 1)


def chosen(ts100):
    """ALLOCATION_SETTINGS as the vehicle flies with."""
    settings = one(SETTINGS)[0]
    fill_settings(settings, ts100, default_parameters(ts100))
    return settings["allocation"]


def answered(ts100, model, problems, solver):
    """(costs, commands (k, 8), statuses) of the allocator as it flies."""
    settings, solution, w = chosen(ts100), one(SOLUTION)[0], one(ALLOCATION_WORK)[0]
    handle, unused = make_handle(solver), np.zeros((3, 1))
    cost, u, status = np.zeros(len(problems)), np.zeros((len(problems), N)), np.zeros(len(problems), int)
    for k in range(len(problems)):
        stream.replay(handle, settings, model, problems[k : k + 1], solution, w, *unused)
        cost[k], u[k], status[k] = unused[0, 0], solution["u"], solution["status"]
    return cost, u, status


@pytest.fixture(scope="module")
def reference(ts100, model, problems):
    """Answers by the bare active set; the least cost from there, the last command, rest and elsewhere."""
    cost, u, status = answered(ts100, model, problems, "active_set")
    posed, best = problems.copy(), np.zeros(PROBLEMS)
    posed["u"] = u
    stream.tight_optimum(model, posed, np.random.default_rng(0).random((1, N)), best)
    return cost, u, status, best


@pytest.mark.parametrize("solver", SOLVERS)
def test_ten_thousand_problems(ts100, model, problems, reference, solver):
    """Protects: commands inside their bounds and at the optimum, for saturated demands, no flow, reversed
    flow, dead and weak actuators, last commands outside their amplitude and commands that cannot move."""
    bare, bare_u, bare_status, best = reference
    if solver == "active_set":
        cost, u, status = bare, bare_u, bare_status
    else:
        cost, u, status = answered(ts100, model, problems, solver)
    n = int(model["n_u"])
    assert (u[:, :n] >= problems["u_lower"][:, :n]).all() and (u[:, :n] <= problems["u_upper"][:, :n]).all()
    assert np.isin(status, (SOLVED, BUDGET_SPENT)).all()
    gap = (cost - best) / (best + 1e-9)
    for j, kind in enumerate(KINDS):
        part = slice(j, None, len(KINDS))
        assert (status[part] == SOLVED).mean() > 0.98, kind
        assert np.median(gap[part]) < 1e-9, kind
        assert (gap[part] > 0.01).mean() < 0.01, kind  # other valleys of a cost that is not convex
        assert gap[part].max() < 0.2, kind
    np.testing.assert_allclose(np.median(np.abs(cost - bare) / (bare + 1e-9)), 0.0, atol=1e-12)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_demand_that_is_no_number_is_refused_by_every_solver(ts100, model, problems, solver, bad):
    """Protects: the last command is held within its bounds, and the status says so."""
    posed = problems[:1].copy()
    posed["tau_d"][0, 0] = bad
    _, u, status = answered(ts100, model, posed, solver)
    held = np.clip(posed["u_previous"][0], posed["u_lower"][0], posed["u_upper"][0])
    assert status[0] == REFUSED
    np.testing.assert_array_equal(u[0], held)


def test_second_order_term_equals_finite_differences(model, problems):
    """Protects: the fins' curvature, attached, stalled and in between, in flow from any side."""
    n, rng = int(model["n_u"]), np.random.default_rng(4)
    up, down, J_up, J_down, out = np.zeros(6), np.zeros(6), np.zeros((6, N)), np.zeros((6, N)), np.zeros(N)
    coupling, h = np.zeros(N), 1e-6
    for p in problems[:400]:
        x, weight = np.zeros(N), rng.normal(size=6)
        x[:n] = rng.uniform(-1, 1, n)
        residual_curvature(model, x, p["u_previous"], p["effectiveness"], p["nu_flow"], weight, out, coupling)
        assert not coupling.any()  # each of these actuators has one command
        for i in range(n):
            step = np.zeros(N)
            step[i] = h
            wrench_map(model, x + step, p["u_previous"], p["effectiveness"], p["nu_flow"], up, J_up)
            wrench_map(model, x - step, p["u_previous"], p["effectiveness"], p["nu_flow"], down, J_down)
            if (up == down).all():
                continue
            slope = -weight @ (J_up[:, i] - J_down[:, i]) / (2 * h)
            if model["kind"][i] == FIN and abs(slope - out[i]) > 1e-3 * (1 + abs(slope)):
                # G'' jumps where stall begins and ends: a difference across the jump is no derivative
                assert _near_a_jump(model, i, x[i], p["nu_flow"]), (i, slope, out[i])


def _near_a_jump(model, i, x, nu_r):
    e = model["direction"][i]
    u, v = inflow_along(model, i, nu_r, 1.0, 0.0, 0.0), inflow_along(model, i, nu_r, e[0], e[1], e[2])
    alpha = x * model["command_max"][i] - np.arctan2(v, u)
    alpha = abs((alpha + np.pi / 2) % np.pi - np.pi / 2)
    stall = model["stall_angle"][i]
    return min(abs(alpha - stall), abs(alpha - stall - STALL_WIDTH), abs(alpha - np.pi / 2)) < 1e-5


def test_a_direction_of_negative_curvature_is_one():
    """Protects: the way out of a saddle, and that a positive definite matrix is known as one."""
    rng, z = np.random.default_rng(7), np.zeros(N)
    found = 0
    for _ in range(500):
        G = rng.normal(size=(5, N))
        H, curvature, coupling = G.T @ G + 1e-3 * np.eye(N), rng.normal(0.0, 0.5, N), np.zeros(N)
        coupling[[0, 3]] = rng.normal(0.0, 0.5, 2)
        C = np.diag(curvature) + np.diag(coupling[:-1], 1) + np.diag(coupling[:-1], -1)
        free = (rng.random(N) < 0.7).astype(np.int64)
        inside = np.flatnonzero(free)
        full = (H + C)[np.ix_(inside, inside)]
        convex = descent_curvature(H, curvature, coupling, free, N, z)
        assert convex == (np.linalg.eigvalsh(full)[0] > 0.0 if len(inside) else True)
        if not convex:
            found += 1
            assert z @ (H + C) @ z < 0.0 and not z[free == 0].any()
    assert found > 100


def test_fins_brake_where_the_screw_alone_cannot(ts100, model):
    """Protects: at rest the fins are a saddle of the cost for want of drag; Gauss-Newton stays on it.

    Where fins may brake at all (`allocation.fins_brake`), as in the published scenarios.
    """
    model = np.array([model])[0]
    model["fins_coast"] = 0
    p, solution, w, n = one(PROBLEM)[0], one(SOLUTION)[0], one(ALLOCATION_WORK)[0], int(model["n_u"])
    p["warm"], p["dt"] = 1, 0.05
    p["nu_flow"][0], p["effectiveness"], p["Q"], p["R"], p["lam"] = (
        0.7,
        1.0,
        model["controllable"],
        0.01,
        1e-3,
    )
    p["tau_d"][0] = -1.0
    p["u_lower"][:n], p["u_upper"][:n] = -0.3 * model["command_max"][:n], 0.3 * model["command_max"][:n]
    propeller = int(np.argmax((model["T_nn"][:n] > 0.0) * np.abs(model["direction"][:n, 0])))
    p["u_lower"][propeller] = p["u_upper"][propeller] = to_command(model, propeller, 0.0)
    allocate_mdca(make_handle("osqp"), chosen(ts100), model, p, solution, w)
    fins = np.flatnonzero(model["kind"][:n] == FIN)
    assert (np.abs(solution["u"][fins]) > 0.25 * model["command_max"][fins]).all()
    assert abs(p["tau_d"][3:] - w["tau"][3:]).max() < 0.05  # against each other: drag without a moment
