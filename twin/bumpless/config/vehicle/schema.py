"""JSON Schema of vehicle files, made from the declarations that read them."""

from typing import Any

from bumpless.config.declare import parts_of
from bumpless.config.declare.schema import optional_fields, schema_of
from bumpless.config.vehicle.model import Document
from bumpless.config.vehicle.parts import Actuator
from bumpless.config.vehicle.shared import TYPES


def vehicle_json_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of vehicle files.

    An actuator stands there whole, or names a type, whose table may hold any of its fields.
    """
    about = "Body axes: x forward, y starboard, z down. Every field carries its unit in its name."
    schema = schema_of(Document, "Bumpless vehicle", about)
    shared = [optional_fields(kind) for kind in parts_of(Actuator)]
    for part in shared:
        part["properties"]["kind"] = {"const": part["properties"]["kind"]["const"]}
    typed = [
        part | {"properties": {"type": {"type": "string"}} | part["properties"], "required": ["type"]}
        for part in shared
    ]
    whole = schema["properties"]["actuators"]["items"]
    schema["properties"]["actuators"]["items"] = {"anyOf": [whole, *typed]}
    schema["properties"][TYPES] = {
        "title": "Fields that several actuators share, by type",
        "type": "object",
        "additionalProperties": {"anyOf": shared},
    }
    return schema
