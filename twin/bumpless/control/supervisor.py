"""Which mode to fly: hysteresis on range, minimum dwell, and a filter in front of the detection flag.

Source: Gao et al. 2026, eq. (53).
Differs: in H the farther threshold is tested first, because as printed H to R shadows H to F when
the target is seen beyond d_HF^U; and an M-of-N filter with a hold time keeps one missed frame from
throwing the vehicle from hover to forward. With window = hits = 1 and hold = 0 the filter is off.
"""

import numpy as np

from bumpless.config.parameters.records import section_dtype
from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.jit import jit

f8, i8 = np.float64, np.int64

MAX_WINDOW = 62  # bits of detection history kept

SUPERVISOR_SETTINGS = section_dtype("supervisor")  # thresholds in m, counts in cycles

SUPERVISOR_STATE = np.dtype(
    [
        ("mode", i8),  # FORWARD, REVERSE or HOVER, as all modes
        ("previous_mode", i8),
        ("switch_cycle", i8),  # k_s of the last mode switch
        ("history", i8),  # raw detections, newest in bit 0
        ("hold_left", i8),
        ("detected", i8),  # chi
        ("hover_cycles", i8),  # in a row in H and in range
    ],
    align=True,
)


@jit
def filter_detection(settings, raw, state):
    """Feed one raw detection (0 or 1); state.detected becomes chi: M hits of the last N frames, then held."""
    window = min(max(1, settings.window), MAX_WINDOW)
    state.history = ((state.history << 1) | raw) & ((1 << window) - 1)
    hits, bits = 0, state.history
    while bits:
        bits &= bits - 1
        hits += 1
    if hits >= settings.hits:
        state.detected = 1
        state.hold_left = settings.hold
    elif state.hold_left > 0:
        state.hold_left -= 1
    else:
        state.detected = 0


@jit
def next_mode(settings, mode, chi, d):
    """sigma(k+1) once the dwell time is over; chi in {0, 1}, d in m. Source: Gao et al. 2026, eq. (53)."""
    if mode == FORWARD:
        return REVERSE if chi == 1 and d <= settings.d_fr_l else FORWARD
    if mode == REVERSE:
        if chi == 1 and d <= settings.d_rh_l:
            return HOVER
        return FORWARD if chi == 0 or d >= settings.d_fr_u else REVERSE
    if chi == 0 or d >= settings.d_hf_u:
        return FORWARD
    return REVERSE if d >= settings.d_rh_u else HOVER


@jit
def supervise(settings, state, cycle, d, going_around):
    """The mode for this cycle, from the mode in force, chi and the range d, m; the dwell counter decides if
    at all.

    going_around: on the way back after a missed approach a glimpse of the target is no approach.
    """
    if cycle - state.switch_cycle < settings.n_dwell or (going_around and state.mode == FORWARD):
        return state.mode
    return next_mode(settings, state.mode, state.detected, d)


@jit
def change_mode(mode, cycle, state):
    """Enter `mode` in this cycle."""
    state.previous_mode, state.mode = state.mode, mode
    state.switch_cycle = cycle


@jit
def in_range(settings, d, holding, state):
    """Whether this is H in range d, m; holding station elsewhere is not."""
    return state.mode == HOVER and not holding and d <= settings.d_rh_u


@jit
def count_hover(in_place, state):
    """Count the cycles in a row in which the vehicle hovers in place."""
    state.hover_cycles = state.hover_cycles + 1 if in_place else 0
