"""Dead reckoning: a sensor that fails for a moment must not spoil the estimate for ever."""

import numpy as np
import pytest

from bumpless.control.guidance.record import GUIDANCE_SETTINGS
from bumpless.control.navigation import CLOCK, NAVIGATION_OUTPUT, NAVIGATION_STATE, navigate
from bumpless.control.pid import ERRORS, smooth_errors
from bumpless.physics.sensors import MEASUREMENT, SENSORS


@pytest.mark.parametrize("name", ["attitude", "rates", "velocity", "water_velocity", "depth", "target"])
def test_a_sample_that_is_no_number_is_passed_over(name):
    """Protects: one NaN from any sensor leaves every estimate finite, then and afterwards."""
    clock, sensors, m, state, out = (
        np.zeros(1, kind)[0] for kind in (CLOCK, SENSORS, MEASUREMENT, NAVIGATION_STATE, NAVIGATION_OUTPUT)
    )
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
        navigate(0.05, clock, sensors, m, state, out)
        clock["cycle"] += 1
        assert np.isfinite(out["nu_r"]).all() and np.isfinite(out["depth_rate"])
        for field in ("eta", "nu", "current", "target"):
            assert np.isfinite(state[field]).all(), field


def test_an_angle_error_stays_the_short_way_round():
    """Protects: an error that passes half a turn does not leave a whole turn behind in its filter."""
    settings, errors, smooth = (np.zeros(1, kind)[0] for kind in (GUIDANCE_SETTINGS, ERRORS, ERRORS))
    for error in (3.1, -3.1, -2.0, 0.0):
        errors["e"][5] = error
        smooth_errors(0.05, settings, False, errors, smooth)
        assert smooth["e"][5] == pytest.approx(error)
