"""All fields of a model as plain data, for forms: what a field is called, means, holds and may be."""

from typing import Any, get_args

from bumpless.config.declare.models import MISSING, Field, fields_of, parts_of, tag_of
from bumpless.config.declare.notes import Choice, Entries, Number, Part, Row, Switch, Text, Words
from bumpless.config.declare.overrides import Overrides
from bumpless.config.plain import is_tuple


def catalogue(cls: type) -> list[dict[str, Any]]:
    """One entry for each field of the model and its parts, in the order of the declaration.

    `path` says where it is (`legs[].speed_mps`), `kind` for which of several models it holds ("" for all).
    """
    return [entry for field in fields_of(cls).values() for entry in _entries(field, "", "")]


def _entries(field: Field, prefix: str, kind: str) -> list[dict[str, Any]]:
    path = prefix + field.key
    found = [_entry(field, path, kind)]
    if isinstance(field.note, Overrides):
        parts, inner = [field.note.of], f"{path}."
    else:
        parts = list(parts_of(field.kind))
        inner = f"{path}[]." if isinstance(field.note, Entries) else f"{path}."
    for part in parts:
        tag = tag_of(part) if len(parts) > 1 else kind
        for own in fields_of(part).values():
            found += _entries(own, inner, tag)
    return found


def _entry(field: Field, path: str, kind: str) -> dict[str, Any]:
    note = field.note
    entry: dict[str, Any] = {
        "path": path,
        "kind": kind,
        "type": _type(field),
        "label": note.label,
        "help": note.help,
        "unit": note.unit,
        "required": field.default is MISSING,
        "nullable": field.optional,
        "live": note.live,
    }
    if isinstance(note, Number | Row):
        entry |= {"min": note.min, "max": note.max}
    if isinstance(note, Number):
        entry |= {"above": note.above}
    if isinstance(note, Row):
        entry |= {"names": list(note.names), "count": len(note.names), "per_actuator": not note.names}
    if isinstance(note, Choice | Words):
        entry |= {"choices": list(get_args(field.kind) if isinstance(note, Choice) else note.options)}
    if isinstance(note, Text):
        entry |= {"pattern": note.pattern, "form": note.form}
    if isinstance(note, Entries):
        entry |= {"fewest": note.fewest, "most": note.most}
    if field.default is not MISSING and not isinstance(note, Part | Entries | Overrides):
        entry |= {"default": list(field.default) if is_tuple(field.default) else field.default}
    return entry


def _type(field: Field) -> str:
    match field.note:
        case Number():
            return "integer" if field.kind is int else "number"
        case Row():
            return "row"
        case Choice():
            return "choice"
        case Switch():
            return "switch"
        case Words():
            return "words"
        case Entries():
            return "list"
        case Part() | Overrides():
            return "part"
        case _:
            return "text"
