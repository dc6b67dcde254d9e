"""JSON Schema of mission files, made from the dataclasses that read them."""

import types
from dataclasses import MISSING, fields
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from bumpless.config.mission.fields import Entries, Internal, Number, Part, Row, Text, unit_of
from bumpless.config.mission.model import Mission
from bumpless.config.parameters import RANGES, Parameters


def field_types(cls: Any) -> dict[str, tuple[Any, Any, bool]]:
    """Fields of a mission dataclass: plain type, note, and whether it may be null."""
    found: dict[str, tuple[Any, Any, bool]] = {}
    for name, hint in get_type_hints(cls, include_extras=True).items():
        kind, note = get_args(hint)[:2] if get_origin(hint) is Annotated else (hint, None)
        optional = get_origin(kind) in (Union, types.UnionType)
        if optional:
            kind = next(option for option in get_args(kind) if option is not type(None))
        if not isinstance(note, Internal):
            found[name] = (dict if get_origin(kind) is dict else kind, note, optional)
    return found


def mission_json_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of mission files, made from the dataclasses that read them."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Bumpless mission",
        "description": "Positions are NED: north, east, down in metres; depth is positive down.",
        **_object(Mission),
    }


def _object(cls: Any) -> dict[str, Any]:
    known = field_types(cls)
    required = [
        f.name
        for f in fields(cls)
        if f.name in known and f.default is MISSING and f.default_factory is MISSING
    ]
    return {
        "type": "object",
        "additionalProperties": False,
        "required": required,
        "properties": {name: _property(*spec) for name, spec in known.items()},
    }


def _property(kind: Any, note: Any, optional: bool) -> dict[str, Any]:
    match note:
        case Number():
            schema = _number("integer" if kind is int else "number", note.min, note.max)
        case Text():
            schema = {"type": "string"} | ({"pattern": f"^{note.pattern}$"} if note.pattern else {})
        case Row():
            bounds = zip(note.min, note.max, strict=True)
            schema = {
                "type": "array",
                "prefixItems": [_number("number", low, high) for low, high in bounds],
                "minItems": len(note.names),
                "maxItems": len(note.names),
            }
        case Entries():
            inner = _object(get_args(kind)[0])
            schema = {"type": "array", "items": inner, "minItems": note.min, "maxItems": note.max}
        case Part() if kind is dict:
            schema = _parameters()
        case _:
            schema = _object(kind)
    unit = f", {unit_of(note)}" if unit_of(note) else ""
    names = f" [{' '.join(note.names)}]" if isinstance(note, Row) else ""
    described = {"description": f"{note.about}{names}{unit}", **schema}
    return {"anyOf": [described, {"type": "null"}]} if optional else described


def _number(kind: str, low: float, high: float) -> dict[str, Any]:
    return {"type": kind, "minimum": low, "maximum": high}


def _parameters() -> dict[str, Any]:
    """Sections of overrides, none of them required, with the bounds of the one table of ranges."""
    ranges = {r.path: r for r in RANGES}
    sections: dict[str, Any] = {}
    for section in fields(Parameters):
        properties: dict[str, Any] = {}
        for f in fields(section.type):  # type: ignore[arg-type]
            key = f.name.rstrip("_")
            entry = ranges.get(f"{section.name}.{key}")
            if entry is None:
                choices = get_args(f.type) if get_origin(f.type) is Literal else ()
                properties[key] = {"enum": list(choices)} if choices else {"type": "boolean"}
                continue
            schema = _number("integer" if f.type is int else "number", entry.min, entry.max)
            if entry.count > 0:
                schema = {"type": "array", "items": schema, "minItems": entry.count, "maxItems": entry.count}
            elif entry.count < 0:
                schema = {"type": "array", "items": schema, "minItems": 1}
            unit = f", {entry.unit}" if entry.unit != "1" else ""
            properties[key] = {"description": entry.label + unit, **schema}
        sections[section.name] = {"type": "object", "additionalProperties": False, "properties": properties}
    return {"type": "object", "additionalProperties": False, "properties": sections}
