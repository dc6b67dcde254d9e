"""What the actuators do, one and all, and how their states follow the commands."""

from bumpless.jit import inline, jit
from bumpless.physics.actuators.dispatch import wrench
from bumpless.physics.actuators.screw_flow import turning


@jit
def actuator_wrench(model, i, u, nu_r, out):
    """Add the wrench of the actuator whose first slot is i, at the commands u (8,), to out (6,)."""
    X, Y, Z, K, M, N = wrench(model, i, u, nu_r)
    out[0] += X
    out[1] += Y
    out[2] += Z
    out[3] += K
    out[4] += M
    out[5] += N


@jit
def total_wrench(model, u, effectiveness, nu_r, out):
    """out (6,) = sum over actuators, each scaled by its effectiveness (1 = healthy).

    Source: Gao et al. 2026, eq. (21).

    Summed in six numbers, not in memory: the compiler then keeps them, and nu_r, in registers.
    """
    X = Y = Z = K = M = N = 0.0
    for i in range(model.n_u):
        x, y, z, k, m, n = wrench(model, i, u, nu_r)
        share = effectiveness[i]
        X, Y, Z = X + share * x, Y + share * y, Z + share * z
        K, M, N = K + share * k, M + share * m, N + share * n
    out[0], out[1], out[2], out[3], out[4], out[5] = X, Y, Z, K, M, N


@inline
def lag_rate(model, i, command, u):
    """Rate of the state u of slot i towards its command: first-order lag within the rate limit."""
    if model.flow == 1:
        command = turning(model, i, command)
    rate = (command - u) / model.time_constant[i]
    limit = model.command_rate[i]
    return min(max(rate, -limit), limit)
