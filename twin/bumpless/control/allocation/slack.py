"""Priorities and slack once a fault is known, blended in with it.

min ||tau_d - s - G||_QW^2 + ||s||_P^2 over s gives s = QW / (QW + P) (tau_d - G) and the weight
QW P / (QW + P); W = priority, P = slack_price, and P = 0 stands for no slack at all.
"""

from bumpless.jit import jit


@jit
def soften(settings, Q_mode, fault_share, Q):
    """Fill Q (6,), what is solved with, from Q_mode (6,). settings: ALLOCATION_SETTINGS; fault_share: how far
    a known fault is blended in."""
    b = fault_share
    for i in range(6):
        q = Q_mode[i] * (1.0 + b * (settings.priority[i] - 1.0))
        p = settings.slack_price[i]
        Q[i] = q - b * q * q / (q + p) if p > 0.0 and q > 0.0 else q


@jit
def report_slack(settings, Q_mode, fault_share, tau_d, tau_c, slack):
    """Fill slack (6,), N and N m: the part of tau_d that the softened problem gave up."""
    b = fault_share
    for i in range(6):
        q = Q_mode[i] * (1.0 + b * (settings.priority[i] - 1.0))
        p = settings.slack_price[i]
        slack[i] = b * q / (q + p) * (tau_d[i] - tau_c[i]) if p > 0.0 and q > 0.0 else 0.0
