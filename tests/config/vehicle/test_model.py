"""The record that compiled code reads: properties of its matrices, and the paper's identified forces."""

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.vehicle import load_vehicle, vehicle_names
from bumpless.physics.actuators import FIN, actuator_wrench, total_wrench
from bumpless.physics.model import build_model

NAMES = vehicle_names()
# Gao et al. 2026, eq. (3): nonzero entries of M for a hull with port-starboard symmetry
M_PATTERN = {(0, 0), (0, 2), (0, 4), (1, 1), (1, 3), (1, 5), (2, 2), (2, 4), (3, 3), (3, 5), (4, 4), (5, 5)}


def wrench(model: np.record, i: int, command: float, surge: float) -> np.ndarray:
    """Wrench (6,) of one actuator in steady flow along x."""
    out = np.zeros(6)
    u = np.zeros(MAX_ACTUATORS)
    u[i] = command
    actuator_wrench(model, i, u, np.array([surge, 0, 0, 0, 0, 0.0]), out)
    return out


@pytest.mark.parametrize("name", NAMES)
def test_mass_matrix_is_symmetric_positive_definite_and_sparse_as_published(name: str) -> None:
    """Kinetic energy is positive, and symmetry of the hull decouples what it must."""
    model = build_model(load_vehicle(name))
    M = model["M_RB"] + model["M_A"]
    assert np.allclose(M, M.T, atol=1e-12)
    assert np.linalg.eigvalsh(model["M_A"]).min() >= -1e-12
    assert np.linalg.eigvalsh(model["M_RB"]).min() > 0
    assert np.allclose(model["M_inv"] @ M, np.eye(6), atol=1e-9)
    for i, j in zip(*np.nonzero(np.abs(M) > 1e-12), strict=True):
        assert (min(i, j), max(i, j)) in M_PATTERN


@pytest.mark.parametrize("name", NAMES)
def test_unused_entries_are_zero_and_used_ones_complete(name: str) -> None:
    """One compilation serves every vehicle because the rest of each array is zero."""
    vehicle = load_vehicle(name)
    model = build_model(vehicle)
    n = int(model["n_u"])
    assert n == len(vehicle.commands)
    for field in ("command_max", "command_rate", "time_constant"):
        assert (model[field][:n] > 0).all()
        assert (model[field][n:] == 0).all()
    assert np.allclose(np.linalg.norm(model["direction"][:n], axis=1), 1.0)
    for i in range(n):
        assert (model["fin_area"][i] > 0) == (model["kind"][i] == FIN)
        assert (model["T_nn"][i] > 0) == (vehicle.commands[i].unit == "rpm")
    assert n <= MAX_ACTUATORS


@pytest.mark.parametrize("name", NAMES)
def test_actuators_serve_exactly_the_components_the_file_claims(name: str) -> None:
    """The wrenches that commands give at 0.5 m/s span the controllable components."""
    model = build_model(load_vehicle(name))
    rng, wrenches = np.random.default_rng(1), np.zeros((60, 6))
    for row in wrenches:
        u = rng.uniform(model["command_min"], model["command_max"])
        total_wrench(model, u, np.ones(MAX_ACTUATORS), np.array([0.5, 0, 0, 0, 0, 0.0]), row)
    B = (wrenches - wrenches.mean(axis=0)).T[model["controllable"] > 0]
    assert np.linalg.matrix_rank(B, tol=1e-6) == B.shape[0]


def test_ts100_fin_has_the_identified_lift_and_drag() -> None:
    """0.303 N of lift and 0.0177 N more drag at 15 deg and 0.2 m/s (paper.md: from Table 3)."""
    model = build_model(load_vehicle("ts100"))
    full, zero = wrench(model, 0, model["command_max"][0], 0.2), wrench(model, 0, 0.0, 0.2)
    assert full[:3] @ model["direction"][0] == pytest.approx(0.303, rel=0.01)
    assert zero[0] - full[0] == pytest.approx(0.0177, rel=0.01)
    assert full[3] > 0  # r x e_L along +x


def test_ts100_thrusters_have_the_identified_thrust() -> None:
    """+-4.56 N along x and +-0.586 N down at +-200 rpm in still water; equal verticals do not roll."""
    model = build_model(load_vehicle("ts100"))
    n = model["command_max"][4]
    assert n == pytest.approx(200 / 60)
    for sign in (1.0, -1.0):
        assert wrench(model, 4, sign * n, 0.0)[0] == pytest.approx(sign * 4.56, rel=0.01)
        assert wrench(model, 5, sign * n, 0.0)[2] == pytest.approx(sign * 0.586, rel=0.01)
    both = wrench(model, 5, n, 0.0) + wrench(model, 6, n, 0.0)
    assert np.allclose(both[[0, 1, 3, 4, 5]], 0.0, atol=1e-12)
    assert wrench(model, 6, n, 0.0)[3] > 0  # starboard pushing down rolls to starboard


def test_ts100_floats_neutrally_and_upright() -> None:
    """Weight equals buoyancy; the centre of gravity lies below the centre of buoyancy."""
    model = build_model(load_vehicle("ts100"))
    assert model["weight"] == pytest.approx(model["buoyancy"])
    assert model["r_g"][2] > model["r_b"][2]


def test_ts100_can_cruise_at_the_papers_speed() -> None:
    """Thrust at 200 rpm exceeds drag at 0.7 m/s and falls short of it at 1 m/s: an independent balance."""
    model = build_model(load_vehicle("ts100"))

    def surplus(u: float) -> float:
        thrust = wrench(model, 4, model["command_max"][4], u)[0]
        fins = sum(wrench(model, i, 0.0, u)[0] for i in range(4))
        return thrust + fins - (model["D_linear"][0, 0] + model["D_quadratic"][0, 0] * u) * u

    assert surplus(0.7) > 0.3
    assert surplus(1.0) < 0.0
