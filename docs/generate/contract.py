"""The vehicle contract: topics, commands and messages, from the table of keys and the .proto's comments."""

import tempfile
from collections.abc import Iterator
from importlib import resources
from pathlib import Path
from typing import Any

from google.protobuf import descriptor_pb2
from google.protobuf.descriptor_pb2 import FieldDescriptorProto as Field

from bumpless.contract import keys
from docs.generate.markdown import NOTE, code, table

HEAD = """# Contract reference

Every topic, command, message and field that a vehicle, real or simulated, speaks. [The vehicle
contract](../vehicle_contract.md) says how to use it; the file itself is
[bumpless.proto](../../twin/bumpless/contract/bumpless.proto). Names carry frame and unit: `_ned_` is
north-east-down from the mission's start, `_body_` forward-starboard-down at O_b.

"""
MESSAGE, ENUM, FIELD, VALUE = 4, 5, 2, 2  # field numbers in descriptor.proto, which name places in the source
SCALARS = {
    number: name.removeprefix("TYPE_").lower()
    for name, number in Field.Type.items()
    if name != "TYPE_MESSAGE"
}


def described() -> descriptor_pb2.FileDescriptorProto:
    """The .proto as protoc understands it, with its comments."""
    from grpc_tools import protoc

    folder = Path(str(resources.files("bumpless.contract")))
    with tempfile.TemporaryDirectory() as work:
        out = Path(work) / "set.pb"
        options = ["-I", str(folder), "--include_source_info", f"--descriptor_set_out={out}"]
        if protoc.main(["protoc", *options, "bumpless.proto"]) != 0:
            raise RuntimeError("protoc could not read bumpless.proto")
        return descriptor_pb2.FileDescriptorSet.FromString(out.read_bytes()).file[0]


class Comments:
    """What the .proto says beside each message, field and value."""

    def __init__(self, file: descriptor_pb2.FileDescriptorProto) -> None:
        self._at = {tuple(place.path): place for place in file.source_code_info.location}

    def of(self, *path: int) -> str:
        """The comment above or behind the thing at `path`."""
        place = self._at.get(path)
        return (
            "" if place is None else " ".join(f"{place.leading_comments} {place.trailing_comments}".split())
        )


def page() -> str:
    """Markdown: topics, commands, then every message and enum."""
    file = described()
    comments = Comments(file)
    return (
        NOTE
        + HEAD
        + _topics()
        + _commands()
        + "".join(_messages(file, comments))
        + "".join(_enums(file, comments))
    )


def _link(name: str) -> str:
    return f"[{name}](#{name.lower()})"


def _topics() -> str:
    rows = []
    for topic in keys.TOPICS.values():
        rate = "each control cycle" if topic.rate_hz is None else f"{topic.rate_hz:g} Hz"
        rate += " and at each change" if topic.on_change else ""
        rows.append(
            (
                code(topic.name),
                code(keys.telemetry("<vehicle>", topic.name)),
                _link(topic.message.__name__),
                rate,
            )
        )
    rows.append(("event", code(keys.event("<vehicle>")), _link("Event"), "when it happens"))
    rows.append(
        (
            "truth",
            code(keys.truth("<vehicle>")),
            _link("TruthState"),
            "each control cycle; simulated vehicles only",
        )
    )
    return "## Topics\n\n" + table(("topic", "key", "message", "said"), rows) + "\n"


def _commands() -> str:
    rows = [
        (code(verb), code(keys.command("<vehicle>", verb)), _link(request.__name__), _link("CommandReply"))
        for verb, request in keys.COMMANDS.items()
    ]
    return "## Commands\n\n" + table(("verb", "key", "request", "answer"), rows) + "\n"


def _messages(file: descriptor_pb2.FileDescriptorProto, comments: Comments) -> Iterator[str]:
    for m, message in enumerate(file.message_type):
        rows = [
            (field.number, code(field.name), _type(message, field), comments.of(MESSAGE, m, FIELD, f))
            for f, field in enumerate(message.field)
        ]
        text = f"## {message.name}\n\n{comments.of(MESSAGE, m)}\n\n"
        yield text + (table(("no.", "field", "type", "meaning"), rows) + "\n" if rows else "")


def _type(message: Any, field: Any) -> str:
    nested = {one.name: one for one in message.nested_type}
    name = field.type_name.rsplit(".", 1)[-1]
    if name in nested and nested[name].options.map_entry:
        return "map of text to text"
    plain = _link(name) if name else SCALARS[field.type]
    return f"list of {plain}" if field.label == Field.LABEL_REPEATED else plain


def _enums(file: descriptor_pb2.FileDescriptorProto, comments: Comments) -> Iterator[str]:
    for e, enum in enumerate(file.enum_type):
        rows = [
            (value.number, code(value.name), comments.of(ENUM, e, VALUE, v))
            for v, value in enumerate(enum.value)
        ]
        yield f"## {enum.name}\n\n{comments.of(ENUM, e)}\n\n" + table(("no.", "name", "meaning"), rows) + "\n"
