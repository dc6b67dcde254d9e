"""What a vehicle does by itself when something fails, as its file says."""

from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, model

Reaction = Literal["hold", "abort"]


@model
class Failsafe:
    """Reactions of the vehicle's node. Without this table, or with 0 s, it flies its mission to the end."""

    heartbeat_lost_s: Annotated[
        float, Number("Silence of the console after which the vehicle acts; 0: never", "s", 0.0, 3600.0)
    ] = 0.0
    heartbeat_lost: Annotated[Reaction, Choice("What it does then: hold station, or stop its actuators")] = (
        "hold"
    )
