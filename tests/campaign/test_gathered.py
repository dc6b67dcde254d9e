"""A flight's columns are the same whether its whole log was kept or small blocks of it."""

from collections.abc import Callable
from dataclasses import fields, replace

import numpy as np
import pytest

from bumpless.campaign.flight import Hangar
from bumpless.campaign.gathered import BLOCK
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.replay import replayed
from bumpless.config.mission.shipped import shipped_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.metrics import Columns
from bumpless.metrics.columns import DockColumns, dots, lengths
from bumpless.sim.twin import Twin, simulate


@pytest.mark.parametrize("duration_s", [20.0, BLOCK * 0.05, 45.35])
def test_columns_are_those_of_the_log(campaign: Callable[..., Prepared], duration_s: float) -> None:
    """Protects: no block is lost, doubled or shifted, and the second flight shows nothing of the first."""
    hangar, prepared = Hangar(), campaign(2)
    for number in range(2):
        flight = replayed(prepared, number)
        mission = replace(flight.mission, duration_s=duration_s)
        twin = hangar.twin(flight.vehicle, flight.parameters, {})
        twin.start(mission, None, flight.parameters, flight.alteration)
        gathered = hangar.gatherer.fly(twin)
        whole = simulate(mission, flight.vehicle, flight.parameters, alter=flight.alteration)
        assert_same(gathered, Columns.from_log(whole.log, len(flight.vehicle.commands)))


def test_a_dock_is_gathered_too() -> None:
    """Protects: what is known of a dock to enter comes with the columns, and only where there is one."""
    mission = shipped_mission("remus_docking")
    vehicle = load_vehicle(mission.vehicle)
    twin = Twin(vehicle)
    twin.start(mission)
    gathered = Hangar().gatherer.fly(twin)
    assert gathered.dock is not None
    assert_same(gathered, Columns.from_log(simulate(mission, vehicle).log, len(vehicle.commands)))


@pytest.mark.parametrize("width", range(1, 10))
def test_lengths_and_products_are_numpys(width: int) -> None:
    """Protects: figures do not depend, not in the last digit, on how rows are summed."""
    a, b = np.random.default_rng(width).standard_normal((2, 200, width))
    assert np.array_equal(lengths(a), np.linalg.norm(a, axis=1))
    assert np.array_equal(dots(a, b), np.sum(a * b, axis=1))


def assert_same(a: Columns, b: Columns) -> None:
    """Every column, to the bit; solve times are the machine's."""
    assert (a.dock is None) == (b.dock is None)
    pairs = [(a, b, f.name) for f in fields(Columns) if f.name not in ("dock", "solve_time")]
    pairs += [(a.dock, b.dock, f.name) for f in fields(DockColumns) if a.dock is not None]
    for x, y, name in pairs:
        assert np.array_equal(getattr(x, name), getattr(y, name), equal_nan=True), name
