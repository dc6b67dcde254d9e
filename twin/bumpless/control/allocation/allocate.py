"""The commands of one cycle by the chosen allocator, and the wrench they achieve."""

from bumpless.config.parameters.records import word_codes
from bumpless.contract.enums import INFEASIBLE, REFUSED
from bumpless.control.allocation.baselines import allocate_direct, allocate_wls
from bumpless.control.allocation.bounds import command_bounds, limited_channels, slow_fins
from bumpless.control.allocation.easing import missed_wrench
from bumpless.control.allocation.mdca import allocate_mdca
from bumpless.jit import jit
from bumpless.jit.clock import monotonic
from bumpless.physics.actuators import total_wrench

MDCA, WLS, PID_DIRECT = word_codes("allocation", "allocator")


@jit
def allocate(handle, settings, model, tau_d, step_share, surge, problem, solution, w):
    """Fill the SOLUTION for the demand tau_d (6,), N and N m; bounds and tau_d of `problem` are filled here,
    its weights, flow, effectiveness and last command are given.

    settings: ALLOCATION_SETTINGS; step_share: of the rate limit, in force in this cycle; surge: m/s, for
    which the direct map is made.
    """
    started = monotonic()  # pyright: ignore[reportCallIssue]
    p = problem
    feasible = command_bounds(model, p.u_previous, p.dt * step_share, p.u_lower, p.u_upper, p.du_max)
    if p.fin_rate > 0.0:
        slow_fins(model, p.u_previous, p.dt * p.fin_rate, p.u_lower, p.u_upper, p.du_max)
    for k in range(6):
        p.tau_d[k] = tau_d[k]
    if settings.allocator == MDCA:
        if settings.easing_made_up == 1:
            missed_wrench(model, p.u_previous, p.effectiveness, w.missed)
            for k in range(6):
                p.tau_d[k] += w.missed[k]
        allocate_mdca(handle, settings, model, p, solution, w)
    elif settings.allocator == WLS:
        allocate_wls(model, p, solution, w)
    else:
        allocate_direct(settings.direct_map, surge, model, p, solution, w)
    if not feasible and solution.status != REFUSED:
        solution.status = INFEASIBLE
    solution.solve_time = monotonic() - started  # pyright: ignore[reportCallIssue]


@jit
def achieve(model, problem, solution, tau_c, w):
    """Fill tau_c (6,), the wrench of the commands by the allocator's model, and w.limited (6,)."""
    p, u = problem, solution.u
    total_wrench(model, u, p.effectiveness, p.nu_flow, tau_c)
    limited_channels(model, u, p.u_lower, p.u_upper, w.jacobian, w.limited)
