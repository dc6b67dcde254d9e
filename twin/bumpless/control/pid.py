"""Scheduled PID: tau_d+ = K_P e + K_I e_I + K_D e', with anti-windup from the allocation residual.

Source: Gao et al. 2026, eq. (42)-(44), (56). The integral is kept as K_I e_I in wrench units, so that
a change of K_I does not move it.
Differs: what the allocator could not deliver in a channel while a command with authority there is at a
bound drains that channel's integral (back-calculation), and the offset of eq. (56) is kept apart from the
integral so that it can be bled off; with no bleed the sum is the published law. Errors may be smoothed by
first-order lags, and what an integral becomes at a switch when it is not aligned is chosen: kept in N, kept
as e_I (rescaled), or reset.
"""

from math import cos, pi

import numpy as np

from bumpless.control.switching import RESCALE, RESET
from bumpless.jit import inline, jit
from bumpless.physics.frames import wrap
from bumpless.physics.lag import lag

f8, i8 = np.float64, np.int64

ERRORS = np.dtype(  # e = [u v z phi theta psi], references minus estimate, eq. (42)
    [
        ("e", f8, 6),
        ("e_dot", f8, 6),
    ],
    align=True,
)

PID_STATE = np.dtype(
    [
        ("smooth", ERRORS),  # what the PID works on: e and e' after their lags
        ("integral", f8, 6),  # K_I e_I, N or N m
        ("bias", f8, 6),  # aligned offset, bled off
        ("K_I", f8, 6),  # of the last cycle's mode, not scheduled
        ("unmet", f8, 6),  # tau_d - tau_c of the last cycle, N or N m
        ("limited", i8, 6),  # 1 where a bound kept it from being met
    ],
    align=True,
)


@inline
def clip(value, limit):
    return min(max(value, -limit), limit)


@jit
def tracking_error(reference, eta, nu, depth_rate, errors):
    """Fill the ERRORS record from reference (6,) = [u_d v_d z_d phi_d theta_d psi_d] and the estimate.

    Source: eq. (42).
    """
    r, e, e_dot = reference, errors.e, errors.e_dot
    e[0], e[1] = r[0] - nu[0], r[1] - nu[1]
    e[2] = r[2] - eta[2]
    e[3] = wrap(r[3] - eta[3])
    e[4] = wrap(r[4] - eta[4])
    e[5] = wrap(r[5] - eta[5])
    e_dot[0] = e_dot[1] = 0.0
    e_dot[2] = -depth_rate
    e_dot[3], e_dot[4] = -nu[3], -nu[4]
    e_dot[5] = -nu[5] * cos(eta[3])


@jit
def smooth_errors(dt, settings, first, errors, smooth):
    """Advance the ERRORS record `smooth` towards `errors`: a lag for each channel, or none.

    first: the filters begin in this cycle. settings: GUIDANCE_SETTINGS.
    """
    for i in range(6):
        k = 1.0 if first else lag(dt, settings.error_filter[i])
        gap = errors.e[i] - smooth.e[i]
        smooth.e[i] += k * (wrap(gap) if i > 2 else gap)
        if i > 2 and abs(smooth.e[i]) > pi:  # the short way round, as e itself
            smooth.e[i] = wrap(smooth.e[i])
        k = 1.0 if first else lag(dt, settings.rate_filter[i])
        smooth.e_dot[i] += k * (errors.e_dot[i] - smooth.e_dot[i])


@inline
def proportional(gains, errors, i):
    """K_P e + K_D e' of channel i."""
    return gains.share[i] * (gains.K_P[i] * errors.e[i] + gains.K_D[i] * errors.e_dot[i])


@jit
def demand(gains, errors, pid, tau_plus):
    """Fill tau_plus (6,), N and N m, and advance the integrals by one cycle. gains: GAINS of `schedule`.

    Source: eq. (43)-(44).
    """
    for i in range(6):
        rate = gains.K_I[i] * errors.e[i]
        if pid.limited[i] == 1 and gains.windup[i] > 0.0:
            rate -= gains.windup[i] * pid.unmet[i]
        pid.integral[i] = clip(gains.stays[i] * pid.integral[i] + gains.dt * rate, gains.integral_limit[i])
        pid.bias[i] *= gains.keep
        total = clip(pid.integral[i] + pid.bias[i], gains.integral_limit[i])
        wanted = proportional(gains, errors, i) + gains.ahead[i]
        tau_plus[i] = clip(wanted + total, gains.demand_limit[i])
        pid.K_I[i] = gains.mode_K_I[i]


@jit
def note_unmet(tau_d, tau_c, limited, pid):
    """Remember for the next cycle what the allocator left undone, and where a bound is why: limited (6,)."""
    for i in range(6):
        pid.unmet[i], pid.limited[i] = tau_d[i] - tau_c[i], limited[i]


@jit
def carry_integrals(integral_at_switch, mode, pid):
    """What K_I e_I becomes under the gains of `mode`: kept as it is, kept as e_I, or nothing."""
    for i in range(6):
        if integral_at_switch == RESCALE and pid.K_I[i] > 0.0:
            pid.integral[i] *= mode.K_I[i] / pid.K_I[i]
            pid.bias[i] *= mode.K_I[i] / pid.K_I[i]
        elif integral_at_switch == RESET:
            pid.integral[i] = pid.bias[i] = 0.0


@jit
def align_integrals(settings, mode, gains, errors, tau_eq, pid):
    """Make tau_plus equal tau_eq (6,) on the aligned channels that have an integral gain.

    settings: SWITCHING_SETTINGS; mode: MODE_SETTINGS of the mode to come, gains as they are scheduled for it.
    Source: eq. (56).
    """
    for i in range(6):
        if settings.align_channels[i] > 0.0 and mode.K_I[i] > 0.0:
            wanted = clip(tau_eq[i] - proportional(gains, errors, i), mode.integral_limit[i])
            if settings.align_bleed > 0.0:
                pid.bias[i] = wanted - pid.integral[i]
            else:
                pid.integral[i], pid.bias[i] = wanted, 0.0
