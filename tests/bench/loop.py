"""Rows about the closed loop, one step of the plant against peers, and the envelope."""

import dataclasses
import importlib
import math
import sys
import types
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.jit import jit
from bumpless.physics.dynamics import body_acceleration
from bumpless.physics.envelope import attainable_sets, wrench_curves
from bumpless.physics.envelope_hull import hull_of_points
from bumpless.physics.frames import body_to_ned, euler_rates
from bumpless.physics.model import build_model
from bumpless.physics.plant import N_STATE, state_rate
from bumpless.physics.water import ENVIRONMENT
from bumpless.sim.twin import one, parameters_for, simulate
from tests.bench import stream
from tests.bench.figure import Figure, figure, interleaved

STEPS, PEER_STEPS, DT = 20_000, 200, 0.01
# REMUS flies the same helm in both simulators: rudder and stern planes in rad, shaft in rev/s
_RUDDER, _STERN, _SHAFT = 0.05, 0.02, 15.0
_HELM = (-_STERN, _RUDDER, _STERN, -_RUDDER, _SHAFT)  # of our four panels and propeller


def closed_loop(vehicle: Vehicle, rounds: int) -> Iterator[Figure]:
    """Real-time factor of every mission together, and against the bare active set."""
    missions = stream.missions(vehicle)
    flown = {}
    tuned = {
        s: [_with_solver(parameters_for(vehicle, m), s) for m in missions] for s in ("osqp", "active_set")
    }

    def fly(solver: str) -> None:
        flown[solver] = 0.0
        for mission, chosen in zip(missions, tuned[solver], strict=True):
            result = simulate(mission, vehicle, chosen)
            flown[solver] += len(result.log) * vehicle.control_period_s

    taken = interleaved({s: lambda s=s: fly(s) for s in ("osqp", "active_set")}, rounds)
    each = {s: taken[s] / flown[s] for s in taken}
    count = "all six scenarios" if len(missions) == 6 else f"{len(missions)} docking missions"
    title = f"closed loop, {count}, one core, 20 Hz, two RK4 substeps, noise"
    yield figure("real_time", title, 1.0 / each["osqp"], "× real time", at_least=2500)
    ratio = each["osqp"] / each["active_set"]
    yield figure("loop_vs_bare", "the same against the bare active set", ratio, "×", at_most=2.5, ratio=True)


def _with_solver(parameters: Parameters, solver: Any) -> Parameters:
    return dataclasses.replace(
        parameters, allocation=dataclasses.replace(parameters.allocation, solver=solver)
    )


@jit
def wrench_steps(model, x, tau, dt, count, rate, work):
    """`count` explicit Euler steps of the body alone under a constant wrench, as auv-sim-bench has it."""
    nu_c_dot, force = work[0:6], work[6:12]
    for k in range(6):
        nu_c_dot[k] = 0.0
    for _ in range(count):
        eta, nu = x[0:6], x[6:12]
        body_acceleration(model, eta, nu, nu, nu_c_dot, tau, force, rate[6:12])
        body_to_ned(eta[3], eta[4], eta[5], nu, rate)
        rate[3], rate[4], rate[5] = euler_rates(eta[3], eta[4], nu[3], nu[4], nu[5])
        for i in range(12):
            x[i] += dt * rate[i]


@jit
def euler_steps(model, environment, x, command, dt, count, rate, gust, healthy):
    """`count` explicit Euler steps of the plant: vehicle, actuators and their lag, current."""
    time = 0.0
    for _ in range(count):
        state_rate(model, environment, gust, healthy, time, x, command, rate)
        for i in range(x.shape[0]):
            x[i] += dt * rate[i]
        time += dt


def _our_steps(name: str, helm: tuple[float, ...] = ()) -> Callable[[], None]:
    """Steps from rest under held commands: `helm`, rad and rev/s, or 30 % of what each actuator can do."""
    model, calm, command = build_model(load_vehicle(name)), one(ENVIRONMENT), np.zeros(8)
    command[:] = 0.3 * model["command_max"]
    command[: len(helm)] = helm
    rate, x = np.zeros(N_STATE), np.zeros(N_STATE)

    def work_() -> None:
        x[:] = 0.0
        euler_steps(model, calm[0], x, command, DT, STEPS, rate, np.zeros(3), np.ones(8))
        assert np.isfinite(x).all()

    return work_


def _our_body() -> Callable[[], None]:
    model, x, tau = build_model(load_vehicle("ts100")), np.zeros(N_STATE), np.zeros(6)
    tau[0], tau[5] = 10.0, 0.1

    def work_() -> None:
        x[:] = 0.0
        wrench_steps(model, x, tau, DT, STEPS, np.zeros(N_STATE), np.zeros(12))
        assert np.isfinite(x).all()

    return work_


def _auv_sim_bench() -> Callable[[], None]:
    AUVDynamics = importlib.import_module("auv_sim_bench.dynamics").AUVDynamics
    vehicle, force, torque = AUVDynamics(), np.array([10.0, 0, 0]), np.array([0, 0, 0.1])

    def work() -> None:
        for _ in range(PEER_STEPS):
            vehicle.step(DT, force, torque)

    return work


def _remus100(checkout: Path) -> Callable[[], None]:
    """PythonVehicleSimulator's vehicle and attitude update, without its log and its plots."""
    root = checkout / "src" / "python_vehicle_simulator"
    for name in ("", ".lib", ".vehicles"):  # their __init__ files want every vehicle and matplotlib
        package = types.ModuleType(f"python_vehicle_simulator{name}")
        package.__path__ = [str(root / name.lstrip("."))]
        sys.modules[package.__name__] = package
    gnc = importlib.import_module("python_vehicle_simulator.lib.gnc")
    vehicle = importlib.import_module("python_vehicle_simulator.vehicles.remus100").remus100()
    command = np.array([_RUDDER, _STERN, 60.0 * _SHAFT])

    def work() -> None:
        eta, nu, actual = np.zeros(6), np.array(vehicle.nu, float), np.zeros(3)
        for _ in range(PEER_STEPS):
            nu, actual = vehicle.dynamics(eta, nu, actual, command, DT)
            eta = gnc.attitudeEuler(eta, nu, DT)
        assert math.isfinite(eta[0])

    return work


def one_step(rounds: int, checkout: Path | None) -> Iterator[Figure]:
    """One 6-DOF Euler step against peers."""
    works = {"ts100": _our_steps("ts100"), "remus100": _our_steps("remus100", _HELM), "body": _our_body()}
    peers: list[tuple[str, str, str, float]] = []
    try:
        works["auv_sim_bench"] = _auv_sim_bench()
        peers.append(("auv_sim_bench", "body", "auv-sim-bench, body under a wrench", 250.0))
    except ImportError:
        print("left out, not installed: auv-sim-bench")
    if checkout is not None:
        works["pvs"] = _remus100(checkout)
        peers.append(("pvs", "remus100", "PythonVehicleSimulator's remus100", 300.0))
    else:
        print("left out, no --peer-path: PythonVehicleSimulator's remus100")
    taken = interleaved(works, rounds)
    for name in ("ts100", "remus100", "body"):
        yield figure(f"step_{name}_us", f"one 6-DOF Euler step, {name}", taken[name] / STEPS * 1e6, "µs")
    for key, ours, title, goal in peers:
        ratio = (taken[key] / PEER_STEPS) / (taken[ours] / STEPS)
        yield figure(
            f"step_vs_{key}", f"one 6-DOF step against {title}", ratio, "×", at_least=goal, ratio=True
        )
    if "auv_sim_bench" in taken:  # the peer has no actuators: this asks more of us than of it
        ratio = (taken["auv_sim_bench"] / PEER_STEPS) / (taken["ts100"] / STEPS)
        title = "one step of ts100, actuators and water included, against auv-sim-bench"
        yield figure("full_step_vs_auv_sim_bench", title, ratio, "×", at_least=250, ratio=True)


def envelope(vehicle: Vehicle, rounds: int) -> Iterator[Figure]:
    """Support function in 500 directions against 20,000 samples + ConvexHull, forces and moments."""
    model = build_model(vehicle)
    n = int(model["n_u"])
    low, high = model["command_min"][:n], model["command_max"][:n]
    speed, held = 0.4, {}

    def ours() -> None:
        held["ours"] = attainable_sets(model, speed)

    def sampled() -> None:
        draw = np.random.default_rng(0).random((20_000, n))
        cloud = wrench_curves(model, speed, low + (high - low) * draw, np.arange(n)).sum(axis=0)
        held["force"], held["moment"] = hull_of_points(cloud[:, :3]), hull_of_points(cloud[:, 3:])

    taken = interleaved({"ours": ours, "sampled": sampled}, rounds)
    dense, few = attainable_sets(model, speed, 20_000), held["ours"]
    share = [100 * few.force.volume / dense.force.volume, 100 * few.moment.volume / dense.moment.volume]
    theirs = [held["force"].volume / dense.force.volume, held["moment"].volume / dense.moment.volume]
    yield figure(
        "envelope_ms", "envelope, forces and moments, 500 directions", taken["ours"] * 1e3, "ms", at_most=3.0
    )
    yield figure("envelope_vs_samples", "envelope against 20,000 samples + ConvexHull",
                 taken["sampled"] / taken["ours"], "×", at_least=6, ratio=True)  # fmt: skip
    yield figure("envelope_volume", "its volume, of 20,000 directions", [min(share)], "%", at_least=98.5)
    yield figure("samples_volume", "volume that the samples find", [100 * min(theirs)], "%", better="higher")
