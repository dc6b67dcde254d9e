"""Fixtures: a vehicle and a flown mission that many rooms' tests look at; each is made once."""

from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.physics.model import build_model
from bumpless.sim.twin import Result, simulate

MISSIONS = Path(__file__).parents[1] / "missions"


@pytest.fixture(scope="session")
def ts100() -> Vehicle:
    return load_vehicle("ts100")


@pytest.fixture(scope="session")
def model(ts100: Vehicle) -> np.record:
    return build_model(ts100)


@pytest.fixture(scope="session")
def docking(ts100: Vehicle) -> Mission:
    return parse_mission((MISSIONS / "docking.yaml").read_text(), "docking.yaml", ts100)


@pytest.fixture(scope="session")
def flight(docking: Mission, ts100: Vehicle) -> Result:
    return simulate(docking, ts100)
