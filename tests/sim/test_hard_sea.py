"""Whole flights with errors of sensors and sea: navigation copes; what is silent changes nothing."""

from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import parse_mission
from bumpless.contract.enums import HOVER
from bumpless.sim.log import LOG
from bumpless.sim.twin import simulate

MISSIONS = Path(__file__).parents[2] / "missions"
SILENT = """
environment: {beam_attenuation_per_m: 1.0e-9, water_depth_m: 50}
sensors:
  detection: {latency_s: 0, outlier_probability: 0, marker_angle_max_deg: 179.9}
  dvl: {altitude_max_m: 60}
  usbl: {rate_hz: 2, position_m: [1, 0, 0], range_max_m: 0.1, range_noise_m: 0.1, angle_noise_deg: 1}
  near_camera:
    {position_m: [1, 0, 0], pitch_down_deg: 0, field_of_view_half_deg: 30, range_min_m: 0, range_max_m: 0.01}
trim: {}
"""


def test_what_is_fitted_and_says_nothing_changes_nothing(ts100, docking, flight) -> None:
    """Protects: new sensors and errors draw beside the old ones' noise, so that old flights stay as they were
    to the bit."""
    log = simulate(parse_mission(docking.text + SILENT, "silent.yaml", ts100), ts100).log
    for name in set(LOG.names or ()) - {"solve_time"}:
        assert np.array_equal(log[name], flight.log[name], equal_nan=True), name


def flown(name: str, vehicle, seed: int, change: tuple[str, str] = ("", "")) -> np.ndarray:
    text = (MISSIONS / f"{name}.yaml").read_text()
    assert change[0] in text
    return simulate(parse_mission(text.replace(*change), name, vehicle), vehicle, seed=seed).log


def target_error(log: np.ndarray) -> np.ndarray:
    """Of the believed place, m."""
    return np.linalg.norm(log["target"][:, :3] - log["target_true"], axis=1)


@pytest.mark.parametrize("seed", [11, 1, 2])
def test_usbl_leads_to_a_dock_that_the_camera_sees_late(ts100, seed: int) -> None:
    """Protects: a dock 2.5 m off its planned place is known to 0.3 m before the camera sees it in turbid
    water, and the flight ends in hover before it in spite of latency and false sights."""
    log = flown("homing_turbid_water", ts100, seed)
    first = int(np.argmax(log["detected"] == 1))
    assert target_error(log)[first - 100 : first].max() < 0.3
    assert log["mode"][-1] == HOVER and log["range_true"][-200:].max() < 0.2


def test_without_usbl_the_dock_is_where_the_plan_has_it(ts100) -> None:
    """Protects: that it is USBL that leads: out of its range the dock is believed 2.5 m off until the camera
    sees it."""
    log = flown("homing_turbid_water", ts100, 11, ("range_max_m: 150", "range_max_m: 1"))
    first = int(np.argmax(log["detected_raw"] == 1))
    assert target_error(log)[:first].min() > 2.4


LOST = """
sensors: {dvl_outages: [{from_s: 15, to_s: 60, water_track: %s}]}
environment: {current_ned_mps: [-0.05, 0, 0]}
"""


@pytest.mark.parametrize("water_track", ["true", "false"])
def test_a_lost_log_is_bridged(ts100, docking, water_track: str) -> None:
    """Protects: 45 s without the bottom, braking and turning to hover, by water track or by the model alone,
    leave the dead reckoning within 0.3 m, and the flight ends in hover."""
    log = simulate(parse_mission(docking.text + LOST % water_track, "lost.yaml", ts100), ts100).log
    off = np.linalg.norm(log["eta_hat"][:, :2] - log["eta"][:, :2], axis=1)
    assert off.max() < 0.3
    assert log["mode"][-1] == HOVER and log["range_true"][-200:].max() < 0.2


def test_the_bottom_is_lost_and_the_flight_goes_on(ts100) -> None:
    """Protects: the example with the bottom out of reach, a current that changes with depth, a heading that
    drifts and a moved weight ends in hover within 0.3 m."""
    log = flown("docking_bottom_lost", ts100, 3)
    assert log["mode"][-1] == HOVER and log["range_true"][-1] < 0.3
