"""A drawn vehicle that was flown before: its file says what identification made of the log of that flight.

The plant stays as drawn. Only what is on board differs: model, allocator's map and all that use them.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from bumpless.config.vehicle import Vehicle
from bumpless.identify import Flight, identify, learned
from bumpless.identify.scales import MODEL_FIELDS
from bumpless.physics.model import build_model
from bumpless.sim.twin import Result

EARLIER = 1000  # added to the seed of the flight before, so that no noise is seen twice


@dataclass(frozen=True)
class Unlearned:
    """Callable as `alter` of `simulate`: the true vehicle is `file`'s, altered, whatever was learned."""

    file: Vehicle
    alter: Callable[[Any, Any], None]

    def __call__(self, model: Any, truth: Any) -> None:
        """Change the records in place."""
        true = build_model(self.file)
        for names in MODEL_FIELDS.values():
            for name in names:
                model[name] = true[name]
        self.alter(model, truth)


def learned_from(flown: Result) -> Vehicle:
    """The vehicle of a flight with what its log tells."""
    vehicle = flown.vehicle
    flight = Flight.from_log(flown.log, len(vehicle.commands))
    return learned(vehicle, identify([flight], vehicle).factors)
