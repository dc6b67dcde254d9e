"""The surface: what is out of the water floats nothing, by Archimedes and independent integration."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.physics.faults import FAULTS
from bumpless.physics.hydrodynamics.myring import HullStrips
from bumpless.physics.model import build_model
from bumpless.physics.plant import PLANT, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.physics.surface import lose_buoyancy
from bumpless.physics.water import ENVIRONMENT
from bumpless.sim.truth import truth_of
from tests.flights import MISSIONS

TS100 = load_vehicle("ts100")
MODEL = build_model(TS100)
STRIPS = HullStrips(TS100.hull)  # type: ignore[arg-type]


def lost(eta, model=MODEL, **sea: float) -> np.ndarray:
    environment, tau = np.zeros(1, ENVIRONMENT)[0], np.zeros(6)
    for name, value in sea.items():
        environment[name] = value
    lose_buoyancy(model, environment, 0.0, np.array(eta, float), tau)
    return tau


def by_points(depth: float, theta: float) -> tuple[float, float]:
    """(N, N m) lost and its moment about O_b, from points all over the volume of the hull."""
    rng = np.random.default_rng(3)
    x = rng.uniform(STRIPS.x[0], STRIPS.x[-1], 400_000)
    y, z = rng.uniform(-0.1, 0.1, (2, len(x)))
    inside = y**2 + z**2 <= np.interp(x, STRIPS.x, STRIPS.radius) ** 2
    x, z = x[inside], z[inside]
    above = depth - x * np.sin(theta) + z * np.cos(theta) < 0.0
    weight = float(MODEL["buoyancy"]) / len(x)
    return weight * above.sum(), weight * x[above].sum()


@pytest.mark.parametrize(
    ("depth", "theta"), [(0.05, 0.0), (-0.04, 0.0), (0.0, 0.05), (0.1, 0.3), (0.2, -0.4)]
)
def test_loss_is_the_volume_above_the_surface(depth, theta):
    """Protects: Archimedes: force and moment are those of the hull's volume out of the water."""
    tau = lost([0.0, 0.0, depth, 0.0, theta, 0.0])
    force, moment = by_points(depth, theta)
    whole = float(MODEL["buoyancy"])
    assert np.hypot(tau[0], tau[2]) == pytest.approx(force, abs=0.01 * whole)
    assert tau[4] == pytest.approx(-moment * np.cos(theta), abs=0.01 * whole)


@given(st.floats(-3.0, 3.0), st.floats(-1.2, 1.2), st.floats(0.0, 0.99))
def test_nothing_is_lost_below(phi, theta, psi):
    """Protects: a hull below the surface, as of every shipped mission, flies as if there were none."""
    assert not lost([0.0, 0.0, 0.11 + 1.17 * abs(np.sin(theta)), phi, theta, psi]).any()
    assert lost([0.0, 0.0, -2.0, 0.0, 0.0, psi])[2] == pytest.approx(float(MODEL["buoyancy"]))


def test_a_crest_covers_and_a_trough_bares():
    """Protects: the surface that counts is the wave's."""
    quarter = 9.80665 * 36.0 / (2.0 * np.pi) / 2.0  # m, half a wave on: the trough
    assert (
        lost([0.0, 0.0, 0.05, 0.0, 0.0, np.pi / 2], wave_height=0.2, wave_period=6.0)[2]
        < 1e-6
        < lost([0.0, 0.0, 0.05, 0, 0, 0])[2]
    )
    assert lost([quarter, 0.0, 0.05, 0.0, 0.0, np.pi / 2], wave_height=0.2, wave_period=6.0)[2] > 0.5 * float(
        MODEL["buoyancy"]
    )


@pytest.mark.parametrize("name", ["ts100", "bluerov2_heavy"])
def test_a_light_vehicle_floats(name):
    """Protects: it rises to the surface and stays there, with as much of it out as it is too light."""
    vehicle = load_vehicle(name)
    model, plant, sea = build_model(vehicle), np.zeros(1, PLANT)[0], np.zeros(1, ENVIRONMENT)[0]
    model["buoyancy"], sea["surface"] = model["weight"] + 5.0, 1
    plant["eta"][2], plant["effectiveness"], noise = 0.5, 1.0, np.zeros(N_NOISE)
    for _ in range(4000):
        step_plant(model, sea, np.zeros(1, FAULTS)[0], plant, np.zeros(8), 0.05, 2, noise)
    assert abs(plant["nu"][2]) < 1e-3 and 0.0 < plant["eta"][2] < float(model["half_height"])
    assert np.linalg.norm(lost(plant["eta"], model)[:3]) == pytest.approx(5.0, abs=0.1)


def test_missions_have_a_surface():
    """Protects: simulated vehicles do not rise out of the sea."""
    mission = parse_mission((MISSIONS / "docking.yaml").read_text(), "docking.yaml", TS100)
    assert truth_of(mission, TS100)[0]["environment"]["surface"] == 1
