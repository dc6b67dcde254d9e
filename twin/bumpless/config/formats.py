"""The three things that people write, by name: their schemas, and their fields for forms."""

from collections.abc import Callable
from typing import Any

from bumpless.config.declare.catalogue import catalogue
from bumpless.config.declare.schema import DIALECT, partial
from bumpless.config.mission import mission_json_schema
from bumpless.config.mission.model import Document as MissionDocument
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle.model import Document as VehicleDocument
from bumpless.config.vehicle.schema import vehicle_json_schema


def parameters_json_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of the `[control]` tables of a vehicle, or of a mission's overrides."""
    about = "Control parameters; what is left out stays as it is."
    return {"$schema": DIALECT, "title": "Bumpless parameters", "description": about, **partial(Parameters)}


MODELS: dict[str, type] = {
    "mission": MissionDocument,
    "vehicle": VehicleDocument,
    "parameters": Parameters,
}
SCHEMAS: dict[str, Callable[[], dict[str, Any]]] = {
    "mission": mission_json_schema,
    "vehicle": vehicle_json_schema,
    "parameters": parameters_json_schema,
}


def field_catalogue(kind: str) -> list[dict[str, Any]]:
    """Every field of "mission", "vehicle" or "parameters", for forms; see `declare.catalogue`."""
    return catalogue(MODELS[kind])
