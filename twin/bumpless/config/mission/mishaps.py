"""What happens to a simulated vehicle's body in a mission: to try its failsafes on."""

from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, model

MOST_MISHAPS = 8


@model
class Mishap:
    """From a moment on the simulated vehicle reports water inside, or what is left in its battery."""

    at_s: Annotated[float, Number("When it comes", "s", 0.0, 1e5)]
    what: Annotated[Literal["leak", "battery"], Choice("What it reports from then on")]
    battery: Annotated[float, Number("Share of the charge that is left", "", 0.0, 1.0)] = 0.0
