"""From plain data to a model, or every broken rule with its path and value."""

import difflib
from collections.abc import Iterable
from functools import cache
from typing import Any, NamedTuple, TypeVar

from pydantic import TypeAdapter, ValidationError

from bumpless.config.declare.models import fields_of, parts_of, tag_of

T = TypeVar("T")


class Broken(NamedTuple):
    """One broken rule at a path such as `legs[0].speed_mps`."""

    path: str
    value: Any  # None when it is missing
    rule: str


class Unread(ValueError):
    """Data that is no instance of the model; `broken` says why."""

    def __init__(self, broken: Iterable[Broken]) -> None:
        self.broken = tuple(broken)
        super().__init__("\n".join(f"{one.path}: {one.rule}" for one in self.broken))


@cache
def _adapter(cls: type) -> TypeAdapter[Any]:
    return TypeAdapter(cls)


def read(cls: type[T], data: Any) -> T:
    """An instance of the model from plain tables and values. Raises Unread with every broken rule."""
    try:
        return _adapter(cls).validate_python(data, by_alias=True, by_name=False)
    except ValidationError as error:
        found = error.errors(include_url=False)
    raise Unread(_in_words(cls, one) for one in found)


def _in_words(cls: type, error: Any) -> Broken:
    path, holder, options = _walk(cls, error["loc"])
    key = error["loc"][-1] if error["loc"] else ""
    match error["type"]:
        case "rule":
            return Broken(path, error["input"], error["msg"])
        case "missing":
            note = fields_of(holder)[key].note
            return Broken(path, None, f"is missing: {note.label}{note.in_unit}")
        case "unexpected_keyword_argument":
            return Broken(path, error["input"], unknown(key, fields_of(holder)))
        case "union_tag_not_found" | "union_tag_invalid":
            kind = error["input"].get("kind")
            tags = ", ".join(tag_of(option) for option in options)
            return Broken(
                f"{path}.kind", kind, f"{'is missing:' if kind is None else 'must be'} one of {tags}"
            )
        case "dataclass_type" | "dict_type" | "model_attributes_type" | "dataclass_exact_type":
            return Broken(path, error["input"], "must hold named fields")
        case _:
            return Broken(path, error["input"], error["msg"])


def unknown(key: Any, known: Iterable[str]) -> str:
    """What is said of a field that does not exist."""
    near = difflib.get_close_matches(str(key), known, n=1, cutoff=0.5)
    return f"unknown field; did you mean {near[0]}?" if near else f"unknown field; one of {', '.join(known)}"


def _walk(cls: type, place: tuple[str | int, ...]) -> tuple[str, type, tuple[type, ...]]:
    """Of a place of pydantic's: its path without the tags of unions, the model that holds the field it ends
    with, and the models that field may hold."""
    path, holder = "", cls
    options: tuple[type, ...] = (cls,)
    for step in place:
        if isinstance(step, int):
            path += f"[{step}]"
        elif len(options) > 1:
            options = tuple(one for one in options if tag_of(one) == step)
        else:
            path += f".{step}" if path else step
            holder = options[0] if options else holder
            field = fields_of(holder).get(step)
            options = parts_of(field.kind) if field else ()
    return path, holder, options
