"""Models of the contract's messages as JSON, made from their descriptors: a message is declared once."""

import math
from functools import cache
from typing import Annotated, Any, Literal, TypeVar

from google.protobuf.descriptor import Descriptor, FieldDescriptor
from google.protobuf.message import Message
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, create_model

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import as_json


def _finite(value: Any) -> Any:
    """JSON has no NaN: what is no number is null."""
    if value in ("NaN", "Infinity", "-Infinity"):
        return None
    return None if isinstance(value, float) and not math.isfinite(value) else value


Number = Annotated[float | None, BeforeValidator(_finite)]
Told = TypeVar("Told", bound=BaseModel)
_KINDS: dict[int, tuple[Any, Any]] = {  # Python type and value when absent, by protobuf's kind of value
    FieldDescriptor.CPPTYPE_DOUBLE: (Number, 0.0),
    FieldDescriptor.CPPTYPE_FLOAT: (Number, 0.0),
    FieldDescriptor.CPPTYPE_INT32: (int, 0),
    FieldDescriptor.CPPTYPE_UINT32: (int, 0),
    FieldDescriptor.CPPTYPE_INT64: (str, "0"),  # more digits than JavaScript's numbers keep
    FieldDescriptor.CPPTYPE_UINT64: (str, "0"),
    FieldDescriptor.CPPTYPE_BOOL: (bool, False),
    FieldDescriptor.CPPTYPE_STRING: (str, ""),
}


class Answer(BaseModel):
    """What every answer is: all its fields are there, also those with a value for absence."""

    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


def model_of(message: type[Message]) -> type[BaseModel]:
    """The model of a message's JSON with its own field names, as json_format writes it."""
    return _model(message.DESCRIPTOR)


@cache
def _model(kind: Descriptor) -> type[BaseModel]:
    fields: dict[str, Any] = {field.name: _field(field) for field in kind.fields}
    return create_model(kind.name, __base__=Answer, __doc__=f"{kind.full_name} as JSON.", **fields)


def _field(field: FieldDescriptor) -> tuple[Any, Any]:
    entry = field.message_type
    if entry is not None and entry.GetOptions().map_entry:
        key, value = (_single(entry.fields_by_name[name])[0] for name in ("key", "value"))
        return dict[key, value], Field(default_factory=dict)
    kind, absent = _single(field)
    if field.is_repeated:
        return list[kind], Field(default_factory=list)
    return (kind | None, None) if field.has_presence else (kind, absent)


def _single(field: FieldDescriptor) -> tuple[Any, Any]:
    if field.message_type is not None:
        return _model(field.message_type), None
    if field.enum_type is not None:
        names = tuple(value.name for value in field.enum_type.values)
        return Literal[names], names[0]
    return _KINDS[field.cpp_type]


class Problem(model_of(pb.Problem)):
    """One broken rule: where, what was found there, and the rule."""


class Metrics(model_of(pb.Metrics)):
    """A run's figures of merit."""


class MissionStatus(model_of(pb.MissionStatus)):
    """The mission being flown."""


class Parameters(model_of(pb.Parameters)):
    """A whole set of tunable parameters."""


class CommandReply(model_of(pb.CommandReply)):
    """The vehicle's own answer."""

    accepted: bool
    reason: str
    problems: list[Problem]
    revision: int  # of the parameters; small enough for a number
    id: str  # of the request


def told(message: Message, model: type[Told]) -> Told:
    """A contract message as an answer."""
    return model.model_validate(as_json(message))
