"""Contact makes no energy: the stored energy has no jump, and hulls thrown at a dock come back no faster."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.mission.contact_steps import contact_steps
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.jit import jit
from bumpless.physics.faults import FAULTS
from bumpless.physics.model import build_model
from bumpless.physics.plant import PLANT, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.sim.truth import truth_of
from tests.flights import MISSIONS
from tests.physics.dock.test_contact import RINGS, dock, nose_at, touch

pytestmark = pytest.mark.slow
STATIONS = RINGS[0]["x"]


@given(
    depth=st.floats(-0.1, 3.4), aside=st.floats(-0.9, 0.9), down=st.floats(-0.9, 0.9),
    psi=st.floats(-1.2, 1.2), theta=st.floats(-1.2, 1.2), seed=st.integers(0, 99),
)  # fmt: skip
def test_stored_energy_has_no_jump(depth, aside, down, psi, theta, seed):
    """Protects: across corners, rims, stop and back, inside to outside: a small step of the hull changes the
    energy by force times step, so that no crossing gives energy away."""
    eta = np.array(nose_at(depth, aside, down, psi, theta))
    step = np.random.default_rng(seed).standard_normal(6) * 1e-6
    here, there = touch(dock(), eta), touch(dock(), eta + step)
    steepest = 5.0 * (here["force"] + there["force"]) + 50.0  # on a lever of 2 m, and springs just touched
    assert abs(there["energy"] - here["energy"]) <= steepest * np.abs(step).sum()


@pytest.mark.parametrize("station", np.linspace(0.3, -0.5, 9))
def test_the_rim_is_felt_all_along_the_flank(station):
    """Protects: between two rings of the hull, 0.1 m, the rim does not sink in unfelt."""
    c, s = np.cos(-0.3), np.sin(-0.3)  # the bow to the dock's middle: nothing but the rim is near
    eta = [-station * c, 0.5 - 0.095 / c - station * s, 0.0, 0.0, 0.0, -0.3]
    out = touch(dock(tube_radius=0.49), eta)
    assert 0.98 < out["wrench"][1] / (-0.005 * 5000.0) < 2.5  # more where a ring touches too


def test_from_behind_the_dock_is_closed():
    """Protects: a hull that comes from behind is thrown off the back, not sucked through the stop."""
    d = dock(entry=[0.0, 0.0, 0.0])
    for depth in (0.001, 0.02, 0.04):
        out = touch(d, [1.7 - depth + STATIONS[0], 0.0, 0.0, 0.0, 0.0, np.pi])
        assert out["wrench"][0] < 0.0  # astern in its own axes: away from the dock
        assert out["energy"] > 0.0


@jit
def throw(model, environment, faults, plant, dt, substeps, noise, out):
    """Fill out (n, 14): eta, nu, stored energy and nose depth where the nose is in the tube's width."""
    for i in range(out.shape[0]):
        step_plant(model, environment, faults, plant, noise, dt, substeps, noise)
        for k in range(6):
            out[i, k], out[i, 6 + k] = plant.eta[k], plant.nu[k]
        felt = environment.dock.felt
        out[i, 12], out[i, 13] = felt.energy, -1.0
        if felt.nose_offset < environment.dock.tube_radius:
            out[i, 13] = felt.nose_depth


def mission_of(name: str) -> tuple[Mission, Vehicle]:
    mission = parse_mission((MISSIONS / name).read_text(), name)
    return mission, load_vehicle(mission.vehicle)


def free_hull(vehicle):
    """Without drag, fins and screws: nothing but the dock takes or gives energy."""
    model = build_model(vehicle)
    for name in (
        "D_linear",
        "D_quadratic",
        "D_lift",
        "fin_area",
        "T_nn",
        "T_nn_reverse",
        "T_nv",
        "Q_nn",
        "Q_nv",
    ):
        model[name] = 0.0
    model["buoyancy"] = model["weight"]
    return model


def energy(model, states: np.ndarray) -> np.ndarray:
    """Kinetic, stored in contacts, and of the centre of gravity below O_b, J."""
    nu = states[:, 6:12]
    kinetic = 0.5 * np.einsum("ij,jk,ik->i", nu, model["M_RB"] + model["M_A"], nu)
    phi, theta = states[:, 3], states[:, 4]
    x, y, z = model["r_g"] - model["r_b"]
    down = -np.sin(theta) * x + np.cos(theta) * (np.sin(phi) * y + np.cos(phi) * z)
    return kinetic + states[:, 12] - model["weight"] * down


def thrown(name: str, speed: float, count: int, **dock_values):
    """(growth, deepest) of hulls thrown at a dock: share of v^2 m / 2, and m in the tube's width."""
    mission, vehicle = mission_of(name)
    model = free_hull(vehicle)
    sea = np.zeros(1, truth_of(mission, vehicle)[0]["environment"].dtype)[0]
    d = truth_of(mission, vehicle)[0]["environment"]["dock"]
    d["period"] = 0.0
    for key, value in dock_values.items():
        d[key] = value
    rng, growth, deepest = np.random.default_rng(5), [], []
    for _ in range(count):
        sea["dock"] = d
        plant, heading = np.zeros(1, PLANT)[0], float(d["heading"])
        psi, theta = heading + rng.uniform(-0.6, 0.6), rng.uniform(-0.4, 0.4)
        aside, down = rng.uniform(-1.2, 1.2, 2) * d["entry_radius"]
        c, s = np.cos(heading), np.sin(heading)
        nose = d["entry"] + np.array([-0.1 * c - aside * s, -0.1 * s + aside * c, down])
        ahead = np.array([np.cos(theta) * np.cos(psi), np.cos(theta) * np.sin(psi), -np.sin(theta)])
        plant["eta"][:3] = nose - model["rings"]["x"][0] * ahead
        plant["eta"][4:], plant["effectiveness"] = (theta, psi), 1.0
        plant["nu"] = rng.normal(0.0, 0.2 * speed, 6)
        plant["nu"][0] += speed
        out, begin = np.zeros((80, 14)), np.concatenate([plant["eta"], plant["nu"], [0.0, 0.0]])
        throw(model, sea, np.zeros(1, FAULTS)[0], plant, 0.05, 2, np.zeros(N_NOISE), out)
        all_of_it = energy(model, np.vstack([begin, out]))
        growth.append((all_of_it.max() - all_of_it[0]) / (0.5 * model["M_RB"][0, 0] * speed**2))
        deepest.append(out[:, 13].max())
    return np.array(growth), np.array(deepest), float(d["cone_length"] + d["tube_length"])


@pytest.mark.parametrize(
    ("name", "speed"),
    [("docking_funnel.yaml", s * 0.1) for s in (1, 2, 10)]
    + [("remus_docking.yaml", s * 1.5) for s in (1, 2)],
)
def test_thrown_hulls_gain_nothing(name, speed):
    """Protects: with damping and friction no collision, at docking's speed, twice and ten times it, gains a
    hundredth of its energy; without them the integration keeps it to 6 %. None goes through the stop."""
    growth, deepest, end = thrown(name, speed, 40)
    assert growth.max() < 0.01 and deepest.max() < end + 0.35
    growth, _, _ = thrown(name, speed, 40, damping=0.0, friction=0.0)
    assert growth.max() < 0.06


def test_stiffer_docks_take_finer_steps():
    """Protects: steps near a dock follow from its data, so that none of those accepted makes energy."""
    soft, vehicle = mission_of("docking_funnel.yaml")[0].target.dock, load_vehicle("ts100")
    assert soft
    steps = contact_steps(replace(soft, stiffness_npm=20000.0, damping_spm=50.0), vehicle)
    assert steps > contact_steps(soft, vehicle) > 2
    values = {"stiffness": 20000.0, "damping": 50.0, "steps": steps}
    growth, _, _ = thrown("docking_funnel.yaml", 0.2, 30, **values)
    assert growth.max() < 0.01
