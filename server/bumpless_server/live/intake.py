"""What is taken from the bus: keys of the contract, of bounded size, decodable, by the vehicle itself."""

import math
from collections.abc import Callable

from google.protobuf.descriptor import FieldDescriptor
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import names
from bumpless.contract.keys import SAID
from bumpless_server.live.clock import VehicleClock
from bumpless_server.live.sample import EVENT, Sample
from bumpless_server.live.speaker import Speaker
from bumpless_server.live.tally import Tally

HEARD = frozenset(topic for topic in SAID if not topic.startswith("truth/"))
MOST_BYTES = 64_000
TEXT_BYTES = 2_000_000  # of topics that carry whole files
TEXTS = frozenset({"tlm/plan", "tlm/description", "tlm/parameters"})
# what the contract itself says to be NaN at times
MAY_BE_NAN = {  # where the contract says that nobody can tell
    "bumpless.Target": frozenset({"measured_range_m", "bearing_deg", "elevation_deg"}),
    "bumpless.ModeExit": frozenset({"expected_s"}),
}
_NUMBERS = (FieldDescriptor.CPPTYPE_DOUBLE, FieldDescriptor.CPPTYPE_FLOAT)
CLOCK_S = 1.0  # of difference, from which it is told

Rival = Callable[[str, str], None]  # (session, what it said)


def most_bytes(topic: str) -> int:
    """Largest message of a topic."""
    return TEXT_BYTES if topic in TEXTS else MOST_BYTES


class Intake:
    """Passes on what may be taken; counts the rest. `rival` hears of messages by somebody else."""

    def __init__(self, tally: Tally, speaker: Speaker, clock: VehicleClock, rival: Rival) -> None:
        self._tally, self._speaker, self._clock, self._rival = tally, speaker, clock, rival
        self._cycles: dict[str, int] = {}
        self._session = ""

    def take(self, sample: Sample) -> Message | None:
        """The decoded message, None when it is not taken."""
        if not self._speaker.accepts(sample.session):
            self._tally.note("second_speaker", f"{sample.topic} by session {sample.session or 'unnamed'}")
            self._rival(sample.session, sample.topic)
            return None
        kind = SAID[sample.topic].DESCRIPTOR.full_name
        if sample.schema != kind:
            self._tally.note("wrong_type", f"{sample.topic} as {sample.schema or 'no protobuf'}")
            return None
        message = sample.decode()
        if message is None:
            self._tally.note("undecodable", f"{sample.topic}, {len(sample.payload)} bytes")
            return None
        if not message.HasField("stamp"):
            self._tally.note("no_stamp", sample.topic)
            return None
        if not self._names_hold(message):
            return None
        odd = non_finite(message)
        if odd:
            self._tally.note("non_finite", f"{sample.topic}: {odd}")
        if sample.topic != EVENT:
            self._look_at_clock(message.stamp.time_ns, sample.receive_ns)  # type: ignore[attr-defined]
        return message

    def is_in_order(self, sample: Sample, message: Message) -> bool:
        """False for a message of a cycle before the newest of its topic, by the same session."""
        if sample.topic == EVENT:
            return True
        if sample.session != self._session:
            self._session, self._cycles = sample.session, {}
        cycle = message.stamp.cycle  # type: ignore[attr-defined]
        if sample.session and cycle < self._cycles.get(sample.topic, 0):
            self._tally.note("out_of_order", f"{sample.topic}: cycle {cycle}")
            return False
        self._cycles[sample.topic] = cycle
        return True

    def _names_hold(self, message: Message) -> bool:
        """Names become paths, addresses and titles: what breaks its rule is not taken at all."""
        told = ""
        if isinstance(message, pb.MissionStatus) and message.run_id and not names.RUN.allows(message.run_id):
            told = f"run id {message.run_id!r}"
        elif isinstance(message, pb.VehicleDescription) and not names.VEHICLE.allows(message.vehicle_id):
            told = f"vehicle id {message.vehicle_id!r}"
        elif isinstance(message, pb.Plan) and message.file_name and not names.FILE.allows(message.file_name):
            told = f"mission file {message.file_name!r}"
        if told:
            self._tally.note("bad_name", told)
        return not told

    def _look_at_clock(self, stamp_ns: int, receive_ns: int) -> None:
        before = self._clock.offset_s
        self._clock.heard(stamp_ns, receive_ns)
        now = self._clock.offset_s
        if abs(now) >= CLOCK_S and abs(now - before) >= CLOCK_S:
            self._tally.note("clock_offset", f"the vehicle's clock is {now:+.1f} s from the server's")


def non_finite(message: Message, within: str = "") -> str:
    """The first field that holds NaN or an infinity, "" when none does."""
    allowed = MAY_BE_NAN.get(message.DESCRIPTOR.full_name, frozenset())
    for field, value in message.ListFields():
        path = within + field.name
        if field.cpp_type in _NUMBERS:
            values = value if field.is_repeated else (value,)
            if not all(map(math.isfinite, values)) and field.name not in allowed:
                return path
        elif field.message_type is not None and not field.message_type.GetOptions().map_entry:
            for part in value if field.is_repeated else (value,):
                found = non_finite(part, path + ".")
                if found:
                    return found
    return ""
