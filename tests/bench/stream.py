"""The allocation problems of flown missions, our allocator on them, and their tight optimum."""

from pathlib import Path

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.mission import Mission, parse_mission
from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import REFUSED, RUNNING
from bumpless.control.allocation.mdca import allocate_mdca, allocation_cost, normal_equations
from bumpless.control.allocation.qp_active_set import solve_active_set
from bumpless.control.allocation.record import PROBLEM
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.jit import allocating, jit
from bumpless.jit.clock import monotonic
from bumpless.physics.actuators import to_x
from bumpless.sim.twin import Twin
from tests.bench.cpu_clock import thread_time

ROOT = Path(__file__).parents[2]
_POSED = [(name, PROBLEM[name]) for name in PROBLEM.names or ()]
ROW = np.dtype([*_POSED, ("mode", "i8"), ("u", "f8", MAX_ACTUATORS)], align=True)  # a problem and its answer


def missions(vehicle: Vehicle) -> list[Mission]:
    """The six scenarios where they exist, the docking missions otherwise; without solver overrides."""
    folder = ROOT / "missions"
    files = sorted(folder.glob("s[1-6]*.yaml"))
    files = files if len(files) >= 6 else sorted(folder.glob("docking*.yaml"))
    return [parse_mission(f.read_text(encoding="utf-8"), f.name, vehicle) for f in files]


def model_of(vehicle: Vehicle) -> np.void:
    """What the autopilot of `vehicle` works on in the last of these missions; its fins may brake."""
    twin = Twin(vehicle)
    twin.start(missions(vehicle)[-1])
    return twin.onboard["model"]


def record(vehicle: Vehicle, mission: Mission) -> np.ndarray:
    """ROWs, one per control cycle of `mission`, as the autopilot posed them; u is its answer.
    What easing missed and the price on increments are left out: the peers know neither.

    Empty for missions that are flown with another allocator than MD-CA.
    """
    twin = Twin(vehicle)
    twin.start(mission)
    if twin.parameters.allocation.allocator != "mdca":
        return np.zeros(0, ROW)
    state, out = twin.onboard["state"], twin.onboard["output"]
    rows = np.zeros(int(mission.duration_s / twin.period_s), ROW)
    for count, row in enumerate(rows):
        if twin.phase != RUNNING or out["solution"]["status"] == REFUSED:
            return rows[:count]
        twin.step()
        for name, _ in _POSED:
            row[name] = out["problem"][name]
        row["tau_d"], row["increment_price"] = state["switching"]["now"]["tau_d"], 0.0
        row["u"], row["mode"] = state["allocation"]["u"], state["supervisor"]["mode"]
    return rows


@jit
def replay(handle, settings, model, problems, solution, w, cost, cpu, wall):
    """Allocate each problem by MD-CA as flown, without the rest of the cycle.

    settings: ALLOCATION_SETTINGS. Fills cost, CPU seconds of this thread and wall seconds, one a problem.
    """
    for k in range(problems.shape[0]):
        wall_began, cpu_began = monotonic(), thread_time()  # pyright: ignore[reportCallIssue]
        allocate_mdca(handle, settings, model, problems[k], solution, w)
        cpu[k] = thread_time() - cpu_began
        wall[k] = monotonic() - wall_began  # pyright: ignore[reportCallIssue]
        cost[k] = solution.cost


@jit
def cost_at(model, p, x, tau, jacobian):
    """Cost of problem `p` at x, with tau and jacobian filled."""
    wrench_map(model, x, p.u_previous, p.effectiveness, p.nu_flow, tau, jacobian)
    return allocation_cost(p.Q, p.R, p.lam, p.tau_d, tau, x, model.n_u)


@jit
def bounds_of(model, p, lower, upper):
    """Bounds of problem `p` in the decision variables."""
    for i in range(model.n_u):
        lower[i], upper[i] = to_x(model, i, p.u_lower[i]), to_x(model, i, p.u_upper[i])


@jit
def _polish(model, p, lower, upper, x, tau, J, H, g, step, lb, ub, trial):
    """Many accepted Gauss-Newton steps, then a compass search down to 1e-6: a tight local optimum."""
    n = model.n_u
    cost = cost_at(model, p, x, tau, J)
    for _ in range(60):
        normal_equations(p.Q, p.R, p.lam, p.tau_d, tau, J, x, n, H, g)
        for i in range(n):
            step[i], lb[i], ub[i] = 0.0, lower[i] - x[i], upper[i] - x[i]
        solve_active_set(H, g, lb, ub, step, n)
        eta, gain = 1.0, 0.0
        while eta > 1e-8 and gain <= 0.0:
            for i in range(n):
                trial[i] = min(max(x[i] + eta * step[i], lower[i]), upper[i])
            gain = cost - cost_at(model, p, trial, tau, J)
            eta *= 0.5
        if gain <= 0.0:
            break
        cost -= gain
        for i in range(n):
            x[i] = trial[i]
        if gain < 1e-13 * cost:
            break
    reach = 0.05
    while reach > 1e-6:
        moved = False
        for i in range(2 * n):
            j, side = i // 2, reach if i % 2 == 0 else -reach
            before = x[j]
            x[j] = min(max(before + side, lower[j]), upper[j])
            there = cost_at(model, p, x, tau, J)
            if there < cost:
                cost, moved = there, True
            else:
                x[j] = before
        if not moved:
            reach *= 0.5
    return cost


@allocating
def tight_optimum(model, problems, starts, best):
    """best (len(problems),): least cost found from the answer, the last command, rest and `starts` (s, 8)."""
    tau, J, H = np.zeros(6), np.zeros((6, 8)), np.zeros((8, 8))
    g, step, lb, ub, trial = np.zeros(8), np.zeros(8), np.zeros(8), np.zeros(8), np.zeros(8)
    x, lower, upper = np.zeros(8), np.zeros(8), np.zeros(8)
    for k in range(problems.shape[0]):
        p = problems[k]
        bounds_of(model, p, lower, upper)
        best[k] = np.inf
        for s in range(3 + starts.shape[0]):
            for i in range(model.n_u):
                v = 0.0
                if s == 0:
                    v = to_x(model, i, p.u[i])
                elif s == 1:
                    v = to_x(model, i, p.u_previous[i])
                elif s > 2:
                    v = lower[i] + starts[s - 3, i] * (upper[i] - lower[i])
                x[i] = min(max(v, lower[i]), upper[i])
            best[k] = min(best[k], _polish(model, p, lower, upper, x, tau, J, H, g, step, lb, ub, trial))
