"""A run's views and figures, with a message among the others that nobody can show."""

import math
from collections.abc import Iterable
from pathlib import Path

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.columns import figures_of_file, read_columns
from bumpless.runs.names import COMPLETE
from bumpless.runs.view import Views
from tests.runs.flights import Flight, record


class _Picky:
    """A view that can't show a depth without end."""

    def wants(self, schema: str) -> bool:
        return schema == "bumpless.Navigation"

    def see(self, message: Message) -> Iterable[tuple[str, Message]]:
        assert isinstance(message, pb.Navigation)
        if math.isinf(message.depth_m):
            raise OverflowError("no such place")
        return [("/pose", message)]


def test_one_odd_message_costs_no_view_its_end() -> None:
    """Protects: one `inf` ended /tf, /pose and /scene for the rest of a run."""
    views = Views([_Picky()])
    found = [
        views.see("bumpless.Navigation", pb.Navigation(depth_m=depth).SerializeToString(), None)
        for depth in (1.0, math.inf, 2.0)
    ]
    assert [len(seen) for seen in found] == [1, 0, 1]


def test_one_odd_message_costs_a_run_one_cycle_and_not_its_figures(flight: Flight, tmp_path: Path) -> None:
    """Protects: one message of an odd size, unit or number cost a run all its figures."""
    odd = {
        300: pb.Navigation(depth_m=math.inf),
        400: pb.Actuators(actuators=[pb.Actuator(name="x", unit="deg")]),
        500: pb.Actuators(actuators=[pb.Actuator(name="x", unit="furlong")]),
    }
    bus = []
    for time_ns, topic, schema, payload in flight.bus:
        for cycle, message in odd.items():
            if schema == message.DESCRIPTOR.full_name:
                stamp = type(message).FromString(payload).stamp
                if stamp.cycle == cycle:
                    message.stamp.CopyFrom(stamp)
                    payload = message.SerializeToString()
        bus.append((time_ns, topic, schema, payload))
    path = tmp_path / "odd.mcap"
    record(path, bus)
    whole, found = read_columns(flight.path), read_columns(path)
    assert len(whole.columns) - len(found.columns) == len(odd)
    figures = figures_of_file(path, "odd", COMPLETE, found.status)
    assert figures is not None and math.isfinite(figures[0].residual_rms)
