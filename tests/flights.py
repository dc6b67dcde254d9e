"""Fixtures: a vehicle and a flown mission that many rooms' tests look at; each is made once."""

import json
from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.physics.model import build_model
from bumpless.sim.twin import Result, simulate
from bumpless_paper.study.gains import STUDY_GAINS

MISSIONS = Path(__file__).parents[1] / "missions"


def still_water(name: str) -> str:
    """The text of a shipped mission whose last section is its environment, without that."""
    return (MISSIONS / name).read_text().split("\nenvironment:")[0] + "\n"


@pytest.fixture(scope="session")
def ts100() -> Vehicle:
    return load_vehicle("ts100")


@pytest.fixture(scope="session")
def model(ts100: Vehicle) -> np.record:
    return build_model(ts100)


@pytest.fixture(scope="session")
def docking(ts100: Vehicle) -> Mission:
    return parse_mission(still_water("docking.yaml"), "docking.yaml", ts100)


@pytest.fixture(scope="session")
def published(docking: Mission, ts100: Vehicle) -> Mission:
    """The docking mission as the paper flies it: the published automaton, guidance and the study's gains."""
    text = docking.text + "parameters: " + json.dumps(STUDY_GAINS) + "\n"
    return parse_mission(text, "published.yaml", ts100)


@pytest.fixture(scope="session")
def flight(docking: Mission, ts100: Vehicle) -> Result:
    return simulate(docking, ts100)
