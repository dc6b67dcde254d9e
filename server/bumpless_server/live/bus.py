"""The server's Zenoh session: hears one vehicle and asks it; callbacks only enqueue."""

import contextlib
import logging
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import zenoh
import zenoh.ext
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import asks_for_keys, endpoints_of, session_config, session_file
from bumpless_server.live.ask import NoAnswer, Question
from bumpless_server.live.intake import HEARD, Rival, most_bytes
from bumpless_server.live.open_bus import bus_notice
from bumpless_server.live.sample import Sample
from bumpless_server.live.speaker import Speaker
from bumpless_server.live.tally import Tally

log = logging.getLogger(__name__)
# of the publishers' last ones too: some topics are said once in a while
ASK_FOR_MISSED = zenoh.ext.RecoveryConfig(periodic_queries=None, heartbeat=True)


class BusError(RuntimeError):
    """The bus could not be opened: an address is taken or not reachable."""


class Bus:
    """One session for one vehicle. `on_sample` and `on_alive` run on Zenoh's thread: enqueue only.

    `rival` hears of answers by somebody else than the vehicle. `config` is a Zenoh configuration file to use
    instead of the endpoints. Raises BusError when it is none.
    """

    def __init__(
        self,
        vehicle_id: str,
        listen: tuple[str, ...],
        connect: tuple[str, ...],
        on_sample: Callable[[Sample], None],
        on_alive: Callable[[bool], None],
        speaker: Speaker,
        tally: Tally,
        rival: Rival = lambda session, said: None,
        config: Path | None = None,
    ) -> None:
        self.vehicle_id = vehicle_id
        self._speaker, self._tally, self._rival = speaker, tally, rival
        self._on_sample = on_sample
        self._on_alive = on_alive
        self._config, self._at = _configured(listen, connect, config)
        # in words while strangers may speak here, "" when they can't
        dialled, listened = endpoints_of(self._config)
        self.notice = bus_notice(listened, dialled, asks_for_keys(self._config))
        self._session: zenoh.Session | None = None
        self._held: list[Any] = []  # subscribers live as long as they are referenced

    def open(self) -> None:
        """Open the session and subscribe. Raises BusError with one line for the operator."""
        try:
            session = zenoh.open(self._config)
        except zenoh.ZError as error:
            raise BusError(f"cannot open the bus on {self._at}: {_why(error)}") from error
        self._session = session
        self._held = [
            *self._hear(session, keys.telemetry(self.vehicle_id, "*")),
            *self._hear(session, keys.event(self.vehicle_id)),
            session.liveliness().declare_subscriber(
                keys.claim(self.vehicle_id, "*", "*"), self._claims, history=True
            ),
            session.liveliness().declare_subscriber(
                keys.alive(self.vehicle_id), self._liveliness, history=True
            ),
        ]

    def _hear(self, session: zenoh.Session, key: str) -> list[Any]:
        """Hear what is said on `key`; what a cut of the link swallowed is asked for, up to what is kept."""
        subscriber = zenoh.ext.declare_advanced_subscriber(
            session, key, self._receive, recovery=ASK_FOR_MISSED
        )
        return [subscriber, subscriber.sample_miss_listener(self._missed)]

    def _missed(self, miss: zenoh.ext.Miss) -> None:
        self._tally.note("missed", f"{miss.nb} in a row by session {miss.source.zid}", miss.nb)

    def close(self) -> None:
        """Leave the bus. A session left open would keep the interpreter from exiting."""
        session, self._session, self._held = self._session, None, []
        if session is not None:
            session.close()

    def command(
        self, verb: str, request: Message, header: pb.RequestHeader, timeout_s: float = 3.0
    ) -> pb.CommandReply:
        """Ask the vehicle and wait for its answer. Raises NoAnswer; blocks, so not on an event loop."""
        session = self._session
        if session is None:
            raise NoAnswer("the bus is closed")
        question = Question(self.vehicle_id, verb, header.id, self._speaker.session, self._foreign_reply)
        return question.ask(session, request, header, timeout_s)

    def beat(self, in_control: bool) -> None:
        """Say that a console is there, and whether the holder of control is; never waits."""
        session = self._session
        if session is None:
            return
        beat = pb.Heartbeat(time_ns=time.time_ns(), session_id=str(session.zid()), in_control=in_control)
        with contextlib.suppress(zenoh.ZError):
            session.put(
                keys.heartbeat(self.vehicle_id), beat.SerializeToString(), encoding=keys.encoding_of(beat)
            )

    def _foreign_reply(self, verb: str, session_id: str) -> None:
        self._tally.note("foreign_reply", f"'{verb}' by session {session_id or 'unnamed'}")
        self._rival(session_id, f"an answer to '{verb}'")

    def _receive(self, sample: zenoh.Sample) -> None:
        topic = keys.topic_of(str(sample.key_expr))
        if topic not in HEARD:
            self._tally.note("unknown_key", str(sample.key_expr))
            return
        size = len(sample.payload)
        if size > most_bytes(topic):
            self._tally.note("too_large", f"{topic}, {size} bytes")
            return
        try:
            schema = keys.schema_of(str(sample.encoding))
        except ValueError:
            schema = ""
        session = "" if sample.timestamp is None else str(sample.timestamp.get_id())
        self._on_sample(Sample(topic, schema, sample.payload.to_bytes(), session=session))

    def _claims(self, sample: zenoh.Sample) -> None:
        since, session_id = str(sample.key_expr).split("/")[-2:]
        self._speaker.claim(session_id, since, sample.kind == zenoh.SampleKind.PUT)

    def _liveliness(self, sample: zenoh.Sample) -> None:
        present = sample.kind == zenoh.SampleKind.PUT
        self._speaker.token(present)
        self._on_alive(present)


def _why(error: zenoh.ZError) -> str:
    """Zenoh's words, which name its own lines of code; a taken address is told as what it is."""
    if "Address already in use" not in str(error):
        return str(error)
    return (
        "it is taken, by another Bumpless or a router; choose another with BUMPLESS_ZENOH_LISTEN,"
        " such as tcp/127.0.0.1:7448"
    )


def _configured(listen: Sequence[str], connect: Sequence[str], file: Path | None) -> tuple[zenoh.Config, str]:
    """The session's configuration, and where it is in words."""
    if file is None:
        return session_config("peer", connect, listen), ", ".join(listen) or "no endpoint"
    try:
        return session_file(file), f"the endpoints of {file}"
    except (OSError, ValueError) as error:
        raise BusError(f"cannot open the bus: {error}") from error
