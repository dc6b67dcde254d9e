"""A run's views and figures, with a message among the others that nobody can show."""

import math
from collections.abc import Iterable

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.view import Views


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
