"""The live-tunable part of the parameters as the contract's message, and back onto a base."""

from dataclasses import replace
from typing import TYPE_CHECKING

from bumpless.config.parameters.model import ModeParameters, Parameters, SupervisorParameters
from bumpless.config.parameters.ranges import MODES

if TYPE_CHECKING:
    from bumpless.contract import bumpless_pb2

MECHANISMS = ("ramp", "integrator_alignment", "warm_start_projection")


def to_message(parameters: Parameters) -> "bumpless_pb2.Parameters":
    """Weights, ramps, thresholds and switching mechanisms as `bumpless.Parameters`."""
    from bumpless.contract import bumpless_pb2

    message = bumpless_pb2.Parameters()
    for name in MODES:
        mode: ModeParameters = getattr(parameters, name)
        target = getattr(message, name)
        target.q_diagonal.extend(mode.q_diagonal)
        target.r_diagonal.extend(mode.r_diagonal)
        setattr(target, "lambda", mode.lambda_)
        target.ramp_cycles = mode.ramp_cycles
    for key in SupervisorParameters.__dataclass_fields__:
        setattr(message.supervisor, key, getattr(parameters.supervisor, key))
    for key in MECHANISMS:
        setattr(message.bumpless, key, getattr(parameters.bumpless, key))
    return message


def from_message(message: "bumpless_pb2.Parameters", base: Parameters) -> Parameters:
    """`base` with every section that the message carries laid over it; `check` comes after."""
    changed = {}
    for name in MODES:
        if message.HasField(name):
            source = getattr(message, name)
            changed[name] = replace(
                getattr(base, name),
                q_diagonal=tuple(source.q_diagonal),
                r_diagonal=tuple(source.r_diagonal),
                lambda_=getattr(source, "lambda"),
                ramp_cycles=source.ramp_cycles,
            )
    if message.HasField("supervisor"):
        keys = SupervisorParameters.__dataclass_fields__
        changed["supervisor"] = SupervisorParameters(**{k: getattr(message.supervisor, k) for k in keys})
    if message.HasField("bumpless"):
        mechanisms = {k: getattr(message.bumpless, k) for k in MECHANISMS}
        changed["bumpless"] = replace(base.bumpless, **mechanisms)
    return replace(base, **changed)
