"""The contract's messages by name, what they look like to a stranger, and when one was made."""

from functools import cache
from typing import Any

from google.protobuf import descriptor_pb2, json_format
from google.protobuf.message import DecodeError, Message

from bumpless.contract import bumpless_pb2 as pb

# full message name -> class, for every message of the contract
MESSAGES: dict[str, type[Message]] = {
    kind.full_name: getattr(pb, name) for name, kind in pb.DESCRIPTOR.message_types_by_name.items()
}


def encoded(message: Message) -> bytes:
    """The message's bytes: the same message always gives the same ones."""
    return message.SerializeToString(deterministic=True)


def as_json(message: Message) -> dict[str, Any]:
    """The message as plain data for JSON: the contract's field names, zeros and False included."""
    return json_format.MessageToDict(
        message, preserving_proto_field_name=True, always_print_fields_with_no_presence=True
    )


def decoded(schema: str, payload: bytes) -> Message | None:
    """The message of this full name, or None when name or bytes are not of this contract."""
    kind = MESSAGES.get(schema)
    if kind is None:
        return None
    message = kind()
    try:
        message.ParseFromString(payload)
    except DecodeError:
        return None
    return message


def stamp_of(payload: bytes) -> pb.Stamp | None:
    """The leading Stamp of a telemetry message or event, without decoding the rest.

    Every such message has it as field 1, which serialisers write first: tag 0x0a, a length of one
    byte (a Stamp has at most 31), then the Stamp. None when the payload does not begin so.
    """
    if len(payload) < 2 or payload[0] != 0x0A or payload[1] > 0x7F or len(payload) < 2 + payload[1]:
        return None
    stamp = pb.Stamp()
    try:
        stamp.ParseFromString(payload[2 : 2 + payload[1]])
    except DecodeError:
        return None
    return stamp


@cache
def descriptor_set(kind: type[Message]) -> bytes:
    """FileDescriptorSet of a message's file and all that it imports, dependencies first."""
    files = descriptor_pb2.FileDescriptorSet()
    seen: set[str] = set()

    def add(file: Any) -> None:
        if file.name in seen:
            return
        seen.add(file.name)
        for dependency in file.dependencies:
            add(dependency)
        file.CopyToProto(files.file.add())

    add(kind.DESCRIPTOR.file)
    return encoded(files)
