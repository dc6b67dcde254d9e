"""The softened problem of S6: slack and priorities are what the joint problem's optimum says they are."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from bumpless import records
from bumpless.control.pid import proportional
from bumpless.control.switching import report_slack, soften

weight = st.floats(0.01, 50.0)


@settings(max_examples=50)
@given(st.lists(weight, min_size=6, max_size=6), st.lists(weight, min_size=6, max_size=6), st.data())
def test_slack_is_eliminated_exactly(q: list[float], p: list[float], data: st.DataObject) -> None:
    """Protects: min over s of ||r - s||_QW^2 + ||s||_P^2 equals ||r||_a.Q^2, and a.slack is its minimiser."""
    w = np.array(data.draw(st.lists(weight, min_size=6, max_size=6)))
    r = np.array(data.draw(st.lists(st.floats(-5, 5), min_size=6, max_size=6)))
    s, a = np.zeros(1, records.SETTINGS)[0], np.zeros(1, records.AUTOPILOT)[0]
    s["priority"], s["slack_price"] = w, p
    a["Q_mode"], a["fault_share"], a["tau_d"] = q, 1.0, r
    soften(s, a)
    report_slack(s, a)
    qw, p_ = np.array(q) * w, np.array(p)
    joint = qw * (r - a["slack"]) ** 2 + p_ * a["slack"] ** 2
    np.testing.assert_allclose(joint, a["Q"] * r**2, rtol=1e-9, atol=1e-12)
    for nudge in (-1e-3, 1e-3):
        moved = qw * (r - a["slack"] - nudge) ** 2 + p_ * (a["slack"] + nudge) ** 2
        assert (moved >= joint - 1e-12).all()


def test_nothing_is_softened_before_a_fault() -> None:
    """Protects: S6 is S4 until the fault is known, and zero slack price means no slack at all."""
    s, a = np.zeros(1, records.SETTINGS)[0], np.zeros(1, records.AUTOPILOT)[0]
    s["priority"], s["slack_price"] = 3.0, 2.0
    a["Q_mode"], a["tau_d"] = [1, 0, 2, 4, 4, 4], 1.0
    soften(s, a)
    report_slack(s, a)
    assert np.array_equal(a["Q"], a["Q_mode"]) and not a["slack"].any()
    a["fault_share"], s["slack_price"] = 1.0, 0.0
    soften(s, a)
    report_slack(s, a)
    assert np.array_equal(a["Q"], 3.0 * a["Q_mode"]) and not a["slack"].any()


def test_gains_change_once_a_fault_is_known() -> None:
    """Protects: S6 flies S4's gains until the fault is known; then factors on them are blended in."""
    s, a = np.zeros(1, records.SETTINGS)[0], np.zeros(1, records.AUTOPILOT)[0]
    gains = np.zeros(1, records.MODE_CONTROL)[0]
    s["fault_gains"] = [[8.0] * 6, [1.0] * 6, [6.0] * 6]
    gains["K_P"], gains["K_D"] = 2.0, 3.0
    a["smooth_error"], a["smooth_rate"], a["schedule"] = 0.5, 0.1, 1.0
    demanded = []
    for share in (0.0, 0.5, 1.0):
        a["fault_share"] = share
        demanded.append(proportional(s, gains, a, 4))
    np.testing.assert_allclose(demanded, [1.3, 4.5 * 1.0 + 3.5 * 0.3, 8 * 1.0 + 6 * 0.3])
