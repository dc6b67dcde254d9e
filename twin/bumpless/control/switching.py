"""Bumpless switching: the ramp kappa and frozen pre-switch values.

Source: Gao et al. 2026, eq. (54)-(55), Proposition 1; what becomes of the integrals, eq. (56), is in `pid`.
The same ramp blends in parameters that an operator changes while a mission runs.
Beyond the paper: a mode may own a share of the increment bound, which ramps as the weights do; the ramp
may tighten that bound further, or price increments.
"""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n
from bumpless.config.parameters.records import section_dtype, word_codes
from bumpless.jit import jit

f8, i8 = np.float64, np.int64

KEEP, RESCALE, RESET = word_codes("bumpless", "integral_at_switch")  # of integrals that are not aligned

SWITCHING_SETTINGS = section_dtype("bumpless")

MODE_SETTINGS = section_dtype("forward")  # of each mode

BLENDED = np.dtype(  # what the ramp blends
    [
        ("tau_d", f8, 6),  # N and N m
        ("Q", f8, 6),  # before priorities and slack
        ("R", f8, _n),
        ("lam", f8),
        ("increment_share", f8),
    ],
    align=True,
)

SWITCHING_STATE = np.dtype(
    [
        ("ramp_cycle", i8),  # k at which the present ramp began
        ("ramp_length", f8),  # cycles
        ("kappa", f8),
        ("now", BLENDED),  # in force
        ("minus", BLENDED),  # frozen when the ramp began
    ],
    align=True,
)

SWITCHING_OUTPUT = np.dtype(
    [
        ("step_share", f8),  # of the rate limit, in force in this cycle
        ("increment_price", f8),
    ],
    align=True,
)


@jit
def begin_ramp(cycle, mode, switching):
    """Start a transition into `mode` (MODE_SETTINGS) in this cycle: freeze what is in force."""
    switching.ramp_cycle, switching.ramp_length = cycle, mode.n_sw
    now, minus = switching.now, switching.minus
    for i in range(6):
        minus.tau_d[i], minus.Q[i] = now.tau_d[i], now.Q[i]
    for i in range(now.R.shape[0]):
        minus.R[i] = now.R[i]
    minus.lam, minus.increment_share = now.lam, now.increment_share


@jit
def transition_factor(settings, cycle, switching):
    """kappa: 0 in the cycle of the switch, 1 after N_sw cycles; 1 at once without a ramp.

    Source: eq. (54). Beyond the paper (`ramp_smooth`): 6 x^5 - 15 x^4 + 10 x^3 of that, twice differentiable
    at both ends.
    """
    if settings.ramp == 0 or switching.ramp_length <= 0.0:
        return 1.0
    x = min(1.0, max(0.0, (cycle - switching.ramp_cycle) / switching.ramp_length))
    return x * x * x * (10.0 + x * (6.0 * x - 15.0)) if settings.ramp_smooth == 1 else x


@jit
def blend(mode, tau_plus, switching):
    """Fill switching.now by kappa between the frozen values and the mode's own; tau_plus (6,) is
    what its PID demands, N and N m. Source: eq. (55)."""
    k, now, minus = switching.kappa, switching.now, switching.minus
    for i in range(6):
        now.tau_d[i] = (1.0 - k) * minus.tau_d[i] + k * tau_plus[i]
        now.Q[i] = (1.0 - k) * minus.Q[i] + k * mode.Q[i]
    for i in range(now.R.shape[0]):
        now.R[i] = (1.0 - k) * minus.R[i] + k * mode.R[i]
    now.lam = (1.0 - k) * minus.lam + k * mode.lam
    now.increment_share = (1.0 - k) * minus.increment_share + k * mode.increment_share


@jit
def limit_increments(settings, increment_price, switching, out):
    """Fill the SWITCHING_OUTPUT: the ramp tightens the increment bound and prices increments."""
    k, tight = switching.kappa, settings.ramp_increment_share
    out.step_share = switching.now.increment_share * (tight + (1.0 - tight) * k**4)
    out.increment_price = increment_price + (1.0 - k) * settings.ramp_increment_price
