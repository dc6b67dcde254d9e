"""The admissible commands of one cycle: amplitude and increment bounds."""

from bumpless.jit import jit
from bumpless.physics.actuators import FIN

_AUTHORITY = 0.1  # less than this share of the strongest is a side effect, not a means


@jit
def command_bounds(model, u_previous, dt, lower, upper, du_max):
    """Fill lower, upper, du_max (8,): u_min <= u <= u_max and |u - u_prev| <= rate dt. False if empty.

    Source: Gao et al. 2026, eq. (35)-(36), (48).

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
def slow_fins(model, u_previous, step, lower, upper, du_max):
    """Narrow the increment bounds of the fins to `step`, rad; a fin outside of its amplitude comes back."""
    for i in range(model.n_u):
        if model.kind[i] == FIN and du_max[i] > step:
            du_max[i] = step
            lower[i] = min(max(lower[i], u_previous[i] - step), u_previous[i] + step)
            upper[i] = max(min(upper[i], u_previous[i] + step), u_previous[i] - step)


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
def limited_channels(model, u, lower, upper, jacobian, limited):
    """Fill limited (6,): 1 for each wrench component on which a command at a bound, amplitude or
    increment, has authority: at least `_AUTHORITY` of what the strongest actuator has on it.

    jacobian (6, 8): dG/dx in bound-normalised commands, N and N m, at or near u.
    """
    for k in range(6):
        limited[k] = 0
        strongest = 0.0
        for i in range(model.n_u):
            strongest = max(strongest, abs(jacobian[k, i]))
        for i in range(model.n_u):
            slack = 1e-9 * (model.command_max[i] - model.command_min[i])
            held = u[i] >= upper[i] - slack or u[i] <= lower[i] + slack
            if held and strongest > 0.0 and abs(jacobian[k, i]) >= _AUTHORITY * strongest:
                limited[k] = 1
