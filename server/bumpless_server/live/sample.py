"""One message as it came from the bus: its bytes, untouched, and when they arrived."""

import time
from dataclasses import dataclass, field

from google.protobuf.message import DecodeError, Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys

EVENT = "event"
STATUS = "server/status"

# full message name -> class, for every message of the contract
MESSAGES: dict[str, type[Message]] = {
    kind.full_name: getattr(pb, name) for name, kind in pb.DESCRIPTOR.message_types_by_name.items()
}


@dataclass(frozen=True, slots=True)
class Sample:
    """A message of one topic: "tlm/navigation", "event" or "server/status"."""

    topic: str
    schema: str  # full message name, e.g. "bumpless.Navigation"
    payload: bytes
    receive_ns: int = field(default_factory=time.time_ns)  # UNIX time at the server
    from_vehicle: bool = True  # False for what the server itself says

    def decode(self) -> Message | None:
        """The message, or None when the bytes or the schema are not of this contract."""
        kind = MESSAGES.get(self.schema)
        if kind is None:
            return None
        message = kind()
        try:
            message.ParseFromString(self.payload)
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


def telemetry_topic(name: str) -> str:
    """Full topic of a short one: "navigation" -> "tlm/navigation"; full topics pass unchanged."""
    return f"tlm/{name}" if name in keys.TOPICS else name
