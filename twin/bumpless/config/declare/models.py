"""Frozen models whose fields carry notes, and what can be asked of them.

A model is a dataclass (`dataclasses.replace`, `==` and pickle work as ever) that pydantic checks when it is
made: no instance holds a number out of its range.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, TypeGuard, TypeVar, dataclass_transform, get_args, get_origin

from pydantic import ConfigDict
from pydantic.dataclasses import dataclass as checked
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from bumpless.config.declare.notes import Note, without_none
from bumpless.config.plain import is_tuple

MISSING: Any = PydanticUndefined
T = TypeVar("T")
_CONFIG = ConfigDict(extra="forbid", defer_build=True, validate_by_name=True, validate_by_alias=True)


@dataclass_transform(frozen_default=True)
def model(cls: type[T]) -> type[T]:
    """Make a class of annotated fields a frozen, checked dataclass."""
    made: Any = checked(frozen=True, config=_CONFIG)(cls)
    return made


@dataclass(frozen=True)
class Field:
    """One declared field."""

    name: str  # attribute
    key: str  # in files: `lambda`, which is a word of Python
    kind: Any  # type without None
    optional: bool  # may be null
    note: Note
    default: Any  # MISSING when the file must say it


@cache
def fields_of(cls: type) -> dict[str, Field]:
    """The declared fields of a model by the keys of files; those without a note are no part of files."""
    found: dict[str, Field] = {}
    for name, info in _pydantic_fields(cls).items():
        note = next((item for item in info.metadata if isinstance(item, Note)), None)
        if note is None:
            continue
        kind, optional = without_none(info.annotation)
        default = info.get_default(call_default_factory=True)
        key = info.alias or name
        found[key] = Field(name, key, kind, optional, note, default)
    return found


def _pydantic_fields(cls: Any) -> dict[str, FieldInfo]:
    """What pydantic knows of a model's fields, by their attributes."""
    return cls.__pydantic_fields__


def parts_of(kind: Any) -> tuple[type, ...]:
    """The models that a field of this type holds: itself, the options of a union, the entries of a list."""
    if get_origin(kind) is tuple:
        kind = get_args(kind)[0]
    return tuple(item for item in _flat(kind) if _is_model(item))


def _is_model(kind: Any) -> TypeGuard[type]:
    return hasattr(kind, "__pydantic_fields__") and isinstance(kind, type)


def _flat(kind: Any) -> Iterator[Any]:
    """Options of unions and annotations, all the way down."""
    if get_origin(kind) is Literal or get_origin(kind) is tuple or not get_args(kind):
        yield kind
        return
    for inner in get_args(kind):
        yield from _flat(inner)


def tag_of(cls: type) -> str:
    """The word in `kind` that chooses this model among others; "" for one that stands alone."""
    info = _pydantic_fields(cls).get("kind")
    return get_args(info.annotation)[0] if info is not None and get_args(info.annotation) else ""


def as_table(instance: object) -> dict[str, Any]:
    """An instance's fields by the keys of files, rows as lists; parts stay as they are."""
    values = {field.key: getattr(instance, field.name) for field in fields_of(type(instance)).values()}
    return {key: list(value) if is_tuple(value) else value for key, value in values.items()}
