"""Dead reckoning: a sensor that fails for a moment must not spoil the estimate for ever."""

import numpy as np
import pytest

from bumpless import records
from bumpless.control.navigation import navigate
from bumpless.control.pid import smooth_errors


@pytest.mark.parametrize("name", ["attitude", "rates", "velocity", "water_velocity", "depth", "target"])
def test_a_sample_that_is_no_number_is_passed_over(name):
    """Protects: one NaN from any sensor leaves every estimate finite, then and afterwards."""
    settings, sensors, m, a = (
        np.zeros(1, kind)[0]
        for kind in (records.SETTINGS, records.SENSORS, records.MEASUREMENT, records.AUTOPILOT)
    )
    settings["dt"], sensors["dvl_period"], sensors["camera_period"] = 0.05, 2, 2
    m["velocity_valid"] = m["fresh"] = m["detected"] = 1
    m["velocity"][0] = m["water_velocity"][0] = 0.4
    work, sound = np.zeros(16), m[name].copy()
    for cycle in range(40):
        bad = cycle in (0, 17)
        if np.ndim(sound):
            m[name][:] = np.nan if bad else sound
        else:
            m[name] = np.nan if bad else sound
        navigate(settings, sensors, m, a, work)
        a["cycle"] += 1
        for field in ("eta", "nu", "nu_r", "current", "target"):
            assert np.isfinite(a[field]).all(), field


def test_an_angle_error_stays_the_short_way_round():
    """Protects: an error that passes half a turn does not leave a whole turn behind in its filter."""
    settings, a = np.zeros(1, records.SETTINGS)[0], np.zeros(1, records.AUTOPILOT)[0]
    settings["dt"] = 0.05
    for error in (3.1, -3.1, -2.0, 0.0):
        a["error"][5] = error
        smooth_errors(settings, a)
        assert a["smooth_error"][5] == pytest.approx(error)
