"""REMUS turns and pitches as the thesis' own model does, with the thesis' own coefficients as data."""

import json

import numpy as np
import pytest

from bumpless.config.vehicle import MyringHull, load_vehicle
from bumpless.jit import jit
from bumpless.physics.faults import FAULTS
from bumpless.physics.model import build_model
from bumpless.physics.plant import PLANT, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.physics.water import ENVIRONMENT
from bumpless_paper.remus.check import PUBLISHED, by_form, thesis_coefficient
from tests.physics.hydrodynamics.thesis import SPEED_MPS, thesis_run

REMUS = load_vehicle("remus100")
RPM = 682.0  # the thesis' thrust of 3.86 N at 1.54 m/s
STEP_S = 0.05


@jit
def fly_open(model, environment, faults, plant, command, dt, noise, out):
    """Fill out (n, 12) with eta and nu after each step."""
    for i in range(out.shape[0]):
        step_plant(model, environment, faults, plant, command, dt, 2, noise)
        for k in range(6):
            out[i, k], out[i, 6 + k] = plant.eta[k], plant.nu[k]


def ours(rudder_deg: float, stern_deg: float, seconds: float) -> np.ndarray:
    """The same of the plant, neutrally buoyant, without the screw's torque, which the thesis trims away."""
    model, plant, command = build_model(REMUS), np.zeros(1, PLANT)[0], np.zeros(8)
    model["buoyancy"], model["Q_nn"], model["Q_nv"] = model["weight"], 0.0, 0.0
    for i, fin in enumerate(REMUS.actuators[:4]):
        _, side, down = fin.direction  # a rudder to port pushes the stern to starboard, planes likewise
        command[i] = np.radians(rudder_deg * side - stern_deg * down)
    command[4] = RPM / 60.0
    plant["nu"][0], plant["effectiveness"], plant["u"] = SPEED_MPS, 1.0, command
    out, calm = np.zeros((round(seconds / STEP_S), 12)), np.zeros(1, ENVIRONMENT)[0]
    fly_open(model, calm, np.zeros(1, FAULTS)[0], plant, command, STEP_S, np.zeros(N_NOISE), out)
    return out


def radius(states: np.ndarray) -> float:
    """Of the circle of the last steps, m."""
    way = np.linalg.norm(np.diff(states[-40:, :2], axis=0), axis=1).sum()
    return way / abs(np.unwrap(states[-40:, 5])[-1] - np.unwrap(states[-40:, 5])[0])


@pytest.mark.parametrize("rudder", [4.0, 5.0, -8.0])
def test_turning_radius_is_the_thesis_models(rudder: float) -> None:
    """Protects: 5 deg of rudder turn in 5.5 m as his model does, not in 2 m: within 20 %."""
    times = np.arange(STEP_S, 60.0 + STEP_S / 2, STEP_S)
    theirs, mine = radius(thesis_run(rudder, 0.0, times)), radius(ours(rudder, 0.0, 60.0))
    assert mine == pytest.approx(theirs, rel=0.2)
    assert theirs == pytest.approx({4.0: 5.6, 5.0: 5.4, -8.0: 5.0}[rudder], abs=0.1)


@pytest.mark.parametrize("stern", [2.0, 4.0, -4.0])
def test_pitch_response_is_the_thesis_models(stern: float) -> None:
    """Protects: after a step of the stern planes pitch and depth follow his model: within 20 %."""
    times = np.arange(STEP_S, 5.0 + STEP_S / 2, STEP_S)
    theirs, mine = thesis_run(0.0, stern, times), ours(0.0, stern, 5.0)
    for second in (1.0, 2.0, 3.0, 5.0):
        k = round(second / STEP_S) - 1
        assert mine[k, 4] == pytest.approx(theirs[k, 4], rel=0.2), second
    assert mine[-1, 2] == pytest.approx(theirs[-1, 2], rel=0.2)


def test_form_alone_turns_much_tighter() -> None:
    """Protects: the coefficients are used: what strip theory makes of the form has a tenth of the rotation
    drag."""
    assert thesis_coefficient(REMUS, "N_rr") > -10.0
    assert isinstance(REMUS.hull, MyringHull) and REMUS.hull.coefficients
    assert build_model(REMUS)["D_quadratic"][5, 5] == 94.0
    assert build_model(by_form(REMUS))["D_quadratic"][5, 5] < 10.0


def test_file_has_the_published_numbers() -> None:
    """Protects: one table in two places, the vehicle's file and the comparison, says the same."""
    assert isinstance(REMUS.hull, MyringHull) and REMUS.hull.coefficients
    published = json.loads(PUBLISHED.read_text(encoding="utf-8"))["coefficients"]
    for name, value in REMUS.hull.coefficients.by_symbol.items():
        assert value == published[name], name
