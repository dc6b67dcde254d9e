"""The softened problem of S6: slack and priorities are what the joint problem's optimum says they are."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from bumpless.control.allocation.record import ALLOCATION_SETTINGS
from bumpless.control.allocation.slack import report_slack, soften
from bumpless.control.pid import ERRORS, proportional
from bumpless.control.schedule import GAINS, schedule_gains
from bumpless.control.settings import SETTINGS
from bumpless.sim.twin import one

weight = st.floats(0.01, 50.0)


def softened(s: np.void, q: np.ndarray, share: float, r: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(Q that is solved with, slack) for the mode's weights q and a residual r, both (6,)."""
    Q, slack = np.zeros(6), np.zeros(6)
    soften(s, q, share, Q)
    report_slack(s, q, share, r, np.zeros(6), slack)
    return Q, slack


@settings(max_examples=50)
@given(st.lists(weight, min_size=6, max_size=6), st.lists(weight, min_size=6, max_size=6), st.data())
def test_slack_is_eliminated_exactly(q: list[float], p: list[float], data: st.DataObject) -> None:
    """Protects: min over s of ||r - s||_QW^2 + ||s||_P^2 equals ||r||_Q^2, and `slack` is its minimiser."""
    w = np.array(data.draw(st.lists(weight, min_size=6, max_size=6)))
    r = np.array(data.draw(st.lists(st.floats(-5, 5), min_size=6, max_size=6)))
    s = one(ALLOCATION_SETTINGS)[0]
    s["priority"], s["slack_price"] = w, p
    Q, slack = softened(s, np.array(q), 1.0, r)
    qw, p_ = np.array(q) * w, np.array(p)
    joint = qw * (r - slack) ** 2 + p_ * slack**2
    np.testing.assert_allclose(joint, Q * r**2, rtol=1e-9, atol=1e-12)
    for nudge in (-1e-3, 1e-3):
        moved = qw * (r - slack - nudge) ** 2 + p_ * (slack + nudge) ** 2
        assert (moved >= joint - 1e-12).all()


def test_nothing_is_softened_before_a_fault() -> None:
    """Protects: S6 is S4 until the fault is known, and zero slack price means no slack at all."""
    s, q, r = one(ALLOCATION_SETTINGS)[0], np.array([1.0, 0, 2, 4, 4, 4]), np.ones(6)
    s["priority"], s["slack_price"] = 3.0, 2.0
    Q, slack = softened(s, q, 0.0, r)
    assert np.array_equal(Q, q) and not slack.any()
    s["slack_price"] = 0.0
    Q, slack = softened(s, q, 1.0, r)
    assert np.array_equal(Q, 3.0 * q) and not slack.any()


def test_gains_change_once_a_fault_is_known() -> None:
    """Protects: S6 flies S4's gains until the fault is known; then factors on them are blended in."""
    s, errors, gains = one(SETTINGS)[0], one(ERRORS)[0], one(GAINS)[0]
    s["allocation"]["fault_gains"] = [[8.0] * 6, [1.0] * 6, [6.0] * 6]
    mode = s["modes"][0]
    mode["K_P"], mode["K_D"] = 2.0, 3.0
    errors["e"], errors["e_dot"] = 0.5, 0.1
    demanded = []
    for share in (0.0, 0.5, 1.0):
        schedule_gains(s, mode, 1.0, share, 1.0, gains)
        demanded.append(proportional(gains, errors, 4))
    np.testing.assert_allclose(demanded, [1.3, 4.5 * 1.0 + 3.5 * 0.3, 8 * 1.0 + 6 * 0.3])
