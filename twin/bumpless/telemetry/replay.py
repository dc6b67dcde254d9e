"""A finished simulation told as the bus would have told it: same messages, same order, same rates."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from google.protobuf.message import Message

from bumpless.telemetry.status import FlightState
from bumpless.telemetry.teller import Teller

if TYPE_CHECKING:
    from bumpless.sim.twin import Result


def run_messages(
    result: "Result", run_id: str, start_time_ns: int = 0, software_version: str = "", session_id: str = ""
) -> Iterator[tuple[int, str, Message]]:
    """All messages of `result` as (time_ns, topic, message), in time order.

    Topics are keys after the vehicle's name, such as "tlm/control". `start_time_ns` is the UNIX time
    given to mission time 0: the same result and arguments give the same bytes.
    """
    from bumpless.config.parameters import default_parameters

    defaults = default_parameters(result.vehicle)
    teller = Teller(result.vehicle, defaults, software_version, session_id, start_time_ns)
    state = FlightState(result.parameters, 1, result.mission, run_id, result.seed)
    events = list(result.events)
    at = 0
    for index, row in enumerate(result.log):
        last = index == len(result.log) - 1
        first = at
        while at < len(events) and (last or events[at].time_s <= row["time"] + 1e-9):
            at += 1
        time_ns = start_time_ns + round(float(row["time"]) * 1e9)
        for topic, message in teller.tell(row, state, events[first:at], time_ns):
            yield time_ns, topic, message
        if last:
            yield time_ns, "tlm/mission", teller.ended(state, result.phase)
