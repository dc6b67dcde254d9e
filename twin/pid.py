"""Scheduled PID: tau_d+ = K_P e + K_I e_I + K_D e', with anti-windup from the allocation residual.

Source: Gao et al. 2026, eq. (42)-(44), (56). The integral is kept as K_I e_I in wrench units, so that
a change of K_I does not move it.
Differs: wrench the allocator could not deliver while a command is at a bound drains the integral
(back-calculation), and the offset of eq. (56) is kept apart from the integral so that it can be bled
off; with no bleed the sum is the published law.
"""

from math import cos, exp

from twin.compiled import inline, jit
from twin.frames import wrap


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
def gain_share(settings, a):
    """Share of the fin channels' gains at the present speed through water: grows with its square."""
    full = max(settings.schedule_speed, 1e-3)
    return min(max((a.nu_r[0] / full) ** 2, settings.schedule_min), 1.0)


@inline
def proportional(settings, gains, a, i):
    """K_P e + K_D e' of channel i, gains scheduled."""
    share = 1.0 + settings.scheduled[i] * (a.schedule - 1.0)
    return share * (gains.K_P[i] * a.error[i] + gains.K_D[i] * a.error_rate[i])


@jit
def demand(settings, gains, a):
    """Fill a.tau_plus (6,) and advance the integrals by one cycle. gains: MODE_CONTROL of the mode."""
    a.schedule = gain_share(settings, a)
    keep = exp(-settings.dt / settings.align_bleed) if settings.align_bleed > 0.0 else 1.0
    speed = a.kappa if settings.scale_integration == 1 else 1.0
    for i in range(6):
        share = 1.0 + settings.scheduled[i] * (a.schedule - 1.0)
        rate = speed * share * gains.K_I[i] * a.error[i]
        if a.saturated == 1 and gains.K_I[i] > 0.0:
            rate -= settings.anti_windup * (a.tau_d[i] - a.tau_c[i])
        a.integral[i] = clip(a.integral[i] + settings.dt * rate, gains.integral_limit[i])
        a.bias[i] *= keep
        total = clip(a.integral[i] + a.bias[i], gains.integral_limit[i])
        a.tau_plus[i] = clip(proportional(settings, gains, a, i) + total, gains.demand_limit[i])


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
