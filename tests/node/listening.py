"""The other end of the bus for tests: hears everything of a vehicle, asks it, starts and ends its node."""

import os
import secrets
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import zenoh
from google.protobuf import message_factory
from google.protobuf.descriptor_pool import Default

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.session import node_config

ROOT = Path(__file__).parents[2]
PATIENCE_S = 60.0  # for what must come; nothing is measured by it


class Listener:
    """A session with everything that the vehicle said so far, decoded by the encoding's message name."""

    def __init__(self, session: zenoh.Session, vehicle: str = "ts100") -> None:
        self.session, self.vehicle = session, vehicle
        self.heard: list[tuple[str, Any, bytes]] = []
        self.alive: list[bool] = []
        self._changed = threading.Condition()
        # what a vehicle says, key by key: on a bus with keys nobody may ask for more
        said = (keys.telemetry(vehicle, "*"), keys.event(vehicle), keys.truth(vehicle))
        self._held = [
            *(session.declare_subscriber(key, self._hear) for key in said),
            session.liveliness().declare_subscriber(keys.alive(vehicle), self._live, history=True),
        ]

    def _hear(self, sample: zenoh.Sample) -> None:
        name = keys.schema_of(str(sample.encoding))
        kind = message_factory.GetMessageClass(Default().FindMessageTypeByName(name))
        payload = sample.payload.to_bytes()
        with self._changed:
            self.heard.append((keys.topic_of(str(sample.key_expr)), kind.FromString(payload), payload))
            self._changed.notify_all()

    def _live(self, sample: zenoh.Sample) -> None:
        with self._changed:
            self.alive.append(sample.kind == zenoh.SampleKind.PUT)
            self._changed.notify_all()

    def of(self, topic: str) -> list[Any]:
        """All messages of one topic, such as "tlm/control" or "event"."""
        return [message for heard, message, _ in list(self.heard) if heard == topic]

    def until(self, true: Callable[[], Any]) -> Any:
        """Wait until something heard makes `true()` true; its value."""
        with self._changed:
            value = self._changed.wait_for(true, PATIENCE_S)
        assert value, f"did not come; heard {sorted({topic for topic, _, _ in self.heard})}"
        return value

    def until_alive(self, count: int = 1) -> None:
        """Wait until the vehicle has come to life `count` times."""
        self.until(lambda: sum(self.alive) >= count)

    def until_all_said(self) -> None:
        """Wait until all that happened in the vehicle so far has been heard: a reply overtakes its events."""
        now = time.time_ns()
        self.until(lambda: any(m.stamp.time_ns > now for m in self.of("tlm/navigation")[-1:]))

    def ask(self, verb: str, request: Any = None, **header: Any) -> pb.CommandReply:
        """Send a command with an id of its own and a minute's time, or as `header` says; the reply."""
        payload = b"" if request is None else request.SerializeToString()
        said = {"id": secrets.token_hex(8), "expires_ns": time.time_ns() + round(PATIENCE_S * 1e9)}
        replies = list(
            self.session.get(
                keys.command(self.vehicle, verb),
                payload=payload,
                attachment=pb.RequestHeader(**{**said, **header}).SerializeToString(),
                timeout=PATIENCE_S,
            )
        )
        assert len(replies) == 1 and replies[0].ok is not None
        assert str(replies[0].ok.encoding) == keys.encoding_of(pb.CommandReply)
        return pb.CommandReply.FromString(replies[0].ok.payload.to_bytes())

    def start(self, name: str = "docking.yaml") -> pb.CommandReply:
        """Have a mission of the missions folder flown."""
        text = (ROOT / "missions" / name).read_text()
        return self.ask("start", pb.StartMission(file_name=name, mission_yaml=text))


@contextmanager
def listening(*listen: str, connect: tuple[str, ...] = ()) -> Iterator[Listener]:
    """A listener that listens on these endpoints."""
    with zenoh.open(node_config(connect, listen, "peer")) as session:
        yield Listener(session)


@contextmanager
def program(*arguments: str, **environment: str) -> Iterator[subprocess.Popen[str]]:
    """`python <arguments>` in a process of its own, ended at the latest here."""
    process = subprocess.Popen(
        [sys.executable, *arguments],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    try:
        yield process
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGCONT)
            process.kill()
        process.communicate()


def light_node(endpoint: str, *more: str) -> Any:
    """A node with a light twin in it; `more` are "realtime" or "fast", and a mission to begin with."""
    return program("-m", "tests.node.light", endpoint, *more)


def light_node_with(endpoint: str = "", vehicle: str = "", zenoh_config: str = "", memory: str = "") -> Any:
    """A paced node with a light twin in it, with files of its own."""
    return light_node(endpoint, "realtime", "", vehicle, zenoh_config, memory)


def ended(process: "subprocess.Popen[str]") -> tuple[int, str]:
    """Exit code and output of a program that is about to end."""
    output, _ = process.communicate(timeout=PATIENCE_S)
    return process.returncode, output
