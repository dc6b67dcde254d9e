"""The scenarios: one plant, one reference set, and mission files that say the same."""

import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import parse_mission
from bumpless.config.parameters import as_dict
from bumpless.config.vehicle import load_vehicle
from bumpless_paper.study.fly import Job, parameters_for
from bumpless_paper.study.scenarios import SCENARIOS, mission_of, mission_text

MISSIONS = Path(__file__).parents[3] / "missions"
MAY_DIFFER = {"allocation": {"allocator", "direct_map", "fault_tolerant", "effectiveness"}, "bumpless": None}


@pytest.mark.parametrize("name", SCENARIOS)
def test_mission_file_is_the_scenario(name: str) -> None:
    """Protects: what an operator flies from the list is what the study reports."""
    scenario = SCENARIOS[name]
    text = (MISSIONS / scenario.file).read_text(encoding="utf-8")
    assert text == mission_text(scenario)
    parse_mission(text, scenario.file)


def test_scenarios_share_plant_and_references() -> None:
    """Protects: the comparison; only allocator, switching and fault handling may differ."""
    missions = [mission_of(s) for s in SCENARIOS.values()]
    words = {"name": "same", "title": "", "summary": "", "source": "", "text": ""}
    own = {**words, "parameters": {}, "faults": ()}
    common = [replace(m, **own) for m in missions]
    assert all(m == common[0] for m in common)
    assert [len(m.faults) for m in missions] == [0, 0, 0, 0, 1, 1, 1]
    assert missions[4].faults == missions[5].faults == missions[6].faults
    trees = [as_dict(parameters_for(Job(name))) for name in SCENARIOS]
    for section, keys in trees[0].items():
        allowed = MAY_DIFFER.get(section, set())
        for key, value in keys.items():
            if allowed is not None and key not in allowed:
                assert all(tree[section][key] == value for tree in trees), f"{section}.{key}"


def test_s3_differs_from_s4_in_switching_only() -> None:
    """Protects: S3 is a hard update of the very solver of S4."""
    three, four = (parameters_for(Job(name)) for name in ("S3", "S4"))
    assert replace(three, bumpless=four.bumpless) == four
    assert not three.bumpless.ramp and not three.bumpless.integrator_alignment
    assert four.bumpless.ramp and four.bumpless.integrator_alignment and four.bumpless.warm_start_projection


def test_jobs_travel_between_processes() -> None:
    """Protects: spawned workers."""
    job = Job("S6", 3)
    assert pickle.loads(pickle.dumps(job)) == job


def test_vehicle_has_one_main_propeller() -> None:
    """Protects: the fault of S5 and S6 hits the main propeller and nothing else."""
    fault = mission_of(SCENARIOS["S5"]).faults[0]
    actuator = next(a for a in load_vehicle("ts100").actuators if a.name == fault.actuator)
    assert np.allclose(actuator.direction, [1, 0, 0])
