"""What the server counted, measured and left out, as the API tells it."""

from datetime import datetime
from typing import Any, Literal

from bumpless_server.web.answers.contract import Answer


class Counted(Answer):
    """One kind of what was not taken as it came, with its last example."""

    kind: str
    meaning: str
    count: int
    last: datetime | None  # None: never
    example: str


class TopicAge(Answer):
    """How old the last message of a topic is. `late`: older than its rate allows, or never heard."""

    topic: str
    age_s: float | None  # None: never heard
    fresh_for_s: float
    late: bool


class LeftOut(Answer):
    """A file or folder in the data folder that stands in no list, and why."""

    folder: str
    name: str
    reason: str


class Diagnostics(Answer):
    """Nothing silent: every kind that is counted, also those that never happened."""

    counted: list[Counted]
    topics: list[TopicAge]
    left_out: list[LeftOut]
    clock_offset_s: float  # the vehicle's clock minus the server's
    vehicle_session: str  # who speaks for the vehicle on the bus; "" when it tells no id
    bus_notice: str  # "" when no stranger can speak on the bus
    audit_trouble: str  # "" when every command can be written down


class AuditEntry(Answer):
    """One command: who asked for what, and what came of it."""

    time: datetime
    id: str
    verb: str
    author: str
    address: str
    details: dict[str, Any]  # "mission" and "seed", or "changes": path -> [from, to]
    answer: Literal["accepted", "refused", "none"]
    said: str
    took_s: float
