"""Where each message travels: key expressions, encodings, topics and their nominal rates.

Both sides of the bus, the log and the tests read this table; nothing else spells a key.
"""

from dataclasses import dataclass

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import names

ROOT = "bumpless"
ENCODING_PREFIX = "application/protobuf;"
FILLED_S = (
    60.0  # a cut of the link up to this long leaves no gap: the vehicle keeps what it said, and is asked
)


@dataclass(frozen=True)
class Topic:
    """One telemetry topic: its name, its message and how often a healthy vehicle says it."""

    name: str
    message: type[Message]
    rate_hz: float | None  # None: once per control cycle
    on_change: bool = False  # also said at once when the content changes
    filled: bool = True  # what a cut of the link swallowed is asked for afterwards; else the next one does

    @property
    def schema(self) -> str:
        """Full message name, e.g. "bumpless.Navigation"."""
        return self.message.DESCRIPTOR.full_name

    def nominal_rate_hz(self, control_period_s: float) -> float:
        """Expected rate for a vehicle with this control period, 1/s."""
        return 1.0 / control_period_s if self.rate_hz is None else self.rate_hz


TOPICS: dict[str, Topic] = {
    topic.name: topic
    for topic in (
        Topic("navigation", pb.Navigation, None),
        Topic("guidance", pb.Guidance, None),
        Topic("supervisor", pb.Supervisor, None),
        Topic("control", pb.Control, None),
        Topic("allocation", pb.Allocation, None),
        Topic("actuators", pb.Actuators, None),
        Topic("target", pb.Target, None),
        Topic("exits", pb.Exits, 5.0),
        Topic("mission", pb.MissionStatus, 2.0, on_change=True),
        Topic("plan", pb.Plan, 0.5, on_change=True, filled=False),
        Topic("parameters", pb.ParametersStatus, 1.0, on_change=True, filled=False),
        Topic("description", pb.VehicleDescription, 0.5, filled=False),
        Topic("health", pb.Health, 1.0),
    )
}

# topic as logs and streams name it -> message: all that a vehicle says
SAID: dict[str, type[Message]] = {f"tlm/{name}": topic.message for name, topic in TOPICS.items()} | {
    "event": pb.Event,
    "truth/state": pb.TruthState,
}

# verb -> request message; every command answers with CommandReply
COMMANDS: dict[str, type[Message]] = {
    "start": pb.StartMission,
    "pause": pb.Empty,
    "resume": pb.Empty,
    "surface": pb.Empty,
    "abort": pb.Empty,
    "set_parameters": pb.Parameters,
    "shutdown": pb.Empty,
}


def check_vehicle_id(vehicle: str) -> str:
    """Return `vehicle` when it can be part of a key, else raise BadName with the rule."""
    return names.VEHICLE.check(vehicle, "vehicle id")


def telemetry(vehicle: str, topic: str) -> str:
    """Key of one telemetry topic; `topic` may be "*" or "**"."""
    return f"{ROOT}/{vehicle}/tlm/{topic}"


def event(vehicle: str) -> str:
    """Key of the vehicle's events."""
    return f"{ROOT}/{vehicle}/event"


def command(vehicle: str, verb: str) -> str:
    """Key of the queryable that answers `verb`."""
    return f"{ROOT}/{vehicle}/cmd/{verb}"


def heartbeat(vehicle: str) -> str:
    """Key on which consoles say that they are there."""
    return f"{ROOT}/{vehicle}/heartbeat"


def alive(vehicle: str) -> str:
    """Key of the liveliness token."""
    return f"{ROOT}/{vehicle}/alive"


def claim(vehicle: str, since_ns: int | str, session_id: str) -> str:
    """Key of the token by which nodes that want the same vehicle id see each other; "*" stands for any."""
    since = since_ns if isinstance(since_ns, str) else f"{since_ns:020d}"
    return f"{ROOT}/{vehicle}/claim/{since}/{session_id}"


def truth(vehicle: str) -> str:
    """Key of a simulated vehicle's true state; read by tests and by the simulator's own log only."""
    return f"{ROOT}/{vehicle}/truth/state"


def schema(vehicle: str) -> str:
    """Key of the queryable that serves the contract's FileDescriptorSet."""
    return f"{ROOT}/{vehicle}/schema"


def topic_of(key: str) -> str:
    """The part of `key` after the vehicle: "bumpless/ts100/tlm/control" -> "tlm/control"."""
    root, _, rest = key.partition("/")
    vehicle, _, topic = rest.partition("/")
    if root != ROOT or not vehicle or not topic:
        raise ValueError(f"{key!r} is not a key of {ROOT}/<vehicle>/<topic>")
    return topic


def vehicle_of(key: str) -> str:
    """The vehicle id in `key`."""
    topic_of(key)
    return key.split("/", 2)[1]


def encoding_of(message: Message | type[Message]) -> str:
    """Zenoh encoding that names the message type: "application/protobuf;bumpless.Navigation"."""
    return ENCODING_PREFIX + message.DESCRIPTOR.full_name


def schema_of(encoding: str) -> str:
    """Full message name in a Zenoh encoding; ValueError when it is not protobuf."""
    if not encoding.startswith(ENCODING_PREFIX):
        raise ValueError(f"encoding {encoding!r} does not name a protobuf message")
    return encoding[len(ENCODING_PREFIX) :]
