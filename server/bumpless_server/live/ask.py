"""One question to the vehicle: the answer counts only when it is the vehicle's own, to this very question."""

import queue
import time
from collections.abc import Callable

import zenoh
from google.protobuf.message import DecodeError, Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys

EXPIRES_AT = 0.6  # of the time we wait: what is carried out in the last moment can still be answered


class NoAnswer(RuntimeError):
    """A command reached no vehicle, or the vehicle did not answer in time."""


class Question:
    """`session_id` is the vehicle's on the bus, "" when not known; `foreign` hears of others' answers."""

    def __init__(
        self,
        vehicle_id: str,
        verb: str,
        request_id: str,
        session_id: str,
        foreign: Callable[[str, str], None],
    ) -> None:
        self._vehicle_id, self._verb = vehicle_id, verb
        self._id, self._session_id, self._foreign = request_id, session_id, foreign
        self._answers: queue.SimpleQueue[pb.CommandReply | str | None] = queue.SimpleQueue()

    def ask(
        self, session: zenoh.Session, request: Message, header: pb.RequestHeader, timeout_s: float
    ) -> pb.CommandReply:
        """Send it to everyone who answers this verb, and wait for the vehicle. Raises NoAnswer."""
        until = time.monotonic() + timeout_s
        try:
            session.get(
                keys.command(self._vehicle_id, self._verb),
                zenoh.handlers.Callback(self._on_reply, lambda: self._answers.put(None)),
                payload=request.SerializeToString(),
                encoding=keys.encoding_of(request),
                attachment=header.SerializeToString(),
                timeout=timeout_s,
                target=zenoh.QueryTarget.ALL,
                consolidation=zenoh.ConsolidationMode.NONE,
                congestion_control=zenoh.CongestionControl.BLOCK,
                express=True,
            )
        except zenoh.ZError as error:
            raise NoAnswer(f"'{self._verb}' could not be asked: {error}") from error
        why = f"no vehicle {self._vehicle_id} on the bus answers '{self._verb}'"
        while True:
            try:
                answer = self._answers.get(timeout=max(0.0, until - time.monotonic()))
            except queue.Empty:
                answer = None
            if isinstance(answer, pb.CommandReply):
                return answer
            if answer is None:
                late = "; should it arrive later, the vehicle refuses it" if time.monotonic() >= until else ""
                raise NoAnswer(why + late)
            why = answer

    def _on_reply(self, reply: zenoh.Reply) -> None:
        """On Zenoh's thread: whose is it, and is it an answer to this?"""
        replier = "" if reply.replier_id is None else str(reply.replier_id.zid)
        if self._session_id and replier and replier != self._session_id:
            self._foreign(self._verb, replier)
            self._answers.put(f"somebody else than {self._vehicle_id} answered '{self._verb}'")
            return
        if reply.ok is None:
            text = reply.err.payload.to_bytes()[:500].decode(errors="replace") if reply.err else "nothing"
            self._answers.put(f"{self._vehicle_id} did not answer '{self._verb}': {text}")
            return
        try:
            answer = pb.CommandReply.FromString(reply.ok.payload.to_bytes())
        except DecodeError as error:
            self._answers.put(f"{self._vehicle_id} gave no usable answer to '{self._verb}': {error}")
            return
        if answer.id != self._id:
            self._answers.put(f"{self._vehicle_id} answered another request than '{self._verb}'")
            return
        self._answers.put(answer)
