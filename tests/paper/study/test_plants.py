"""The distribution of plants: stated, repeatable, and hidden from the autopilot."""

import pickle

import numpy as np
import pytest

from bumpless.config.vehicle import load_vehicle
from bumpless.physics.model import build_model
from bumpless.sim.truth import TOLD, truth_of
from bumpless.sim.twin import Twin
from bumpless_paper.study.plants import DISTRIBUTION, NOMINAL, draw
from bumpless_paper.study.scenarios import SCENARIOS, mission_of


def test_draws_fill_the_stated_ranges() -> None:
    """Protects: the 200 plants of the study are spread over the whole of each range, and nowhere else."""
    plants = [draw(i) for i in range(200)]
    for name, spread in DISTRIBUTION.items():
        values = np.array([getattr(p, name) for p in plants])
        assert values.min() >= spread.low and values.max() <= spread.high, name
        middle = spread.at(0.5)
        assert 0.4 < np.mean(values < middle) < 0.6, name
    assert draw(17) == draw(17) != draw(18)
    assert pickle.loads(pickle.dumps(plants[3])) == plants[3]


def test_nominal_plant_changes_nothing() -> None:
    """Protects: the tables are flown on the vehicle file's own numbers."""
    vehicle = load_vehicle("ts100")
    model, truth = build_model(vehicle), truth_of(mission_of(SCENARIOS["S5"]), vehicle)
    before = model.tobytes(), truth.tobytes()
    NOMINAL(model, truth[0])
    assert (model.tobytes(), truth.tobytes()) == before


def test_autopilot_keeps_the_nominal_model() -> None:
    """Protects: a drawn plant changes the truth only; the allocator's map stays nominal. Of the truth the
    plan is told the start and the fault (known in S6 as in the paper), as drawn."""
    vehicle = load_vehicle("ts100")
    twin = Twin(vehicle)
    plant = draw(5)
    twin.start(mission_of(SCENARIOS["S5"]), 1, alter=plant)
    nominal = build_model(vehicle)
    for name in ("time_constant", "buoyancy", "r_b", "D_quadratic"):
        assert np.array_equal(twin.onboard["model"][name], nominal[name]), name
        assert not np.array_equal(twin.world["model"][name], nominal[name]), name
    truth, plan = twin.world["truth"], twin.onboard["plan"]
    assert truth["faults"]["effectiveness"][0] == plant.fault_effectiveness
    assert truth["faults"]["time"][0] == plant.fault_time
    for name in TOLD:
        assert np.array_equal(plan[name], truth[name]), name
    twin.start(mission_of(SCENARIOS["S5"]), 1)
    assert twin.world["model"]["buoyancy"] == pytest.approx(float(nominal["buoyancy"]))
