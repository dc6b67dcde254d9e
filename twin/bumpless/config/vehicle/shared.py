"""Fields that several actuators share stand once in `[actuator_types.<type>]`; actuators name their type."""

import re
from typing import Any

from bumpless.config.declare import Broken
from bumpless.config.plain import is_list, is_table

TYPES = "actuator_types"


def with_shared_fields(tables: dict[str, Any]) -> tuple[dict[str, Any], list[Broken]]:
    """The tables of a vehicle file with each type laid under its actuators, and what is wrong with types."""
    types, actuators = tables.get(TYPES, {}), tables.get("actuators")
    rest = {name: table for name, table in tables.items() if name != TYPES}
    if not is_table(types) or not all(isinstance(common, dict) for common in types.values()):
        return rest, [Broken(TYPES, types, "must hold tables of fields that actuators share")]
    broken: list[Broken] = []
    if is_list(actuators):
        merged: list[Any] = []
        for i, entry in enumerate(actuators):
            name = entry.get("type") if is_table(entry) else None
            if name is None:
                merged.append(entry)
            elif isinstance(name, str) and name in types:
                merged.append(types[name] | {key: value for key, value in entry.items() if key != "type"})
            else:
                merged.append({key: value for key, value in entry.items() if key != "type"})
                rule = "must name a table of actuator_types" + (f": {', '.join(types)}" if types else "")
                broken.append(Broken(f"actuators[{i}].type", name, rule))
        rest["actuators"] = merged
    return rest, broken


def origin_of(tables: dict[str, Any], path: str) -> str:
    """Where the field of an actuator is written: with its type, unless the actuator says it itself."""
    match = re.fullmatch(r"actuators\[(\d+)\]\.(.+)", path)
    if not match:
        return path
    entry = tables["actuators"][int(match[1])]
    field = re.split(r"[.\[]", match[2])[0]
    shared = isinstance(entry, dict) and "type" in entry and field not in entry
    return f"{TYPES}.{entry['type']}.{match[2]}" if shared else path
