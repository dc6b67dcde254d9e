"""Bumpless switching: the ramp kappa, frozen pre-switch values, aligned integrals.

Source: Gao et al. 2026, eq. (54)-(56), Proposition 1. The same ramp blends in parameters that an
operator changes while a mission runs.
Beyond the paper: a mode may own a share of the increment bound, which ramps as the weights do; the ramp
may tighten that bound further, or price increments; once a fault is known Q carries priorities and slack.
"""

from bumpless.control.pid import align_integrals, carry_integrals
from bumpless.jit import jit


@jit
def begin_ramp(settings, gains, a):
    """Start a transition in this cycle: freeze what is in force and align the integrals.

    gains: MODE_CONTROL of the mode to come. With the ramp switched off kappa is 1 at once.
    """
    a.ramp_cycle = a.cycle
    a.ramp_length = gains.n_sw
    for i in range(6):
        a.tau_minus[i] = a.tau_d[i]
        a.Q_minus[i] = a.Q_mode[i]
    for i in range(a.R.shape[0]):
        a.R_minus[i] = a.R[i]
    a.lam_minus = a.lam
    a.increment_share_minus = a.increment_share
    carry_integrals(settings, gains, a)
    if settings.align == 1:
        align_integrals(settings, gains, a, a.tau_c)


@jit
def transition_factor(settings, a):
    """kappa of eq. (54): 0 in the cycle of the switch, 1 after N_sw cycles."""
    if settings.ramp == 0 or a.ramp_length <= 0.0:
        return 1.0
    return min(1.0, max(0.0, (a.cycle - a.ramp_cycle) / a.ramp_length))


@jit
def blend(settings, gains, a):
    """Eq. (55): fill a.tau_d, a.Q, a.R, a.lam by kappa between the frozen and the mode's own values; the
    increment bound likewise."""
    k = a.kappa
    for i in range(6):
        a.tau_d[i] = (1.0 - k) * a.tau_minus[i] + k * a.tau_plus[i]
        a.Q_mode[i] = (1.0 - k) * a.Q_minus[i] + k * gains.Q[i]
        a.Q[i] = a.Q_mode[i]
    for i in range(a.R.shape[0]):
        a.R[i] = (1.0 - k) * a.R_minus[i] + k * gains.R[i]
    a.lam = (1.0 - k) * a.lam_minus + k * gains.lam
    a.increment_share = (1.0 - k) * a.increment_share_minus + k * gains.increment_share
    tight = settings.ramp_increment_share
    a.step_share = a.increment_share * (tight + (1.0 - tight) * k**4)
    a.increment_price = settings.increment_price + (1.0 - k) * settings.ramp_increment_price


@jit
def soften(settings, a):
    """Priorities and slack once a fault is known, blended in with it: a.Q becomes what is solved with.

    min ||tau_d - s - G||_QW^2 + ||s||_P^2 over s gives s = QW / (QW + P) (tau_d - G) and the weight
    QW P / (QW + P); W = priority, P = slack_price, and P = 0 stands for no slack at all.
    """
    b = a.fault_share
    for i in range(6):
        q = a.Q_mode[i] * (1.0 + b * (settings.priority[i] - 1.0))
        p = settings.slack_price[i]
        a.Q[i] = q - b * q * q / (q + p) if p > 0.0 and q > 0.0 else q


@jit
def report_slack(settings, a):
    """Fill a.slack (6,), N and N m: the part of tau_d that the softened problem gave up."""
    b = a.fault_share
    for i in range(6):
        q = a.Q_mode[i] * (1.0 + b * (settings.priority[i] - 1.0))
        p = settings.slack_price[i]
        a.slack[i] = b * q / (q + p) * (a.tau_d[i] - a.tau_c[i]) if p > 0.0 and q > 0.0 else 0.0
