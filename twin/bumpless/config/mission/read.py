"""From a node tree to a Mission: types, bounds and names by the dataclasses, then the rules."""

import difflib
import math
import re
from collections.abc import Iterable
from dataclasses import MISSING, fields
from typing import TYPE_CHECKING, Any, get_args

from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from bumpless.config.mission.document import Document, scalar, shown
from bumpless.config.mission.fields import Entries, Number, Part, Row, Text, unit_of
from bumpless.config.mission.model import Mission, MissionError
from bumpless.config.mission.rules import check_rules
from bumpless.config.mission.schema import field_types

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle


MOST_PROBLEMS = 100  # more tell nobody anything


def parse_mission(
    text: str, source: str = "mission.yaml", vehicle: "Vehicle | None" = None, any_vehicle: bool = False
) -> Mission:
    """The mission that `text` holds; `source` is the name its problems carry.

    It is checked against `vehicle`, or when None against the vehicle file of the name it asks for.
    With `any_vehicle` it may ask for another than `vehicle`, and is still checked against that one.
    Raises MissionError with every problem, in the order of the file.
    """
    document = Document(text, source)
    mission = None
    if document.root is not None:
        mission = _read_fields(document, document.root, Mission, "", source=source, text=text)
    if mission is not None:
        check_rules(document, mission, vehicle, any_vehicle)
    if document.problems or mission is None:
        ordered = sorted(document.problems, key=lambda p: (p.line or 0, p.column or 0))
        raise MissionError(ordered[:MOST_PROBLEMS])
    return mission


def _read_fields(document: Document, node: Node, cls: Any, path: str, **extra: str) -> Any:
    """An instance of `cls`, or None when anything inside is wrong."""
    before = len(document.problems)
    known = field_types(cls)
    values: dict[str, Any] = dict(extra)
    items = document.items(node, path)
    prefix = f"{path}." if path else ""
    for key, item in items.items():
        if key in known:
            kind, note, optional = known[key]
            absent = optional and isinstance(item, ScalarNode) and scalar(item) is None
            values[key] = None if absent else _read(document, item, kind, note, prefix + key)
        else:
            document.refuse(prefix + key, shown(item), _unknown(key, known))
    if isinstance(node, MappingNode):
        for f in fields(cls):
            needed = f.name in known and f.default is MISSING and f.default_factory is MISSING
            if needed and f.name not in items:
                note = known[f.name][1]
                unit = f" in {unit_of(note)}" if unit_of(note) else ""
                document.refuse(prefix + f.name, None, f"is missing: {note.about}{unit}")
    return cls(**values) if len(document.problems) == before else None


def _unknown(key: str, known: Iterable[str]) -> str:
    near = difflib.get_close_matches(key, known, n=1, cutoff=0.5)
    return f"unknown field; did you mean {near[0]}?" if near else f"unknown field; one of {', '.join(known)}"


def _read(document: Document, node: Node, kind: Any, note: Any, path: str) -> Any:
    match note:
        case Number():
            return _read_number(document, node, kind, path, note.min, note.max, note.unit)
        case Text():
            return _read_text(document, node, note, path)
        case Row():
            return _read_row(document, node, note, path)
        case Entries():
            return _read_entries(document, node, get_args(kind)[0], note, path)
        case Part() if kind is dict:
            return document.plain(node, path) if document.items(node, path) else {}
    return _read_fields(document, node, kind, path)


def _read_number(
    document: Document, node: Node, kind: Any, path: str, low: float, high: float, unit: str
) -> float | int | None:
    value = scalar(node) if isinstance(node, ScalarNode) else None
    in_unit = f" in {unit}" if unit else ""
    if isinstance(value, bool) or not isinstance(value, int | float):
        plain = ", without its unit" if re.match(r"\s*[-+.\d]+\s*[A-Za-z°/]+", str(value)) else ""
        document.refuse(path, shown(node), f"must be a number{in_unit}{plain}")
    elif not math.isfinite(value):
        document.refuse(path, value, f"must be a finite number{in_unit}")
    elif kind is int and not float(value).is_integer():
        document.refuse(path, value, "must be a whole number")
    elif not low <= value <= high:
        document.refuse(path, value, _bounds_rule(path, low, high, in_unit))
    else:
        return kind(value)
    return None


def _bounds_rule(path: str, low: float, high: float, in_unit: str) -> str:
    if low == high:
        return f"must be {low:g}"
    above = ": depth is positive down" if path.endswith("_ned_m[2]") else ""
    return f"must be between {low:.10g} and {high:.10g}{in_unit}{above}"


def _read_text(document: Document, node: Node, note: Text, path: str) -> str | None:
    if not isinstance(node, ScalarNode) or scalar(node) is None:
        document.refuse(path, shown(node), "must be a text")
        return None
    if note.pattern and not re.fullmatch(note.pattern, node.value):
        document.refuse(path, node.value, note.rule)
    return node.value


def _read_row(document: Document, node: Node, note: Row, path: str) -> tuple[Any, ...] | None:
    if not isinstance(node, SequenceNode) or len(node.value) != len(note.names):
        rule = f"must be a list of {len(note.names)} numbers in {note.unit}: [{', '.join(note.names)}]"
        document.refuse(path, shown(node), rule)
        return None
    numbers = []
    for i, (item, low, high) in enumerate(zip(node.value, note.min, note.max, strict=True)):
        document.note(f"{path}[{i}]", item)
        numbers.append(_read_number(document, item, float, f"{path}[{i}]", low, high, note.unit))
    return tuple(numbers)


def _read_entries(document: Document, node: Node, cls: Any, note: Entries, path: str) -> Any:
    if not isinstance(node, SequenceNode):
        document.refuse(path, shown(node), "must be a list")
        return None
    if not note.min <= len(node.value) <= note.max:
        rule = f"must have between {note.min} and {note.max} entries"
        document.refuse(path, f"{len(node.value)} entries", rule)
        return None
    for i, item in enumerate(node.value):
        document.note(f"{path}[{i}]", item)
    return tuple(_read_fields(document, item, cls, f"{path}[{i}]") for i, item in enumerate(node.value))
