"""Which mode to fly: hysteresis on range, minimum dwell, and a filter in front of the detection flag.

Source: Gao et al. 2026, eq. (53).
Differs: in H the farther threshold is tested first, because as printed H to R shadows H to F when
the target is seen beyond d_HF^U; and an M-of-N filter with a hold time keeps one missed frame from
throwing the vehicle from hover to forward. With window = hits = 1 and hold = 0 the filter is off.
"""

from bumpless.jit import jit
from bumpless.records import FORWARD, HOVER, REVERSE

MAX_WINDOW = 62  # bits of detection history kept


@jit
def filter_detection(settings, a, raw):
    """Feed one raw detection (0 or 1); a.detected becomes chi: M hits of the last N frames, then held."""
    window = min(max(1, settings.window), MAX_WINDOW)
    a.history = ((a.history << 1) | raw) & ((1 << window) - 1)
    hits, bits = 0, a.history
    while bits:
        bits &= bits - 1
        hits += 1
    if hits >= settings.hits:
        a.detected = 1
        a.hold_left = settings.hold
    elif a.hold_left > 0:
        a.hold_left -= 1
    else:
        a.detected = 0


@jit
def next_mode(settings, mode, chi, d):
    """sigma(k+1) of eq. (53) once the dwell time is over; chi in {0, 1}, d in m."""
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
def supervise(settings, a, going_around):
    """The mode for this cycle, from a.mode, a.detected and a.range; the dwell counter decides if at all.

    going_around: on the way back after a missed approach a glimpse of the target is no approach.
    """
    if a.cycle - a.switch_cycle < settings.n_dwell or (going_around and a.mode == FORWARD):
        return a.mode
    return next_mode(settings, a.mode, a.detected, a.range)
