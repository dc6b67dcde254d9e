"""How much of what the sensors say is believed."""

from typing import Annotated

from bumpless.config.declare import Number, model


@model
class NavigationParameters:
    """How much of what the sensors say is believed."""

    fix_gate_m: Annotated[
        float,
        Number("Farthest a fix of the target may be from where it is believed", "m", 0.0, 100.0,
               record="fix_gate",
               help="Beyond three deviations of the sensor; three that agree are believed all the same."
                    " 0: every fix is."),
    ] = 0.0  # fmt: skip
