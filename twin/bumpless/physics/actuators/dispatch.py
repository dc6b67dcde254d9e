"""The kinds of actuators there are. Only this file asks which kind a slot of the commands has.

A slot is one command, one entry of u. An actuator owns one slot or several in a row; its wrench,
effectiveness and every number but for its commands' stand at the first. A kind is a module with
  KIND          its number in a MODEL record, any but 0, which no kind has
  GROUP, GRID   its row among the sampled sets of the envelope, and the levels of a command there
  fill          the vehicle file's entry -> the MODEL record's slots
  wrench        what it does at the commands u, with the flow nu_r
  to_x, to_command   one command <-> its decision variable, monotone, so that bounds map exactly
  add_map       its wrench in the decision variables and the derivative, one column for each command
  curve         the second-order term: `out` on the diagonal, `coupling` between a slot and the next
  command_slope d(command over its largest)/dx, which prices increments
  add_missed    what easing misses
Functions below are compiled, and take the record, the slot i and the kind's own arguments. A kind that is
not known raises ValueError, in compiled code as in Python.
"""

from types import ModuleType
from typing import TYPE_CHECKING, Any

from bumpless.jit import inline
from bumpless.physics.actuators import azimuth, fin, thruster

if TYPE_CHECKING:
    import numpy as np

THRUSTER, FIN, AZIMUTH = thruster.KIND, fin.KIND, azimuth.KIND
KINDS: dict[str, ModuleType] = {  # by their name in a vehicle file
    "fin": fin,
    "thruster": thruster,
    "azimuth": azimuth,
}
assert len({kind.KIND for kind in KINDS.values()} - {0}) == len(KINDS)  # each number names one kind


def fill_actuator(model: "np.record", i: int, actuator: Any, rho: float) -> int:
    """Fill the record's slots of one actuator from i on; returns the first slot after them.

    Raises: ValueError when the actuator's kind is not known.
    """
    if actuator.kind not in KINDS:
        raise ValueError(f"{actuator.name}: unknown kind of actuator {actuator.kind!r}; {', '.join(KINDS)}")
    end = i + len(actuator.commands)
    model["kind"][i:end] = KINDS[actuator.kind].KIND
    model["part"][i:end] = range(end - i)
    KINDS[actuator.kind].fill(model, i, actuator, rho)
    return end


@inline
def wrench(model, i, u, nu_r):
    """(X, Y, Z, K, M, N) of the actuator whose first slot is i, N and N m about O_b; zero at its others.

    u (8,): deflections (rad) and shaft speeds (rev/s) as they are now; nu_r (6,): velocity through water.
    """
    if model.part[i] > 0:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    if model.kind[i] == FIN:
        return fin.wrench(model, i, u, nu_r)
    if model.kind[i] == THRUSTER:
        return thruster.wrench(model, i, u, nu_r)
    if model.kind[i] == AZIMUTH:
        return azimuth.wrench(model, i, u, nu_r)
    raise ValueError("unknown kind of actuator")


@inline
def to_x(model, i, command):
    """Normalised decision variable of the command (rad or rev/s) in slot i."""
    if model.kind[i] == FIN:
        return fin.to_x(model, i, command)
    if model.kind[i] == THRUSTER:
        return thruster.to_x(model, i, command)
    if model.kind[i] == AZIMUTH:
        return azimuth.to_x(model, i, command)
    raise ValueError("unknown kind of actuator")


@inline
def to_command(model, i, x):
    """Command (rad or rev/s) of slot i for a normalised decision variable."""
    if model.kind[i] == FIN:
        return fin.to_command(model, i, x)
    if model.kind[i] == THRUSTER:
        return thruster.to_command(model, i, x)
    if model.kind[i] == AZIMUTH:
        return azimuth.to_command(model, i, x)
    raise ValueError("unknown kind of actuator")


@inline
def add_map(model, i, x, u_previous, alpha, nu_r, tau, column):
    """Add alpha times the wrench at the decision variables x (8,) to tau (6,), and dG/dx to column (8, 6).

    u_previous (8,): last commands, for the inflow term; nu_r (6,): estimated velocity through water.
    """
    if model.part[i] > 0:
        return
    if model.kind[i] == FIN:
        fin.add_map(model, i, x, u_previous, alpha, nu_r, tau, column)
    elif model.kind[i] == THRUSTER:
        thruster.add_map(model, i, x, u_previous, alpha, nu_r, tau, column)
    elif model.kind[i] == AZIMUTH:
        azimuth.add_map(model, i, x, u_previous, alpha, nu_r, tau, column)
    else:
        raise ValueError("unknown kind of actuator")


@inline
def curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling):
    """Second-order term -sum_k weight_k alpha d2G_k/dx_a dx_b of the actuator whose first slot is i:
    out[a] for a = b, coupling[a] for b = a + 1. Both are zero on entry."""
    if model.part[i] > 0:
        return
    if model.kind[i] == FIN:
        fin.curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling)
    elif model.kind[i] == THRUSTER:
        thruster.curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling)
    elif model.kind[i] == AZIMUTH:
        azimuth.curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling)
    else:
        raise ValueError("unknown kind of actuator")


@inline
def command_slope(model, i, x):
    """d(command over its largest)/dx of slot i at the decision variable x."""
    if model.kind[i] == FIN:
        return fin.command_slope(model, i, x)
    if model.kind[i] == THRUSTER:
        return thruster.command_slope(model, i, x)
    if model.kind[i] == AZIMUTH:
        return azimuth.command_slope(model, i, x)
    raise ValueError("unknown kind of actuator")


@inline
def add_missed(model, i, u, alpha, out):
    """Add alpha times what easing misses at the commands u (8,) to out (6,), N and N m."""
    if model.part[i] > 0:
        return
    if model.kind[i] == FIN:
        fin.add_missed(model, i, u, alpha, out)
    elif model.kind[i] == THRUSTER:
        thruster.add_missed(model, i, u, alpha, out)
    elif model.kind[i] == AZIMUTH:
        azimuth.add_missed(model, i, u, alpha, out)
    else:
        raise ValueError("unknown kind of actuator")
