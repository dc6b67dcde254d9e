"""Bringing everything to rest."""

from bumpless.contract.enums import SOLVED
from bumpless.control.allocation.bounds import command_bounds
from bumpless.jit import jit
from bumpless.physics.actuators import total_wrench


@jit
def stop_actuators(dt, model, nu_flow, s, out):
    """Bring every actuator to rest as fast as its increment bound allows; nothing is demanded.

    s: STATE, its commands, demand and integrals; out: OUTPUT, its problem's bounds and its solution.
    """
    p, solution, u = out.problem, out.solution, s.allocation.u
    command_bounds(model, u, dt, p.u_lower, p.u_upper, p.du_max)
    for i in range(model.n_u):
        u[i] = min(max(0.0, p.u_lower[i]), p.u_upper[i])
    for k in range(6):
        s.switching.now.tau_d[k] = s.switching.minus.tau_d[k] = out.tau_plus[k] = 0.0
        s.pid.integral[k] = s.pid.bias[k] = 0.0
    total_wrench(model, u, s.belief.effectiveness, nu_flow, s.allocation.tau_c)
    solution.status, solution.iterations = SOLVED, 0
    solution.kkt = solution.cost = solution.solve_time = 0.0
