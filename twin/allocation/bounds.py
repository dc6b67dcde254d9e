"""The admissible commands of one cycle: amplitude and increment bounds. Source: Gao et al. 2026, eq. (48)."""

from twin.compiled import jit


@jit
def command_bounds(model, u_previous, dt, lower, upper, du_max):
    """Fill lower, upper, du_max (8,): u_min <= u <= u_max and |u - u_prev| <= rate dt. False if empty.

    Where the two contradict each other (the last command lies outside its amplitude), the increment
    bound wins: the command moves towards the amplitude as fast as it may.
    """
    feasible = True
    for i in range(model.n_u):
        step = model.command_rate[i] * dt
        du_max[i] = step
        lower[i] = max(model.command_min[i], u_previous[i] - step)
        upper[i] = min(model.command_max[i], u_previous[i] + step)
        if lower[i] > upper[i]:
            feasible = False
            nearest = u_previous[i] - step if u_previous[i] > model.command_max[i] else u_previous[i] + step
            lower[i] = upper[i] = nearest
    return feasible


@jit
def count_saturated(model, u):
    """How many commands are at an amplitude bound."""
    count = 0
    for i in range(model.n_u):
        slack = 1e-6 * (model.command_max[i] - model.command_min[i])
        if u[i] >= model.command_max[i] - slack or u[i] <= model.command_min[i] + slack:
            count += 1
    return count


@jit
def any_active(model, u, lower, upper):
    """1 if any command is at a bound of this cycle, amplitude or increment."""
    for i in range(model.n_u):
        slack = 1e-9 * (model.command_max[i] - model.command_min[i])
        if u[i] >= upper[i] - slack or u[i] <= lower[i] + slack:
            return 1
    return 0
