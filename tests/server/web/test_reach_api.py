"""What the actuators can do, over HTTP: the sets themselves, and the one margin of planner and console."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from bumpless.config.vehicle import load_vehicle
from bumpless.physics.envelope import attainable_sets
from bumpless.physics.model import build_model
from bumpless_server.foresight.margin import margins
from bumpless_server.foresight.reach import reach_at
from bumpless_server.settings import Settings
from bumpless_server.web.answers.reach import ReachAnswer
from tests.server.serving import Running, serving


@pytest.fixture
def alone(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle."""
    with serving(make_settings(manage_node=False)) as server:
        yield server


def test_reach_and_margin_are_those_of_the_sets() -> None:
    """Protects: the bounds on the bars lie on the hulls, and a margin seen live equals the planner's."""
    vehicle = load_vehicle("ts100")
    told = ReachAnswer.of(vehicle.sha256, reach_at(vehicle, 0.512))
    assert told.surge_mps == 0.5
    sets = attainable_sets(build_model(vehicle), 0.5, 240)
    corners = np.hstack([sets.force.vertices, sets.moment.vertices])
    acts = np.array(told.high) > 0.0
    assert np.allclose(np.array(told.high)[acts], corners.max(axis=0)[acts], rtol=2e-5)
    assert np.allclose(np.array(told.low)[acts], corners.min(axis=0)[acts], rtol=2e-5)
    assert (np.array(told.most) >= np.maximum(told.high, -np.array(told.low)) - 1e-5).all()
    demand = 0.6 * corners[10]
    used = max((np.array(told.force) @ demand[:3]).max(), (np.array(told.moment) @ demand[3:]).max())
    assert 1.0 - used == pytest.approx(margins(demand[None], np.array([0.5]), vehicle)[0], abs=1e-4)


def test_without_a_vehicle_nothing_is_told(alone: Running) -> None:
    """Protects from sets of a vehicle that is not there, and from speeds that are no numbers."""
    assert alone.http.get("/api/vehicle/reach").status_code == 404
    for wrong in ("nan", "inf", "1e9", "x"):
        assert alone.http.get("/api/vehicle/reach", params={"surge_mps": wrong}).status_code == 422
    assert alone.http.get("/api/vehicle/station").json() is None
    assert alone.http.get("/api/alarms/limits").json()["depth_m"] == 0.3
