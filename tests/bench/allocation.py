"""Rows about the allocator, all on one stream of problems recorded from flown missions."""

import time
from collections.abc import Iterator
from typing import Any

import numpy as np

from bumpless.config.vehicle import Vehicle
from bumpless.control.allocation.qp import make_handle
from bumpless.control.allocation.record import ALLOCATION_WORK, SOLUTION
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.control.settings import SETTINGS
from bumpless.physics.actuators import to_x
from bumpless.sim.settings import fill_settings
from bumpless.sim.twin import one, parameters_for
from tests.bench import stream
from tests.bench.figure import Figure, figure, interleaved
from tests.bench.generic_map import numpy_operations, parts, wrench
from tests.bench.nlp_peers import PEERS, Solve

SAMPLE = 100  # problems a round for peers in Python, spread over the stream


class Ours:
    """Our allocator on the stream."""

    def __init__(self, vehicle: Vehicle, problems: np.ndarray, solver: str) -> None:
        self.model, self.problems = stream.model_of(vehicle), problems
        settings = one(SETTINGS)[0]
        fill_settings(settings, vehicle, parameters_for(vehicle, None))
        self.settings, self.handle = settings["allocation"], make_handle(solver)
        self.solution, self.w = one(SOLUTION)[0], one(ALLOCATION_WORK)[0]
        self.cost, self.cpu, self.wall = np.zeros((3, len(problems)))
        self.run()

    def run(self) -> None:
        """All problems, in one compiled loop."""
        self._replay(slice(None))

    def run_one(self, k: int) -> None:
        """Problem k alone."""
        self._replay(slice(k, k + 1))

    def _replay(self, part: slice) -> None:
        out = self.cost[part], self.cpu[part], self.wall[part]
        stream.replay(
            self.handle, self.settings, self.model, self.problems[part], self.solution, self.w, *out
        )


def suboptimality(cost: np.ndarray, best: np.ndarray) -> np.ndarray:
    """Relative excess over the least cost that anyone found."""
    least = np.minimum(best, cost)
    return (cost - least) / (least + 1e-9)


def start_of(model: np.void, p: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(projected start, lower, upper) of a problem in the decision variables, (n,) each."""
    n = int(model["n_u"])
    lower = np.array([to_x(model, i, p["u_lower"][i]) for i in range(n)])
    upper = np.array([to_x(model, i, p["u_upper"][i]) for i in range(n)])
    before = np.array([to_x(model, i, p["u_previous"][i]) for i in range(n)])
    return np.clip(before, lower, upper), lower, upper


def check_generic_map(model: np.void, problems: np.ndarray) -> None:
    """The peers' map and ours must be the same, or the comparison means nothing."""
    ops, m, tau, J = numpy_operations(), parts(model), np.zeros(6), np.zeros((6, 8))
    rng = np.random.default_rng(2)
    for p in problems[:: max(1, len(problems) // 50)]:
        x = np.append(rng.uniform(-1, 1, m.n), np.zeros(8 - m.n))
        wrench_map(model, x, p["u_previous"], p["effectiveness"], p["nu_flow"], tau, J)
        n = m.n
        theirs = wrench(ops, m, x[:n], p["u_previous"][:n], p["effectiveness"][:n], p["nu_flow"])
        np.testing.assert_allclose(theirs, tau, atol=1e-9)


def figures(vehicle: Vehicle, rounds: int, paced_seconds: float) -> Iterator[Figure]:
    """Every row about allocation."""
    problems = np.concatenate([stream.record(vehicle, m) for m in stream.missions(vehicle)])
    model = stream.model_of(vehicle)
    check_generic_map(model, problems)
    best = np.zeros(len(problems))
    stream.tight_optimum(model, problems, np.random.default_rng(0).random((5, 8)), best)

    ours = {name: Ours(vehicle, problems, name) for name in ("osqp", "active_set")}
    osqp = ours["osqp"]
    gap = suboptimality(osqp.cost, best)
    yield figure(
        "suboptimal_share", "share of cycles > 1 % suboptimal", [100 * (gap > 0.01).mean()], "%", below=0.2
    )
    yield figure("suboptimal_worst", "worst suboptimality of a cycle", [100 * gap.max()], "%", below=3.0)

    chosen = np.linspace(0, len(problems) - 1, min(SAMPLE, len(problems))).astype(int)
    starts = [start_of(model, problems[k]) for k in chosen]
    works: dict[str, Any] = {name: each.run for name, each in ours.items()}
    answers: dict[str, np.ndarray] = {}
    missing: list[str] = []
    for key, (_, make) in PEERS.items():
        try:
            solve = make(model)
        except ImportError:
            missing.append(key)
            continue
        answers[key] = np.zeros(len(chosen))
        works[key] = _work(solve, model, problems, chosen, starts, answers[key])
    taken = interleaved(works, rounds)
    each = {k: t / (len(problems) if k in ours else len(chosen)) for k, t in taken.items()}
    yield figure("allocation_us", "allocation per cycle, median", each["osqp"] * 1e6, "µs")
    yield figure("bare_us", "the same with the bare active set", each["active_set"] * 1e6, "µs")
    for key, cost in answers.items():
        title, least = PEERS[key][0], 300.0 if key == "paper" else 1.0
        yield figure(
            f"vs_{key}",
            f"allocation against {title}",
            each[key] / each["osqp"],
            "×",
            at_least=least,
            ratio=True,
        )
        theirs = suboptimality(cost, best[chosen])
        yield figure(f"gap_{key}", f"{title}: suboptimality p99", [100 * np.percentile(theirs, 99)], "%")
    yield figure(
        "gap_ours", "ours on the same sample: suboptimality p99", [100 * np.percentile(gap[chosen], 99)], "%"
    )
    for key in missing:
        print(f"left out, not installed: {PEERS[key][0]}")
    yield _hot(osqp, rounds)
    yield _paced(osqp, paced_seconds)


def _work(
    solve: Solve, model: np.void, problems: np.ndarray, chosen: Any, starts: list, cost: np.ndarray
) -> Any:
    tau, J = np.zeros(6), np.zeros((6, 8))

    def work() -> None:
        for j, k in enumerate(chosen):
            x, lower, upper = starts[j]
            found = solve(problems[k], x, lower, upper)
            cost[j] = stream.cost_at(model, problems[k], np.append(found, np.zeros(8 - len(found))), tau, J)

    return work


def _hot(ours: Ours, rounds: int) -> Figure:
    """p99 over the stream of CPU time inside the compiled loop."""
    tails = []
    for _ in range(rounds):
        ours.run()
        tails.append(np.percentile(ours.cpu, 99) * 1e6)
    return figure("hot_p99_us", "allocation, CPU p99 hot", tails, "µs", at_most=40)


def _paced(ours: Ours, seconds: float) -> Figure:
    """p95 of wall time, one problem every 40 ms as in a live cycle: cold caches, a core that slept."""
    taken, now = [], time.monotonic()
    for k in range(int(seconds * 25)):
        now += 0.04
        time.sleep(max(0.0, now - time.monotonic()))
        chosen = (37 * k) % len(ours.problems)
        ours.run_one(chosen)
        taken.append(ours.wall[chosen] * 1e6)
    tails = [np.percentile(part, 95) for part in np.array_split(np.array(taken), 5)]
    return figure("paced_p95_us", "allocation, wall p95 paced at 25 Hz", tails, "µs", at_most=250)
