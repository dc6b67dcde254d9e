"""INS, Doppler log and USBL: their errors are of the size and kind that the data says."""

import numpy as np
import pytest

from tests.physics.sensing import DT, Suite


def test_the_heading_walks_as_its_data_say() -> None:
    """Protects: a drift of 1 deg/sqrt(h) is 1 deg after an hour and 0.5 deg after a quarter of one."""
    walk, ends, quarters = np.radians(1.0) * np.sqrt(10.0 / 3600.0), [], []
    for key in range(200):
        heading = Suite(heading_walk=walk, key=key).hear(360)["attitude"][:, 2]  # cycles of 10 s
        quarters.append(heading[89])
        ends.append(heading[-1])
    assert np.degrees(np.std(ends)) == pytest.approx(1.0, rel=0.15)
    assert np.degrees(np.std(quarters)) == pytest.approx(0.5, rel=0.15)


def test_biases_of_attitude_stay() -> None:
    """Protects: roll and pitch carry their bias, all of a run long, scaled with the noise."""
    suite = Suite(roll_pitch_bias_std=0.01, roll_pitch_bias=[0.02, -0.01], noise_scale=2.0)
    np.testing.assert_allclose(suite.hear(10)["attitude"][:, :2], np.tile([0.04, -0.02], (10, 1)))


@pytest.mark.parametrize(("depth", "bottom"), [(10.0, False), (40.0, True), (79.0, True), (79.8, False)])
def test_the_bottom_is_tracked_between_two_altitudes(depth: float, bottom: bool) -> None:
    """Protects: too high above it and too close the bottom is lost and the water is still tracked."""
    suite = Suite(water_depth=80.0, dvl_altitude_min=0.5, dvl_altitude_max=60.0).put(0.0, down=depth)
    suite.plant["nu"][0], suite.plant["seen"]["current"][0] = 0.7, 0.2
    (m,) = suite.hear()
    assert (m["velocity_valid"], m["water_valid"]) == (int(bottom), 1)
    assert m["water_velocity"][0] == pytest.approx(0.5)
    assert m["velocity"][0] == (pytest.approx(0.7) if bottom else 0.0)


def test_the_log_has_errors_of_scale_and_water_track() -> None:
    """Protects: scale counts on both velocities, the bias on that through water alone."""
    suite = Suite(dvl_scale=0.01, dvl_water_bias=[0.02, 0.0, -0.01])
    suite.plant["nu"][:3], suite.plant["seen"]["current"][0] = (0.8, 0.1, 0.0), 0.2
    (m,) = suite.hear()
    np.testing.assert_allclose(m["velocity"], [0.808, 0.101, 0.0], atol=1e-12)
    np.testing.assert_allclose(m["water_velocity"], [0.6 * 1.01 + 0.02, 0.101, -0.01], atol=1e-12)


def test_an_outage_takes_the_bottom_or_all() -> None:
    """Protects: between its times there is no velocity over ground, and through water as the mission says."""
    suite = Suite(n_dvl_outages=2)
    suite.errors["dvl_outage"][:2] = [(0.975, 1.975, 1), (2.975, 3.975, 0)]
    time = np.arange(100) * DT
    m = suite.hear(100)
    lost = ((time > 0.975) & (time < 1.975)) | ((time > 2.975) & (time < 3.975))
    assert np.array_equal(m["velocity_valid"] == 0, lost)
    assert np.array_equal(m["water_valid"] == 0, (time > 2.975) & (time < 3.975))


USBL = {"usbl_period": 20, "usbl_range_max": 50.0, "usbl_range_std": 0.1, "usbl_angle_std": np.radians(1.0)}


def test_usbl_says_range_and_direction_with_its_noise() -> None:
    """Protects: replies at their rate, right on the average, with the deviations of the data."""
    suite = Suite(**USBL, usbl_position=[0.5, 0.0, 0.0]).put(-20.0, down=7.0, heading=30.0)
    m = suite.hear(20 * 1500)
    fresh = m[m["usbl_fresh"] == 1]
    assert np.array_equal(np.flatnonzero(m["usbl_fresh"]), np.arange(0, len(m), 20))
    c, s = np.cos(np.radians(30)), np.sin(np.radians(30))
    ahead, aside, below = 30 * c - 0.5, -30 * s, -5.0
    expected = [np.hypot(np.hypot(ahead, aside), below), np.arctan2(aside, ahead)]
    expected.append(np.arctan2(below, np.hypot(ahead, aside)))
    np.testing.assert_allclose(fresh["usbl"].mean(axis=0), expected, atol=0.01)
    np.testing.assert_allclose(fresh["usbl"].std(axis=0), [0.1, np.radians(1), np.radians(1)], rtol=0.06)


def test_usbl_ends_at_its_range_and_misses_and_errs_as_often_as_said() -> None:
    """Protects: no reply beyond the range; shares of missed and of false ones."""
    assert Suite(**USBL).put(-41.0).hear(200)["usbl_fresh"].sum() == 0
    suite = Suite(**USBL | {"usbl_period": 1}, usbl_dropout=0.2, usbl_outlier=0.1).put(-20.0)
    m = suite.hear(5000)
    replies = m[m["usbl_fresh"] == 1]["usbl"]
    assert len(replies) / 5000 == pytest.approx(0.8, abs=0.02)
    false = np.abs(replies[:, 1]) > np.radians(6)
    assert false.mean() == pytest.approx(0.1 * (1 - 6 / 180), abs=0.015)
