"""Requests from the bus: who may still ask for what, answered on two lanes, the urgent one for stopping."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import zenoh

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.carry_out import LARGEST_REQUEST, Executor
from bumpless.node.flight import Flight
from bumpless.node.lane import Lane
from bumpless.node.loop import ControlLoop
from bumpless.node.order import URGENT, Answers, Order, Stops, header_of

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

MOST_WAITING = 16  # on each lane


class Commander:
    """Answers `bumpless/<vehicle>/cmd/*`. A request is carried out before it expires, once, or not at all.

    `now_ns` is the clock that requests expire by; None in virtual time, where they don't.
    """

    def __init__(
        self,
        name: str,
        vehicle: "Vehicle",
        flight: Flight,
        loop: ControlLoop,
        time_ns: Callable[[], int],
        shutdown: Callable[[str], None],
        session_id: str = "",
        now_ns: Callable[[], int] | None = None,
    ) -> None:
        self._name = name  # on the bus
        self._session_id = session_id
        self._now_ns = now_ns
        self._shutdown = shutdown
        self._executor = Executor(vehicle, flight, loop, time_ns)
        self._answers = Answers()
        self._stops = Stops()
        self._ordinary = Lane("commands", MOST_WAITING, self._serve)
        self._urgent = Lane("urgent", MOST_WAITING, self._serve)

    def start(self) -> None:
        """Begin to answer."""
        self._ordinary.start()
        self._urgent.start()

    def close(self) -> None:
        """Answer what has arrived, then end."""
        self._ordinary.close()
        self._urgent.close()

    def enqueue(self, query: zenoh.Query) -> None:
        """The queryable's callback, on Zenoh's thread."""
        verb = str(query.key_expr).rsplit("/", 1)[-1]
        if query.payload is not None and len(query.payload) > LARGEST_REQUEST:
            reason = f"a request has at most {LARGEST_REQUEST} bytes, not {len(query.payload)}"
            self._reply(query, verb, pb.CommandReply(reason=reason))
            return
        before = self._stops.arrived(verb)
        lane = self._urgent if verb in URGENT else self._ordinary
        if not lane.offer((query, verb, before)):
            self._stops.answered(verb)
            reason = f"{MOST_WAITING} requests wait already"
            self._reply(query, verb, pb.CommandReply(reason=reason, cause=pb.REFUSAL_CAUSE_BUSY))

    def _serve(self, asked: tuple[zenoh.Query, str, int]) -> None:
        query, verb, before = asked
        header = header_of(None if query.attachment is None else query.attachment.to_bytes())
        payload = b"" if query.payload is None else query.payload.to_bytes()
        try:
            order = Order(verb, payload, header or pb.RequestHeader(), self._now_ns, self._stops, before)
            reply = self.take(order)
        finally:
            self._stops.answered(verb)
        self._reply(query, verb, reply)
        if verb == "shutdown" and reply.accepted:
            self._shutdown("stopped by command")

    def take(self, order: Order) -> pb.CommandReply:
        """The reply to a request from the bus, by its header first."""
        header = order.header
        if header.session_id and header.session_id != self._session_id:
            reason = f"it was meant for session {header.session_id}, this is {self._session_id}"
            return pb.CommandReply(reason=reason, id=header.id, cause=pb.REFUSAL_CAUSE_NOT_ADDRESSED)
        known = self._answers.of(order) if header.id else None
        if known is not None:
            return known
        if not header.id and order.verb not in URGENT and order.verb in keys.COMMANDS:
            reason = "it has no header with an id and an expiry"
            return self._executor.refuse(order, reason, cause=pb.REFUSAL_CAUSE_NO_HEADER)
        void = order.void()
        reply = self._executor.refuse(order, void[0], cause=void[1]) if void else self._executor.answer(order)
        reply.id = header.id
        self._answers.keep(order, reply)
        return reply

    def answer(self, verb: str, payload: bytes) -> pb.CommandReply:
        """The reply to a request that did not come from the bus: it needs no header."""
        return self._executor.answer(Order(verb, payload))

    def _reply(self, query: zenoh.Query, verb: str, reply: pb.CommandReply) -> None:
        with query:
            if verb in keys.COMMANDS:
                query.reply(
                    keys.command(self._name, verb),
                    reply.SerializeToString(),
                    encoding=keys.encoding_of(reply),
                    express=True,
                )
            else:
                query.reply_err(reply.reason.encode())
