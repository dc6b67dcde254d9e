"""What the allocator is told of the water: a smoothed velocity, and of that a share.

Of sway and heave, and of the turning rates, only a share may be seen: what fins do by themselves against
drift and turning then stays with the hull, steadying it, instead of being undone. With no share of either
the map is the published one, alpha = delta. Source: Gao et al. 2026, eq. (15) and below.
"""

from bumpless.jit import jit
from bumpless.physics.lag import lag


@jit
def smooth_flow(dt, settings, first, nu_r, smooth_nu_r):
    """Lag nu_r (6,) into smooth_nu_r (6,), so that noise of the velocity log does not reach the fins
    through the map. first: the filter begins in this cycle. settings: GUIDANCE_SETTINGS."""
    k = 1.0 if first else lag(dt, settings.flow_filter)
    for i in range(6):
        smooth_nu_r[i] += k * (nu_r[i] - smooth_nu_r[i])


@jit
def see_flow(settings, smooth_nu_r, nu_flow):
    """Fill nu_flow (6,), what of the smoothed velocity through water the allocator may see."""
    nu_flow[0] = smooth_nu_r[0]
    for i in range(1, 6):
        nu_flow[i] = smooth_nu_r[i] * (settings.flow_drift if i < 3 else settings.flow_rates)
