"""All vehicles fly a docking mission with the same code: a vehicle is data."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import COMPLETED, FORWARD, HOVER, REVERSE
from bumpless.sim.twin import Result, Twin, simulate

ROOT = Path(__file__).parents[3]
F, R, H = FORWARD, REVERSE, HOVER
MISSIONS = {
    "ts100": "docking",
    "bluerov2_heavy": "rov_docking",
    "remus100": "remus_docking",
    "twinpod": "azimuth_docking",
}


def mission(vehicle: str) -> Mission:
    path = ROOT / "missions" / f"{MISSIONS[vehicle]}.yaml"
    return parse_mission(path.read_text(encoding="utf-8"), path.name)


@cache
def flight(vehicle: str, seed: int = 1) -> Result:
    return simulate(mission(vehicle), load_vehicle(vehicle), seed=seed)


@pytest.mark.parametrize("vehicle", MISSIONS)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_every_vehicle_flies_forward_reverse_hover(vehicle: str, seed: int) -> None:
    """Protects: F, R, H once each and in this order, upright, within bounds, on any vehicle."""
    log = flight(vehicle, seed).log
    changes = log["mode"][np.flatnonzero(np.diff(log["mode"], prepend=-1))]
    assert changes.tolist() == [F, R, H]
    assert np.abs(np.degrees(log["eta"][:, 3:5])).max() < 15.0
    assert np.all(log["u"] >= log["u_lower"] - 1e-9)
    assert np.all(log["u"] <= log["u_upper"] + 1e-9)
    assert np.isfinite(log["eta"]).all()


@pytest.mark.parametrize("vehicle", ["ts100", "bluerov2_heavy", "twinpod"])
def test_vehicles_that_can_hover_end_at_the_observation_point(vehicle: str) -> None:
    """Protects: station keeping at rest, within a hand's breadth of range and depth."""
    log = flight(vehicle).log
    last = log[-100:]
    assert last["range_true"].max() < 0.15
    assert np.abs(last["eta"][:, 2] - last["observation_point"][:, 2]).max() < 0.15


def test_sideways_thrust_holds_a_cross_current_without_turning() -> None:
    """Protects: the sway channel, which only the ROV has: 0.08 m/s across, heading kept."""
    log = flight("bluerov2_heavy").log
    hover = log[(log["mode"] == H) & (log["time_in_mode"] > 10.0)]
    assert np.abs(np.degrees(hover["eta"][:, 5]) - 20.0).max() < 2.0
    assert np.abs(hover["tau"][:, 1]).mean() > 1.0


def test_depth_by_pitch_without_heave() -> None:
    """Protects: a buoyant vehicle with no vertical thruster follows a depth change of 2 m by pitch alone."""
    result = flight("remus100")
    log = result.log
    assert not np.any(log["tau_d"][:, 2])
    assert np.abs(log["eta"][log["time"] > 20.0, 2] - log["reference"][log["time"] > 20.0, 2]).max() < 0.8
    assert log["eta"][-1, 2] == pytest.approx(7.0, abs=0.35)


def test_what_cannot_stop_docks_by_flying_into_a_funnel() -> None:
    """Protects: the honest docking of such a vehicle: at speed into the mouth, and latched."""
    result = flight("remus100")
    assert result.phase == COMPLETED
    log = result.log
    outside = (log["time"] > 10.0) & (log["nose_depth"] < 0.0)
    assert log["nu"][outside, 0].min() > 1.4
    entered = int(np.argmax(log["nose_depth"] >= 0.0))
    assert 0.0 < log["nose_offset"][entered] < 0.3
    assert log["captured"][-1] == 1 and not log["u"][-1].any()
    assert 100.0 < log["contact_force"].max() < log["contact_most"][0]


def test_what_cannot_stop_circles_while_it_waits() -> None:
    """Protects: pause keeps such a vehicle near, at depth and flying."""
    vehicle = load_vehicle("remus100")
    twin = Twin(vehicle)
    twin.start(mission("remus100"), seed=1)
    step: Callable[[], np.void] = twin.step
    for _ in range(400):
        step()
    twin.pause()
    here = twin.step()["eta"].copy()
    track = np.array([step()["eta"].copy() for _ in range(8000)])[2000:]
    away = np.hypot(track[:, 0] - here[0], track[:, 1] - here[1])
    assert away.max() < 70.0
    assert np.ptp(np.unwrap(track[:, 5])) > 2 * np.pi
    assert np.abs(track[:, 2] - here[2]).max() < 1.5
