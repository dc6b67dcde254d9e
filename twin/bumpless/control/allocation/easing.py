"""What an eased screw misses: the thrust between n|n| = x and the speed that `to_command` gives.

Easing lets a screw pass through zero with a finite slope, and misses thrust for it on both sides. Beyond the
paper: away from zero that thrust can be asked for in the next cycle, as the map's inflow term is one cycle
old; within x_0 of zero, where easing keeps the commands calm, this fades out.
"""

from bumpless.jit import jit
from bumpless.physics.actuators import add_missed


@jit
def missed_wrench(model, u, effectiveness, out):
    """Fill out (6,), N and N m: what eased screws miss at the commands u (8,), faded out near zero."""
    for k in range(6):
        out[k] = 0.0
    if model.smoothing <= 0.0:
        return
    for i in range(model.n_u):
        add_missed(model, i, u, effectiveness[i], out)
