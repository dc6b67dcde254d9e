"""What an eased screw misses: the thrust between n|n| = x and the speed that `to_command` gives.

Easing lets a screw pass through zero with a finite slope, and misses thrust for it on both sides. Beyond the
paper: away from zero that thrust can be asked for in the next cycle, as the map's inflow term is one cycle
old; within x_0 of zero, where easing keeps the commands calm, this fades out.
"""

from math import sqrt

from bumpless.control.allocation.wrench_map import thrust_scale, to_x
from bumpless.jit import jit
from bumpless.physics.actuators import add_force
from bumpless.physics.model_record import FIN


@jit
def missed_wrench(model, u, effectiveness, out):
    """Fill out (6,), N and N m: what eased screws miss at the commands u (8,), faded out near zero."""
    for k in range(6):
        out[k] = 0.0
    if model.smoothing <= 0.0:
        return
    z = model.smoothing**2
    for i in range(model.n_u):
        if model.kind[i] != FIN:
            x = to_x(model, i, u[i])
            y = x * x
            missed = (x - x * abs(x) / sqrt(y + z)) * y / (y + z)
            force = effectiveness[i] * thrust_scale(model, i) * missed
            e = model.direction[i]
            add_force(model, i, force * e[0], force * e[1], force * e[2], out)
