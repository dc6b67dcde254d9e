"""The gains of this cycle: the mode's own, scheduled with the flow over the fins and after a fault.

Beyond the paper: limits of scheduled channels may follow the schedule, so that no more is asked of fins than
flow gives; the factors on the gains after a fault are blended in with it.
"""

import numpy as np

from bumpless.jit import inline, jit
from bumpless.physics.lag import decay

f8 = np.float64

GAINS = np.dtype(
    [
        ("dt", f8),  # control period, s
        ("share", f8, 6),  # of the schedule, on K_P and K_D
        ("K_P", f8, 6),
        ("K_I", f8, 6),  # its schedule and the ramp's share of integration in it
        ("K_D", f8, 6),
        ("mode_K_I", f8, 6),  # as the mode has it
        ("stays", f8, 6),  # share of the integral that one cycle leaves; 1 but where docking trims it
        ("ahead", f8, 6),  # fed forward, N and N m
        ("windup", f8, 6),  # 1/s, on the unmet demand; 0 in channels without an integral
        ("keep", f8),  # share of the aligned offset that one cycle leaves
        ("integral_limit", f8, 6),
        ("demand_limit", f8, 6),
    ],
    align=True,
)


@jit
def gain_share(settings, u_r):
    """Share of the fin channels' gains at the speed u_r through water, m/s: grows with its square."""
    full = max(settings.schedule_speed, 1e-3)
    return min(max((u_r / full) ** 2, settings.schedule_min), 1.0)


@inline
def after_fault(factor, fault_share):
    """Factor on a gain: 1 until a fault is known, then blended in with it."""
    return 1.0 + fault_share * (factor - 1.0)


@jit
def schedule_gains(settings, mode, schedule, fault_share, kappa, gains):
    """Fill the GAINS record for `mode` (MODE_SETTINGS) at the share `schedule` of the fin channels' gains.

    settings: SETTINGS. fault_share: how far a known fault is blended in; kappa: of the ramp, eq. (54).
    """
    bumpless, guidance, factors = settings.bumpless, settings.guidance, settings.allocation.fault_gains
    gains.dt = settings.dt
    gains.keep = decay(settings.dt, bumpless.align_bleed) if bumpless.align_bleed > 0.0 else 1.0
    speed = kappa if bumpless.scale_integration == 1 else 1.0
    for i in range(6):
        share = 1.0 + guidance.scheduled[i] * (schedule - 1.0)
        room = share if guidance.schedule_limits == 1 else 1.0
        gains.share[i] = share
        gains.K_P[i] = mode.K_P[i] * after_fault(factors[0, i], fault_share)
        gains.K_I[i] = after_fault(factors[1, i], fault_share) * speed * share * mode.K_I[i]
        gains.K_D[i] = mode.K_D[i] * after_fault(factors[2, i], fault_share)
        gains.mode_K_I[i] = mode.K_I[i]
        gains.stays[i], gains.ahead[i] = 1.0, 0.0
        gains.windup[i] = settings.allocation.anti_windup if mode.K_I[i] > 0.0 else 0.0
        gains.integral_limit[i] = room * mode.integral_limit[i]
        gains.demand_limit[i] = room * mode.demand_limit[i]
