"""Scheduled PID: tau_d+ = K_P e + K_I e_I + K_D e', with anti-windup from the allocation residual.

Source: Gao et al. 2026, eq. (42)-(44), (56). The integral is kept as K_I e_I in wrench units, so that
a change of K_I does not move it.
Differs: what the allocator could not deliver in a channel while a command with authority there is at a
bound drains that channel's integral (back-calculation), and the offset of eq. (56) is kept apart from the
integral so that it can be bled off; with no bleed the sum is the published law. Errors may be smoothed by
first-order lags, and what an integral becomes at a switch when it is not aligned is chosen: kept in N, kept
as e_I (rescaled), or reset.
Limits of scheduled channels may follow the schedule, so that no more is asked of fins than flow gives.
"""

from math import cos, exp, pi

from bumpless.jit import inline, jit
from bumpless.physics.frames import wrap
from bumpless.records import RESCALE, RESET


@inline
def clip(value, limit):
    return min(max(value, -limit), limit)


@jit
def tracking_error(a):
    """Fill a.error and a.error_rate (6,): [u v z phi theta psi], references minus estimate."""
    r, eta, nu = a.reference, a.eta, a.nu
    a.error[0], a.error[1] = r[0] - nu[0], r[1] - nu[1]
    a.error[2] = r[2] - eta[2]
    a.error[3] = wrap(r[3] - eta[3])
    a.error[4] = wrap(r[4] - eta[4])
    a.error[5] = wrap(r[5] - eta[5])
    a.error_rate[0] = a.error_rate[1] = 0.0
    a.error_rate[2] = -a.depth_rate
    a.error_rate[3], a.error_rate[4] = -nu[3], -nu[4]
    a.error_rate[5] = -nu[5] * cos(eta[3])


@jit
def smooth_errors(settings, a):
    """Advance a.smooth_error and a.smooth_rate (6,), what the PID works on; e and e' without lags."""
    for i in range(6):
        t = settings.error_filter[i]
        k = 1.0 - exp(-settings.dt / t) if t > 0.0 and a.cycle > 0 else 1.0
        gap = a.error[i] - a.smooth_error[i]
        a.smooth_error[i] += k * (wrap(gap) if i > 2 else gap)
        if i > 2 and abs(a.smooth_error[i]) > pi:  # the short way round, as e itself
            a.smooth_error[i] = wrap(a.smooth_error[i])
        t = settings.rate_filter[i]
        k = 1.0 - exp(-settings.dt / t) if t > 0.0 and a.cycle > 0 else 1.0
        a.smooth_rate[i] += k * (a.error_rate[i] - a.smooth_rate[i])


@jit
def gain_share(settings, a):
    """Share of the fin channels' gains at the present speed through water: grows with its square."""
    full = max(settings.schedule_speed, 1e-3)
    return min(max((a.nu_r[0] / full) ** 2, settings.schedule_min), 1.0)


@inline
def after_fault(settings, a, which, i):
    """Factor on K_P, K_I or K_D (which 0, 1, 2) of channel i: 1 until a fault is known, then blended in."""
    return 1.0 + a.fault_share * (settings.fault_gains[which, i] - 1.0)


@inline
def proportional(settings, gains, a, i):
    """K_P e + K_D e' of channel i, gains scheduled."""
    share = 1.0 + settings.scheduled[i] * (a.schedule - 1.0)
    k_p = gains.K_P[i] * after_fault(settings, a, 0, i)
    k_d = gains.K_D[i] * after_fault(settings, a, 2, i)
    return share * (k_p * a.smooth_error[i] + k_d * a.smooth_rate[i])


@jit
def demand(settings, gains, a):
    """Fill a.tau_plus (6,) and advance the integrals by one cycle, with the gains scheduled by a.schedule.

    gains: MODE_CONTROL of the mode.
    """
    keep = exp(-settings.dt / settings.align_bleed) if settings.align_bleed > 0.0 else 1.0
    speed = a.kappa if settings.scale_integration == 1 else 1.0
    for i in range(6):
        share = 1.0 + settings.scheduled[i] * (a.schedule - 1.0)
        room = share if settings.schedule_limits == 1 else 1.0
        rate = after_fault(settings, a, 1, i) * speed * share * gains.K_I[i] * a.smooth_error[i]
        if a.limited[i] == 1 and gains.K_I[i] > 0.0:
            rate -= settings.anti_windup * (a.tau_d[i] - a.tau_c[i])
        a.integral[i] = clip(a.integral[i] + settings.dt * rate, room * gains.integral_limit[i])
        a.bias[i] *= keep
        total = clip(a.integral[i] + a.bias[i], room * gains.integral_limit[i])
        a.tau_plus[i] = clip(proportional(settings, gains, a, i) + total, room * gains.demand_limit[i])
        a.K_I[i] = gains.K_I[i]


@jit
def carry_integrals(settings, gains, a):
    """What K_I e_I becomes when the gains change: kept as it is, kept as e_I, or nothing."""
    for i in range(6):
        if settings.integral_at_switch == RESCALE and a.K_I[i] > 0.0:
            a.integral[i] *= gains.K_I[i] / a.K_I[i]
            a.bias[i] *= gains.K_I[i] / a.K_I[i]
        elif settings.integral_at_switch == RESET:
            a.integral[i] = a.bias[i] = 0.0


@jit
def align_integrals(settings, gains, a, tau_eq):
    """Eq. (56): make tau_plus equal tau_eq (6,) on the aligned channels that have an integral gain."""
    for i in range(6):
        if settings.align_channels[i] > 0.0 and gains.K_I[i] > 0.0:
            wanted = clip(tau_eq[i] - proportional(settings, gains, a, i), gains.integral_limit[i])
            if settings.align_bleed > 0.0:
                a.bias[i] = wanted - a.integral[i]
            else:
                a.integral[i], a.bias[i] = wanted, 0.0
