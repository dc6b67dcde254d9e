"""One message as it came from the bus: its bytes, untouched, and when they arrived."""

import time
from dataclasses import dataclass, field

from google.protobuf.message import Message

from bumpless.contract import keys
from bumpless.contract.messages import decoded

EVENT = "event"
STATUS = "server/status"
ALARMS = "server/alarms"
CONTROL = "server/control"
AUDIT = "server/audit"


@dataclass(frozen=True, slots=True)
class Sample:
    """A message of one topic: "tlm/navigation", "event" or "server/status"."""

    topic: str
    schema: str  # full message name, e.g. "bumpless.Navigation"
    payload: bytes
    receive_ns: int = field(default_factory=time.time_ns)  # UNIX time at the server
    from_vehicle: bool = True  # False for what the server itself says
    session: str = ""  # the speaker's on the bus, where it tells
    received_s: float = field(default_factory=time.monotonic)  # for ages: never set back

    def decode(self) -> Message | None:
        """The message, or None when the bytes or the schema are not of this contract."""
        return decoded(self.schema, self.payload)


def telemetry_topic(name: str) -> str:
    """Full topic of a short one: "navigation" -> "tlm/navigation"; full topics pass unchanged."""
    return f"tlm/{name}" if name in keys.TOPICS else name
