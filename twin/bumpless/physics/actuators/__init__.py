"""What actuators do: one module for each kind, and `dispatch` to choose among them.

How to add one: docs/add_actuator_kind.md.

Source: Gao et al. 2026, eq. (8)-(20), (23)-(34).
"""

from bumpless.physics.actuators.dispatch import (
    FIN,
    KINDS,
    THRUSTER,
    add_map,
    add_missed,
    command_slope,
    curve,
    fill_actuator,
    to_command,
    to_x,
)
from bumpless.physics.actuators.total import actuator_wrench, lag_rate, total_wrench

__all__ = [
    "FIN",
    "KINDS",
    "THRUSTER",
    "actuator_wrench",
    "add_map",
    "add_missed",
    "command_slope",
    "curve",
    "fill_actuator",
    "lag_rate",
    "to_command",
    "to_x",
    "total_wrench",
]
