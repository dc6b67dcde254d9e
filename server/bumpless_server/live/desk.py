"""Commands on their way to the vehicle: a bounded number at once, and stopping has a way of its own."""

import secrets
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.audit import Audit
from bumpless_server.live.ask import EXPIRES_AT, NoAnswer
from bumpless_server.live.clock import VehicleClock
from bumpless_server.live.tally import Tally

URGENT = ("pause", "abort")
AT_ONCE = 8  # commands of each kind that may wait for the vehicle

Ask = Callable[[str, Message, pb.RequestHeader, float], pb.CommandReply]


class Busy(RuntimeError):
    """Too many commands wait for the vehicle already."""


@dataclass(frozen=True)
class Command:
    """What somebody asks of the vehicle. `details` are for the audit: what the request changes."""

    verb: str
    request: Message
    author: str = ""
    address: str = ""
    id: str = field(default_factory=lambda: secrets.token_urlsafe(12))
    if_revision: int | None = None
    details: dict[str, object] = field(default_factory=dict)


class Desk:
    """Hands commands to `ask` on threads of its own: who waits for the vehicle keeps nobody else waiting."""

    def __init__(
        self,
        ask: Ask,
        session: Callable[[], str],
        clock: VehicleClock,
        timeout_s: float,
        audit: Audit,
        tally: Tally,
    ) -> None:
        self._ask, self._session, self._clock, self._timeout_s = ask, session, clock, timeout_s
        self._audit, self._tally = audit, tally
        self._pools = {
            urgent: ThreadPoolExecutor(AT_ONCE, "urgent" if urgent else "command") for urgent in (True, False)
        }
        self._places = {urgent: threading.BoundedSemaphore(AT_ONCE) for urgent in (True, False)}

    def submit(self, command: Command) -> "Future[pb.CommandReply]":
        """Send a command; its future holds the reply or NoAnswer. Raises Busy at once. Never waits."""
        urgent = command.verb in URGENT
        if not self._places[urgent].acquire(blocking=False):
            self._tally.note("too_many_commands", command.verb)
            raise Busy(f"{AT_ONCE} commands wait for the vehicle already; '{command.verb}' was not sent")
        try:
            future = self._pools[urgent].submit(self.carry_out, command)
        except BaseException:
            self._places[urgent].release()
            raise
        future.add_done_callback(lambda _: self._places[urgent].release())
        return future

    def carry_out(self, command: Command) -> pb.CommandReply:
        """Ask the vehicle and write down who asked for what and what came of it. Blocks; raises NoAnswer."""
        began = time.monotonic()
        now = self._clock.to_vehicle(time.time_ns())
        header = pb.RequestHeader(
            id=command.id,
            expires_ns=now + round(EXPIRES_AT * self._timeout_s * 1e9),
            session_id=self._session(),
            author=command.author,
            if_revision=command.if_revision,
        )
        try:
            reply = self._ask(command.verb, command.request, header, self._timeout_s)
        except NoAnswer as error:
            self._tally.note("no_answer", str(error))
            self._audit.add(command, None, str(error), time.monotonic() - began)
            raise
        if reply.cause == pb.REFUSAL_CAUSE_LATE:
            self._tally.note("late_command", f"{command.verb}: {reply.reason}")
        self._audit.add(command, reply, reply.reason, time.monotonic() - began)
        return reply

    def close(self) -> None:
        """Take no more; what waits is answered by the closed bus."""
        for pool in self._pools.values():
            pool.shutdown(wait=False, cancel_futures=True)
