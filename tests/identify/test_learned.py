"""What was found, in the vehicle's file: those numbers alone, and a vehicle that flies the better for it."""

import difflib
from typing import Any

import numpy as np
import pytest

import bumpless
from bumpless.campaign.plant import Alteration
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.identify import changes, flight_of, identify, learned, learned_text
from bumpless.identify.scales import LIFT, THRUST, Scale, scales_of
from bumpless.physics.model import build_model
from bumpless.sim.twin import simulate
from bumpless_paper.study.fly import Job, alteration_for, fly, scenario_named
from bumpless_paper.study.honest import judged
from bumpless_paper.study.learned import Unlearned, learned_from
from bumpless_paper.study.plants import WIDE, draw
from bumpless_paper.study.scenarios import mission_of


def _factors(vehicle: Vehicle, thrust: float, lift: float) -> dict[Scale, float]:
    by_kind = {THRUST: thrust, LIFT: lift}
    return {scale: by_kind[scale.what] for scale in scales_of(vehicle) if scale.what in by_kind}


def test_only_what_was_found_changes_in_the_file(ts100: Vehicle):
    """Protects: the author's text, comments and order; each changed number says where it comes from."""
    factors = _factors(ts100, 0.88, 0.8)
    before, after = ts100.text.split("\n"), learned_text(ts100, factors).split("\n")
    lines = [line for line in difflib.ndiff(before, after) if line.startswith("+ ")]
    assert len(before) == len(after)
    assert len(lines) == len(changes(ts100, factors)) == 5
    assert all("# learned in flight: 0.8" in line for line in lines)


def test_every_vehicle_that_ships_can_learn():
    """Protects: the place of each number, whatever form a file has, and the model that comes of it."""
    for name in bumpless.vehicle_names():
        vehicle = bumpless.load_vehicle(name)
        model, other = build_model(vehicle), build_model(learned(vehicle, _factors(vehicle, 0.9, 0.8)))
        for field, factor in (("T_nn", 0.9), ("T_nn_reverse", 0.9), ("T_nv", 0.9), ("C_La", 0.8)):
            np.testing.assert_allclose(other[field], factor * model[field], rtol=1e-4, err_msg=name)
        np.testing.assert_allclose(other["Q_nn"], model["Q_nn"])


def test_nothing_found_changes_nothing(ts100: Vehicle):
    """Protects: an empty finding leaves the file to the letter."""
    assert learned_text(ts100, {}) == ts100.text.removeprefix("\ufeff")
    assert learned(ts100, {}).sha256 == ts100.sha256


def test_a_vehicle_that_has_learned_has_nothing_more_to_learn(ts100: Vehicle):
    """Protects: what is written is what was found: flown with it, the scales are 1."""
    weak = Alteration(thrust=0.85, fin_lift=0.75)
    first = bumpless.fly("docking_into_current", ts100, seed=3, alter=weak)
    better = learned(ts100, identify([flight_of(first)], ts100).factors)
    again = bumpless.fly("docking_into_current", better, seed=4, alter=Unlearned(ts100, weak))
    for one in identify([flight_of(again)], better).estimates:
        if one.told and one.scale.names:
            assert abs(one.value - 1.0) < 0.06, one.scale.title


def test_the_allocator_gives_what_is_asked_of_it_once_the_vehicle_has_learned():
    """Protects: the wrench given as told, nearer to the demand on a plant whose thrust and lift are others,
    and the same true plant in both flights."""
    plant = draw(64, WIDE)
    before, after = (judged(Job("S4", 65, plant, learned=known)) for known in (False, True))
    assert after["e_tau_told"] < 0.8 * before["e_tau_told"]
    job = Job("S4", 65, plant, learned=True)
    result = fly(job)
    models: list[np.record] = []
    assert result.vehicle.sha256 != bumpless.load_vehicle("ts100").sha256

    def look(model: Any, truth: Any) -> None:
        alteration_for(job)(model, truth)
        models.append(model.copy())

    simulate(result.mission, result.vehicle, result.parameters, 1, alter=look)
    np.testing.assert_allclose(models[0]["T_nn"][4], plant.thrust * 0.391 * 1000.0 * 0.18**4, rtol=1e-9)


@pytest.mark.parametrize("number", [60, 64, 70])
def test_learning_masks_no_fault(number: int):
    """Protects: the estimator of faults finds the screw's loss as before when thrust and lift were learned,
    and rings no alarm without one."""
    plant = draw(number, WIDE)
    vehicle = learned_from(fly(Job("S4", number + 1001, plant)))
    found = fly(Job("S7", number + 1, plant, learned=True))
    at = plant.fault_time or 0.0
    alarmed = np.flatnonzero(found.log["faults"])
    assert len(alarmed) and 0.0 < found.log["time"][alarmed[0]] - at < 15.0
    assert found.log["faults"][alarmed[0]] == 1 << 4
    last = found.log["effectiveness_hat"][-1, 4]
    assert last == pytest.approx(plant.fault_effectiveness, abs=0.1)
    job = Job("S7-healthy", number + 1, plant, learned=True)
    healthy = simulate(mission_of(scenario_named(job.scenario)), vehicle, found.parameters, job.seed,
                       alter=alteration_for(job))  # fmt: skip
    assert not healthy.log["faults"].any()
    assert pb.MODE_HOVER in healthy.log["mode"]
