"""Random allocation problems of every kind that a vehicle meets, in the form of `tests.bench.stream`."""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.contract.enums import FORWARD
from bumpless.control.allocation.bounds import command_bounds
from tests.bench.stream import ROW

KINDS = ("plain", "saturated", "no flow", "reversed flow", "failed actuator", "outside its bounds", "pinned")


def random_problems(model: np.record, count: int, seed: int) -> np.ndarray:
    """`count` ROWs (kinds in turn) for a vehicle's MODEL record.

    Demands lie within the thrusters' rough authority, up to six times beyond it where saturated; last
    commands lie anywhere within amplitude, beyond it in "outside its bounds"; in "pinned" half of them
    cannot move.
    """
    rng = np.random.default_rng(seed)
    n = int(model["n_u"])
    low, high = model["command_min"][:n], model["command_max"][:n]
    rows = np.zeros(count, ROW)
    rows["dt"], rows["warm"] = 0.05, 1
    authority = _authority(model)
    for k, row in enumerate(rows):
        kind = KINDS[k % len(KINDS)]
        row["mode"], row["lam"] = FORWARD + rng.integers(3), 10.0 ** rng.uniform(-4, -1)
        row["Q"] = model["controllable"] * 10.0 ** rng.uniform(-1, 1, 6)
        row["R"][:n] = 10.0 ** rng.uniform(-2, 0.5, n)
        row["effectiveness"] = 1.0
        surge = {"no flow": 0.0, "reversed flow": rng.uniform(-0.6, -0.1)}.get(kind, rng.uniform(-0.3, 0.9))
        row["nu_flow"] = surge * np.array([1, 0, 0, 0, 0, 0]) + (kind != "no flow") * rng.normal(0, 0.05, 6)
        reach = rng.uniform(1.5, 6.0) if kind == "saturated" else rng.uniform(0.0, 1.0)
        row["tau_d"] = reach * authority * rng.uniform(-1, 1, 6)
        if kind == "failed actuator":
            row["effectiveness"][rng.integers(n)] = rng.choice([0.0, 0.4])
        row["u_previous"][:n] = low + (high - low) * rng.random(n)
        if kind == "outside its bounds":
            row["u_previous"][rng.integers(n)] *= 1.5
        step = np.zeros(MAX_ACTUATORS)
        command_bounds(model, row["u_previous"], 0.05, row["u_lower"], row["u_upper"], step)
        if kind == "pinned":
            held = rng.random(n) < 0.5
            row["u_lower"][:n][held] = row["u_upper"][:n][held] = row["u_previous"][:n][held]
    return rows


def _authority(model: np.record) -> np.ndarray:
    """Rough largest wrench, N and N m (6,), of all thrusters together plus what fins add to moments."""
    n = int(model["n_u"])
    out = np.zeros(6)
    for i in range(n):
        thrust = model["T_nn"][i] * model["command_max"][i] ** 2 if model["T_nn"][i] > 0.0 else 0.5
        force = thrust * model["direction"][i]
        out[:3] += np.abs(force)
        out[3:] += np.abs(np.cross(model["position"][i], force))
    return out * model["controllable"]
