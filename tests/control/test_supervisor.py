"""The mode automaton: with the filter off it is the published one, but for the order of two guards."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.control.supervisor import (
    SUPERVISOR_SETTINGS,
    SUPERVISOR_STATE,
    filter_detection,
    next_mode,
    supervise,
)

F, R, H = FORWARD, REVERSE, HOVER


@pytest.fixture(scope="module")
def s():
    out = np.zeros(1, SUPERVISOR_SETTINGS)[0]
    for name, value in {"d_rh_l": 0.6, "d_rh_u": 1.5, "d_fr_l": 8.0, "d_fr_u": 12.0, "d_hf_u": 16.0}.items():
        out[name] = value
    out["n_dwell"], out["hits"], out["window"], out["hold"] = 40, 1, 1, 0
    return out


@given(st.sampled_from([F, R, H]), st.sampled_from([0, 1]), st.floats(0, 30))
def test_guards_are_those_of_equation_53(s, mode, chi, d):
    """Protects: every transition of eq. (53), tested against the equation written as a table."""
    expected = mode
    if mode == F and chi == 1 and d <= 8.0:
        expected = R
    elif mode == R and chi == 1 and d <= 0.6:
        expected = H
    elif mode == R and (chi == 0 or d >= 12.0):
        expected = F
    elif mode == H and (chi == 0 or d >= 16.0):
        expected = F
    elif mode == H and chi == 1 and d >= 1.5:
        expected = R
    assert next_mode(s, mode, chi, d) == expected


@given(st.integers(0, 200))
def test_no_switch_before_the_dwell_time(s, waited):
    """Protects: the average-dwell-time bound of eq. (59)."""
    state = np.zeros(1, SUPERVISOR_STATE)[0]
    state["mode"], state["switch_cycle"], state["detected"] = F, 0, 1
    assert supervise(s, state, waited, 1.0, False) == (F if waited < 40 else R)
    assert supervise(s, state, waited, 1.0, True) == F


@given(st.lists(st.sampled_from([0, 1]), max_size=60))
def test_filter_off_passes_the_raw_flag(s, frames):
    """Protects: with M = N = 1 and no hold the published automaton comes out exactly."""
    state = np.zeros(1, SUPERVISOR_STATE)[0]
    for raw in frames:
        filter_detection(s, raw, state)
        assert state["detected"] == raw


@given(
    st.lists(st.sampled_from([0, 1]), max_size=80), st.integers(1, 6), st.integers(0, 9), st.integers(0, 5)
)
def test_filter_is_m_of_n_with_hold(s, frames, hits, hold, more):
    """Protects: one missed frame does not throw the vehicle out of hover, and a true loss does."""
    window = hits + more
    t = s.copy()
    t["hits"], t["window"], t["hold"] = hits, window, hold
    state = np.zeros(1, SUPERVISOR_STATE)[0]
    passed_ago = None
    for k, raw in enumerate(frames):
        filter_detection(t, raw, state)
        recent = sum(frames[max(0, k - window + 1) : k + 1])
        passed_ago = 0 if recent >= hits else (None if passed_ago is None else passed_ago + 1)
        assert state["detected"] == int(passed_ago is not None and passed_ago <= hold)
