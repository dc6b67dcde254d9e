"""Dead reckoning: a sensor that fails for a moment must not spoil the estimate for ever."""

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.vehicle import load_vehicle
from bumpless.control.guidance.record import GUIDANCE_SETTINGS
from bumpless.control.navigation import (
    CLOCK,
    NAVIGATION_OUTPUT,
    NAVIGATION_SETTINGS,
    NAVIGATION_STATE,
    navigate,
)
from bumpless.control.pid import ERRORS, smooth_errors
from bumpless.physics.model import build_model
from bumpless.physics.sensors import MEASUREMENT, SENSORS

MODEL, HEALTHY = build_model(load_vehicle("ts100")), np.ones(MAX_ACTUATORS)


def records() -> list:
    """Settings, clock, sensors, measurement, state and output, all zero."""
    kinds = (NAVIGATION_SETTINGS, CLOCK, SENSORS, MEASUREMENT, NAVIGATION_STATE, NAVIGATION_OUTPUT)
    return [np.zeros(1, kind)[0] for kind in kinds]


@pytest.mark.parametrize("name", ["attitude", "rates", "velocity", "water_velocity", "depth", "target"])
def test_a_sample_that_is_no_number_is_passed_over(name):
    """Protects: one NaN from any sensor leaves every estimate finite, then and afterwards."""
    settings, clock, sensors, m, state, out = records()
    sensors["dvl_period"], sensors["camera_period"] = 2, 2
    m["velocity_valid"] = m["fresh"] = m["detected"] = 1
    m["velocity"][0] = m["water_velocity"][0] = 0.4
    sound = m[name].copy()
    for cycle in range(40):
        bad = cycle in (0, 17)
        if np.ndim(sound):
            m[name][:] = np.nan if bad else sound
        else:
            m[name] = np.nan if bad else sound
        navigate(0.05, settings, clock, sensors, MODEL, HEALTHY, m, state, out)
        clock["cycle"] += 1
        assert np.isfinite(out["nu_r"]).all() and np.isfinite(out["depth_rate"])
        for field in ("eta", "nu", "current", "target"):
            assert np.isfinite(state[field]).all(), field


def test_without_the_bottom_the_last_current_carries_on():
    """Protects: once the bottom is lost, velocity over ground is that through water and the current as last
    estimated, turned with the vehicle: 60 s of speeding up and turning leave 0.1 m of error, not metres."""
    settings, clock, sensors, m, state, out = records()
    sensors["dvl_period"], dt = 2, 0.05
    place, current = np.zeros(2), np.array([0.1, -0.15])
    for cycle in range(round(120 / dt)):
        time, lost = cycle * dt, cycle * dt > 60.0
        psi = 0.01 * max(0.0, time - 60.0)
        c, s = np.cos(psi), np.sin(psi)
        through = np.array([0.5 + 0.005 * max(0.0, time - 60.0), 0.0])
        flow = np.array([c * current[0] + s * current[1], -s * current[0] + c * current[1]])
        m["attitude"][2], m["rates"][2] = psi, 0.01 if lost else 0.0
        m["velocity_valid"], m["water_valid"] = 0 if lost else int(cycle % 2 == 0), int(cycle % 2 == 0)
        m["water_velocity"][:2] = through
        m["velocity"][:2] = 0.0 if lost else through + flow
        navigate(dt, settings, clock, sensors, MODEL, HEALTHY, m, state, out)
        clock["cycle"], clock["time"] = cycle + 1, time + dt
        over = through + flow
        place += dt * np.array([c * over[0] - s * over[1], s * over[0] + c * over[1]])
    np.testing.assert_allclose(state["current"][:2], current, atol=1e-3)
    assert np.hypot(*(state["eta"][:2] - place)) < 0.15


def test_an_angle_error_stays_the_short_way_round():
    """Protects: an error that passes half a turn does not leave a whole turn behind in its filter."""
    settings, errors, smooth = (np.zeros(1, kind)[0] for kind in (GUIDANCE_SETTINGS, ERRORS, ERRORS))
    for error in (3.1, -3.1, -2.0, 0.0):
        errors["e"][5] = error
        smooth_errors(0.05, settings, False, errors, smooth)
        assert smooth["e"][5] == pytest.approx(error)
