"""The allocator's wrench map tau_c = G_m(x) and its analytic Jacobian.

Decision variables x are bound-normalised so that every actuator answers from rest; each kind says how, see
`bumpless.physics.actuators`. Bounds in x are exact images of the bounds on the commands.

Source: Gao et al. 2026, eq. (21)-(22), (27)-(36), (46), (50).
"""

from bumpless.jit import jit
from bumpless.physics.actuators import add_map


@jit
def wrench_map(model, x, u_previous, effectiveness, nu_r, tau, jacobian):
    """Fill tau (6,) = G(x) and jacobian (6, 8) = dG/dx, N and N m per unit of x.

    u_previous (8,): last command, for the inflow term; effectiveness (8,): as the allocator believes
    it to be; nu_r (6,): estimated velocity through water. Source: eq. (27)-(34), (46), (50).
    """
    for k in range(6):
        tau[k] = 0.0
        for i in range(jacobian.shape[1]):
            jacobian[k, i] = 0.0
    column = jacobian.T
    for i in range(model.n_u):
        add_map(model, i, x, u_previous, effectiveness[i], nu_r, tau, column)
