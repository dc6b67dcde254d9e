"""The way round to the approach line: short, turned once, and told as it is flown."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.contract.enums import ENTRY
from bumpless.control.docking.entry import choose_way, circle_heading
from bumpless.feasibility.reach import docking_settings
from bumpless.sim.twin import Twin, simulate

MISSIONS, NAME = Path(__file__).parents[3] / "missions", "docking_into_current.yaml"
POINT, MARKER, KEEP = np.array([0.0, 0.0, 2.0]), np.array([1.5, 0.0, 2.0]), 6.0  # a dock to the north
RADIUS = 6.0


def way(ts100, north: float, east: float, psi_deg: float) -> tuple[float, SimpleNamespace]:
    """The way to a line that leads north, from a place and a heading: its length, m, and what was chosen."""
    settings = docking_settings(default_parameters(ts100).docking)
    docking = SimpleNamespace(heading=0.0, side=0, farther=-1.0)
    eta = np.array([north, east, 2.0, 0.0, 0.0, np.radians(psi_deg)])
    length = choose_way.py_func(settings, KEEP, eta, MARKER, POINT, docking)
    docking.first, _ = circle_heading.py_func(settings, eta, POINT, docking)
    return float(length), docking


def test_the_way_round_is_turned_once_each_way_and_followed(ts100) -> None:
    """Protects: the vehicle swung past the line's beginning and back, and lagged 20 deg in each turn."""
    text = (MISSIONS / NAME).read_text()
    log = simulate(parse_mission(text, NAME, ts100), ts100).log
    rows = log[log["stage"] == ENTRY]
    psi = np.degrees(np.unwrap(rows["eta"][:, 5]))
    lag = np.degrees(np.unwrap(rows["eta"][:, 5] - rows["reference"][:, 5], period=2.0 * np.pi))
    assert np.abs(np.diff(psi)).sum() < 320.0  # a right angle out and three quarters of a circle back at most
    assert np.abs(lag).max() < 15.0
    assert np.abs(rows["cross_track"]).max() < 0.3  # of the way that is flown, not of the line to come


def test_a_pause_in_a_turn_feeds_no_turn(ts100) -> None:
    """Protects: who holds station in a pause is not asked for the moment of the turn that was flown."""
    twin = Twin(ts100)
    twin.start(parse_mission((MISSIONS / NAME).read_text(), NAME, ts100))
    while abs(twin.onboard["state"]["docking"]["turn"]) < 0.1:
        twin.step()
    twin.pause()
    twin.step()
    assert twin.onboard["state"]["docking"]["turn"] == 0.0


def test_straight_on_to_the_line_is_no_way_round(ts100) -> None:
    """Protects: the length of the way where there is nothing to turn."""
    length, _ = way(ts100, -40.0, 0.0, 0.0)
    begins = default_parameters(ts100).docking.entry_distance_m
    assert length == pytest.approx(40.0 - begins, abs=0.01)


def test_a_half_circle_joins_from_abeam(ts100) -> None:
    """Protects: the turn on to the line is taken at its beginning, to the side that is nearer."""
    begins = default_parameters(ts100).docking.entry_distance_m
    length, chosen = way(ts100, -begins + 5.0, 2.0 * RADIUS, 180.0)
    assert chosen.side == 1 and chosen.farther == 0.0
    assert length == pytest.approx(5.0 + np.pi * RADIUS, abs=0.5)


@pytest.mark.parametrize("psi_deg", [5.0, -5.0])
def test_the_first_turn_does_not_sweep_over_a_near_dock(ts100, psi_deg) -> None:
    """Protects: a vehicle that went round from the hold point turned across the dock, and into it."""
    _, chosen = way(ts100, -9.0, 0.0, psi_deg)
    assert np.sin(chosen.first - np.radians(psi_deg)) * psi_deg > 0.0  # on, to the side it points to already


@pytest.mark.parametrize("seed", range(8))
def test_there_is_always_a_way(ts100, seed) -> None:
    """Protects: a place and heading from which no short turn fits still gets a way that can be flown."""
    r = np.random.Generator(np.random.PCG64([9, seed]))
    for _ in range(200):
        north, east = r.uniform(-60.0, 60.0, 2)
        length, chosen = way(ts100, north, east, r.uniform(-180.0, 180.0))
        least = np.hypot(north + default_parameters(ts100).docking.entry_distance_m, east)
        assert least - 8.0 <= length < least + 110.0 and chosen.side in (-1, 1)
