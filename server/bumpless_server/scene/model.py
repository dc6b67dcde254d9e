"""The vehicle's shape out of its parsed file: what is fixed, what deflects, what turns. Pure geometry."""

from typing import Any

from bumpless_server.scene.actuators import actuator_parts
from bumpless_server.scene.hull import hull_parts
from bumpless_server.scene.part import Part


def parts_of(vehicle: Any, segments: int = 40) -> tuple[Part, ...]:
    """Every part of a vehicle. `segments` around the hull: 40 is round, 20 is light."""
    parts, command = hull_parts(vehicle.hull, segments), 0
    for actuator in vehicle.actuators:
        parts += actuator_parts(actuator, command, vehicle.hull)
        command += len(actuator.commands)
    return tuple(parts)
