"""The sea floor that a mission keeps clear of."""

from typing import Annotated

from bumpless.config.declare import Number, Text, model
from bumpless.contract.names import FILE

_NAME = "|[A-Za-z0-9][A-Za-z0-9._-]{0,63}"  # or none


@model
class SeaFloor:
    """A depth grid, or a flat floor at environment.water_depth_m, and how far to stay above it."""

    clearance_m: Annotated[
        float, Number("Least clearance", "m", 0.0, 1000.0, help="From the hull down to the floor.")
    ]
    grid: Annotated[
        str,
        Text("Depth grid", pattern=_NAME, form=f"must be {FILE.words}",
             help="Name of a chart of the console, or of a file beside the mission; none: a flat floor."),
    ] = ""  # fmt: skip
    water_level_m: Annotated[
        float, Number("Water level above the grid's zero", "m", -20.0, 20.0, help="The tide.")
    ] = 0.0
