"""All that the autopilot is tuned with, in sections named after the tables of the vehicle file.

Wrench order is [X Y Z K M N], error order [u v z phi theta psi], actuators in the vehicle file's
order. A new number is one annotated line in its section's file (`supervisor.py`, `guidance.py`, ...); one
that may change in flight (`live=True`) needs its field in bumpless.proto as well.
"""

from typing import Annotated

from bumpless.config.declare import Part, model
from bumpless.config.parameters.allocation import AllocationParameters
from bumpless.config.parameters.guidance import GuidanceParameters
from bumpless.config.parameters.modes import ModeParameters
from bumpless.config.parameters.navigation import NavigationParameters
from bumpless.config.parameters.supervisor import SupervisorParameters
from bumpless.config.parameters.switching import BumplessParameters


@model
class Parameters:
    """Everything the autopilot is tuned with."""

    forward: Annotated[ModeParameters, Part("Weights and gains in forward")]
    reverse: Annotated[ModeParameters, Part("Weights and gains in reverse")]
    hover: Annotated[ModeParameters, Part("Weights and gains in hover")]
    supervisor: Annotated[SupervisorParameters, Part("When modes change")]
    bumpless: Annotated[BumplessParameters, Part("What makes switches bumpless")]
    allocation: Annotated[AllocationParameters, Part("Allocation of the demand to the actuators")]
    guidance: Annotated[GuidanceParameters, Part("References, and how gains follow speed")]
    navigation: Annotated[NavigationParameters, Part("What the sensors are believed")]

    @property
    def modes(self) -> tuple[ModeParameters, ModeParameters, ModeParameters]:
        """In the order of `names.MODES`."""
        return self.forward, self.reverse, self.hover
