"""The records of the compiled world, made from the declarations: SI and radians, words as numbers.

A field `pitch_max_deg` declared with `record="pitch_max"` becomes the record's `pitch_max` in radians. Rows
become rows, `record="fault_gains[1]"` the second row of a table, switches 0 or 1, and a chosen word its place
among the words.
"""

import re
from functools import cache
from math import radians
from typing import Any, get_args

import numpy as np

from bumpless.config.declare.models import Field, fields_of
from bumpless.config.declare.notes import Choice, Number, Row
from bumpless.config.plain import is_tuple

TO_SI = {"deg": radians, "deg/s": radians}  # what files say in other units


def record_dtype(cls: type) -> np.dtype:
    """The record of a model: each field that names one, in the order of the declaration."""
    shapes: dict[str, tuple[Any, tuple[int, ...]]] = {}
    for field in fields_of(cls).values():
        if not field.note.record:
            continue
        name, row = _target(field)
        shape = (len(field.note.names) or field.note.most,) if isinstance(field.note, Row) else ()
        shapes[name] = (_stored(field), shape if row is None else (row + 1, *shape))
    return np.dtype([(name, kind, shape) for name, (kind, shape) in shapes.items()], align=True)


def fill_record(instance: object, out: Any) -> None:
    """Write an instance of a model into a record (`array[i]`) that has its fields, and maybe more."""
    for name, row, field in _targets(type(instance)):
        value = _converted(field, getattr(instance, field.name))
        if row is not None:
            out[name][row] = value
        elif is_tuple(value):
            out[name][: len(value)] = value
            out[name][len(value) :] = 0.0
        else:
            out[name] = value


def codes(cls: type, key: str) -> tuple[int, ...]:
    """The numbers that stand for the words of a chosen field, in the order of its words: 0, 1, ..."""
    return tuple(range(len(get_args(fields_of(cls)[key].kind))))


@cache
def _targets(cls: type) -> list[tuple[str, int | None, Field]]:
    return [(*_target(field), field) for field in fields_of(cls).values() if field.note.record]


def _target(field: Field) -> tuple[str, int | None]:
    match = re.fullmatch(r"(\w+)(?:\[(\d+)\])?", field.note.record)
    assert match is not None, f"{field.key}: {field.note.record} names no field of a record"
    return match[1], int(match[2]) if match[2] else None


def _stored(field: Field) -> type:
    if isinstance(field.note, Number) and field.note.stored is not None:
        return field.note.stored
    return np.float64 if field.kind is float or isinstance(field.note, Row) else np.int64


def _converted(field: Field, value: Any) -> Any:
    if isinstance(field.note, Choice):
        return get_args(field.kind).index(value)
    convert = TO_SI.get(field.note.unit)
    if convert is None:
        return value
    return tuple(map(convert, value)) if is_tuple(value) else convert(value)
