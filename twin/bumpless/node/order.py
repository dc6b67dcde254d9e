"""A request with its header: may it still be carried out, and what was the same one answered before?"""

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field

from google.protobuf.message import DecodeError

from bumpless.contract import bumpless_pb2 as pb

URGENT = ("pause", "abort")  # have a way of their own, and need no header: to stop is always allowed
OVERTAKEN_BY_URGENT = ("start", "resume")  # what a later pause or abort has made void
REMEMBERED = 256  # answers kept by id
LONGEST_ID = 64

Refusal = tuple[str, pb.RefusalCause]


def header_of(attachment: bytes | None) -> pb.RequestHeader | None:
    """The header in a query's attachment; None without one that can be read."""
    if attachment is None:
        return None
    try:
        header = pb.RequestHeader.FromString(attachment)
    except DecodeError:
        return None
    return header if 0 < len(header.id) <= LONGEST_ID and header.expires_ns else None


class Stops:
    """Counts pauses and aborts as they arrive, and the starts that wait meanwhile; usable from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.count = 0
        self._starts = 0

    def arrived(self, verb: str) -> int:
        """Note an arrival; the number of stops so far."""
        with self._lock:
            self.count += verb in URGENT
            self._starts += verb == "start"
            return self.count

    def answered(self, verb: str) -> None:
        """What had arrived has its answer."""
        with self._lock:
            self._starts -= verb == "start"

    @property
    def starts_wait(self) -> bool:
        """Has a start arrived that is not answered yet?"""
        return self._starts > 0


@dataclass(frozen=True)
class Order:
    """One request on its way through the node. `now_ns` is None where requests do not expire."""

    verb: str
    payload: bytes
    header: pb.RequestHeader = field(default_factory=pb.RequestHeader)
    now_ns: Callable[[], int] | None = None
    stops: Stops = field(default_factory=Stops)
    stops_before: int = 0

    @property
    def left_s(self) -> float:
        """Seconds until it expires; infinite when it does not."""
        if self.now_ns is None or not self.header.expires_ns:
            return float("inf")
        return (self.header.expires_ns - self.now_ns()) * 1e-9

    def void(self) -> Refusal | None:
        """Why it must not be carried out any more; None while it may be."""
        if self.left_s <= 0.0:
            return f"it came {-self.left_s:.1f} s after it had expired", pb.REFUSAL_CAUSE_LATE
        if self.verb in OVERTAKEN_BY_URGENT and self.stops.count != self.stops_before:
            return "a pause or an abort came after it", pb.REFUSAL_CAUSE_OVERTAKEN
        return None


class Answers:
    """What was answered to the last requests, by id: a repeated one is not carried out again."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._by_id: OrderedDict[str, tuple[str, pb.CommandReply]] = OrderedDict()

    def of(self, order: Order) -> pb.CommandReply | None:
        """The answer that this request had before; None when it is new."""
        with self._lock:
            known = self._by_id.get(order.header.id)
        if known is None:
            return None
        verb, reply = known
        return reply if verb == order.verb else pb.CommandReply(reason=f"the id was used for '{verb}'")

    def keep(self, order: Order, reply: pb.CommandReply) -> None:
        """Remember an answer."""
        if not order.header.id:
            return
        with self._lock:
            self._by_id[order.header.id] = order.verb, reply
            while len(self._by_id) > REMEMBERED:
                self._by_id.popitem(last=False)
