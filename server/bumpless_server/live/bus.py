"""The server's Zenoh session: hears one vehicle and asks it; callbacks only enqueue."""

import logging
from collections.abc import Callable
from typing import Any

import zenoh
from google.protobuf.message import DecodeError, Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import session_config
from bumpless_server.live.sample import Sample

log = logging.getLogger(__name__)

MAX_PAYLOAD_BYTES = 4_000_000


class BusError(RuntimeError):
    """The bus could not be opened: an address is taken or not reachable."""


class NoAnswer(RuntimeError):
    """A command reached no vehicle, or the vehicle did not answer in time."""


class Bus:
    """One session for one vehicle. `on_sample` and `on_alive` run on Zenoh's thread: enqueue only."""

    def __init__(
        self,
        vehicle_id: str,
        listen: tuple[str, ...],
        connect: tuple[str, ...],
        on_sample: Callable[[Sample], None],
        on_alive: Callable[[bool], None],
    ) -> None:
        self.vehicle_id = vehicle_id
        self.ignored = 0  # messages that name no protobuf schema or are absurdly large
        self._on_sample = on_sample
        self._on_alive = on_alive
        self._listen, self._connect = listen, connect
        self._session: zenoh.Session | None = None
        self._held: list[Any] = []  # subscribers live as long as they are referenced

    def open(self) -> None:
        """Open the session and subscribe. Raises BusError with one line for the operator."""
        try:
            session = zenoh.open(session_config("peer", self._connect, self._listen))
        except zenoh.ZError as error:
            raise BusError(
                f"cannot open the bus on {', '.join(self._listen) or 'no endpoint'}: {error}"
            ) from error
        self._session = session
        self._held = [
            session.declare_subscriber(keys.telemetry(self.vehicle_id, "*"), self._receive),
            session.declare_subscriber(keys.event(self.vehicle_id), self._receive),
            session.liveliness().declare_subscriber(
                keys.alive(self.vehicle_id), self._liveliness, history=True
            ),
        ]

    def close(self) -> None:
        """Leave the bus. A session left open would keep the interpreter from exiting."""
        session, self._session, self._held = self._session, None, []
        if session is not None:
            session.close()

    def command(self, verb: str, request: Message, timeout_s: float = 3.0) -> pb.CommandReply:
        """Ask the vehicle and wait for its answer. Raises NoAnswer; blocks, so not on an event loop."""
        session = self._session
        if session is None:
            raise NoAnswer("the bus is closed")
        try:
            replies = session.get(
                keys.command(self.vehicle_id, verb),
                payload=request.SerializeToString(),
                encoding=keys.encoding_of(request),
                timeout=timeout_s,
                congestion_control=zenoh.CongestionControl.BLOCK,
                express=True,
            )
            for reply in replies:
                if reply.ok is not None:
                    return pb.CommandReply.FromString(reply.ok.payload.to_bytes())
                if reply.err is not None:
                    text = reply.err.payload.to_bytes().decode(errors="replace")
                    raise NoAnswer(f"{self.vehicle_id} did not answer '{verb}': {text}")
        except (zenoh.ZError, DecodeError) as error:
            raise NoAnswer(f"{self.vehicle_id} gave no usable answer to '{verb}': {error}") from error
        raise NoAnswer(f"no vehicle {self.vehicle_id} on the bus answers '{verb}'")

    def _receive(self, sample: zenoh.Sample) -> None:
        payload = sample.payload.to_bytes()
        try:
            schema = keys.schema_of(str(sample.encoding))
        except ValueError:
            schema = ""
        if not schema or len(payload) > MAX_PAYLOAD_BYTES:
            self.ignored += 1
            return
        self._on_sample(Sample(keys.topic_of(str(sample.key_expr)), schema, payload))

    def _liveliness(self, sample: zenoh.Sample) -> None:
        self._on_alive(sample.kind == zenoh.SampleKind.PUT)
