"""Bumpless switching: the ramp kappa, frozen pre-switch values, aligned integrals.

Source: Gao et al. 2026, eq. (54)-(56), Proposition 1. The same ramp blends in parameters that an
operator changes while a mission runs.
"""

from twin.compiled import jit
from twin.pid import align_integrals


@jit
def begin_ramp(settings, gains, a):
    """Start a transition in this cycle: freeze what is in force and align the integrals.

    gains: MODE_CONTROL of the mode to come. With the ramp switched off kappa is 1 at once.
    """
    a.ramp_cycle = a.cycle
    a.ramp_length = gains.n_sw
    for i in range(6):
        a.tau_minus[i] = a.tau_d[i]
        a.Q_minus[i] = a.Q[i]
    for i in range(a.R.shape[0]):
        a.R_minus[i] = a.R[i]
    a.lam_minus = a.lam
    if settings.align == 1:
        align_integrals(settings, gains, a, a.tau_c)


@jit
def transition_factor(settings, a):
    """kappa of eq. (54): 0 in the cycle of the switch, 1 after N_sw cycles."""
    if settings.ramp == 0 or a.ramp_length <= 0.0:
        return 1.0
    return min(1.0, max(0.0, (a.cycle - a.ramp_cycle) / a.ramp_length))


@jit
def blend(gains, a):
    """Eq. (55): fill a.tau_d, a.Q, a.R, a.lam by kappa between the frozen and the mode's own values."""
    k = a.kappa
    for i in range(6):
        a.tau_d[i] = (1.0 - k) * a.tau_minus[i] + k * a.tau_plus[i]
        a.Q[i] = (1.0 - k) * a.Q_minus[i] + k * gains.Q[i]
    for i in range(a.R.shape[0]):
        a.R[i] = (1.0 - k) * a.R_minus[i] + k * gains.R[i]
    a.lam = (1.0 - k) * a.lam_minus + k * gains.lam
