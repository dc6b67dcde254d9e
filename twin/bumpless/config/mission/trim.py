"""How a vehicle truly floats: what its file and its autopilot don't know of mass and buoyancy."""

from typing import Annotated

from bumpless.config.capacity import MAX_WEIGHTS
from bumpless.config.declare import Entries, Number, Row, model
from bumpless.config.mission.notes import Vector3
from bumpless.config.names import BODY


def spot(label: str) -> Row:
    """A place on the vehicle."""
    return Row(label, "m", -20.0, 20.0, names=BODY)


@model
class Weight:
    """A weight that was moved; put on, when it has no place it came from; taken off, when none it went to."""

    mass_kg: Annotated[float, Number("Mass", "kg", 0.001, 1000.0)]
    from_m: Annotated[Vector3 | None, spot("Where it was, body axes")] = None
    to_m: Annotated[Vector3 | None, spot("Where it is, body axes")] = None


@model
class Trim:
    """Errors of ballast and buoyancy, of the simulated vehicle only."""

    buoyancy_n: Annotated[
        float, Number("Lift beyond the vehicle file's, at the centre of buoyancy", "N", -1000.0, 1000.0)
    ] = 0.0
    weights: Annotated[tuple[Weight, ...], Entries("Weights", most=MAX_WEIGHTS)] = ()
