"""Where a mission must not lead, and what it must not leave; the autopilot knows nothing of either."""

from typing import Annotated

from bumpless.config.declare import Entries, Number, Text, model

MOST_CORNERS, MOST_ZONES = 64, 16


@model
class Corner:
    """A corner of an outline."""

    north_m: Annotated[float, Number("North", "m", -1e5, 1e5)]
    east_m: Annotated[float, Number("East", "m", -1e5, 1e5)]


def outline() -> Entries:
    """Corners in order; the last is joined to the first."""
    return Entries("Corners in order", fewest=3, most=MOST_CORNERS, help="The last is joined to the first.")


@model
class KeepOut:
    """A place that no leg may lead through, between two depths."""

    corners: Annotated[tuple[Corner, ...], outline()]
    name: Annotated[str, Text("Name")] = ""
    from_depth_m: Annotated[float, Number("Upper end", "m", 0.0, 11000.0)] = 0.0
    to_depth_m: Annotated[float, Number("Lower end", "m", 0.0, 11000.0)] = 11000.0


@model
class KeepIn:
    """The boundary that no leg may leave."""

    corners: Annotated[tuple[Corner, ...], outline()]
