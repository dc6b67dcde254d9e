"""Random, mutated and forged messages on every key: nothing ends, all is counted, memory stays bounded."""

import random
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
import zenoh

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import session_config
from tests.ports import free_port
from tests.server.serving import Running
from tests.trust.figure import Figure, at_most, exactly
from tests.trust.mutate import mutated_bytes
from tests.trust.running import ROOT, await_true, light, seeing, settings, start

MOST_GROWTH_MB = 64.0
FULL = 20_000  # messages, from which on memory is looked at
REQUESTS = 0.02  # share that asks the vehicle for something; each waits for its answer


def figures(count: int, seed: int = 3) -> Iterator[Figure]:
    """Say `count` messages into a mission that is being flown."""
    endpoint, draw = f"tcp/127.0.0.1:{free_port()}", random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        node = subprocess.Popen(light(endpoint), cwd=ROOT, stderr=subprocess.DEVNULL)
        try:
            with seeing(settings(Path(folder), endpoint, manage_node=False)) as (running, _):
                run = start(running)
                with zenoh.open(session_config("peer", [endpoint], timestamps=True)) as stranger:
                    storm = Storm(stranger, draw)
                    storm.say(count // 10)
                    if count >= FULL:  # what is kept for gaps has then been kept
                        await_true(lambda: _elapsed_s(running) > keys.FILLED_S + 5.0, "a minute of flight")
                    before = _memory_mb(node.pid)
                    storm.say(count - count // 10)
                    grown = _memory_mb(node.pid) - before
                    told = await_true(lambda: _all_told(running, storm), "every message counted")
                status = running.console.state.latest("mission")
                true = isinstance(status, pb.MissionStatus) and status.run_id == run
                flown = node.poll() is None and running.http.post("/api/mission/abort").json()["accepted"]
        finally:
            node.kill()
            node.wait()
    yield exactly(
        "bus", f"of {storm.said} messages and {storm.asked} requests, processes ended", 1 - flown, "", 0
    )
    yield exactly("bus", "messages taken for the vehicle's or not counted", storm.said - told, "", 0)
    yield exactly("bus", "times the screen showed another run than the one flown", 1 - true, "", 0)
    if count >= FULL:
        yield at_most(
            "bus", "growth of server and vehicle after the first minute", grown, "MB", MOST_GROWTH_MB
        )


class Storm:
    """A stranger who says all kinds of things on all keys of a vehicle."""

    def __init__(self, session: zenoh.Session, draw: random.Random) -> None:
        self._session, self._draw = session, draw
        self.said = self.asked = 0
        self._topics = [(topic, kind) for topic, kind in keys.SAID.items() if topic != "truth/state"]
        self._whole = [
            kind(stamp=pb.Stamp(time_ns=1, cycle=1)).SerializeToString() for _, kind in self._topics
        ]

    def say(self, count: int) -> None:
        """So many messages, one request among fifty."""
        for _ in range(count):
            if self._draw.random() < REQUESTS:
                self._ask()
            else:
                self._put()

    def _put(self) -> None:
        draw = self._draw
        at = draw.randrange(len(self._topics))
        topic, kind = self._topics[at]
        payload = self._whole[at]
        how = draw.randrange(4)
        if how == 1:
            payload = mutated_bytes(payload, draw)
        elif how == 2:
            payload = draw.randbytes(draw.choice((0, 1, 40, 4000)))
        elif how == 3:
            kind = draw.choice(self._topics)[1]
        key = (
            f"{keys.ROOT}/ts100/{topic}" if draw.random() < 0.9 else f"{keys.ROOT}/ts100/tlm/{draw.random()}"
        )
        self._session.put(
            key, payload, encoding=keys.encoding_of(kind), congestion_control=zenoh.CongestionControl.BLOCK
        )
        self.said += 1

    def _ask(self) -> None:
        draw = self._draw
        verb = draw.choice((*keys.COMMANDS, "scuttle"))
        if verb in ("pause", "abort", "shutdown"):  # a bus without keys lets anybody stop: not tried here
            verb = "set_parameters"
        payload = draw.randbytes(draw.choice((0, 10, 3000)))
        header = pb.RequestHeader(
            id=str(draw.random()), expires_ns=time.time_ns() + 10**9
        ).SerializeToString()
        replies = self._session.get(
            keys.command("ts100", verb),
            payload=payload,
            attachment=mutated_bytes(header, draw) if draw.random() < 0.5 else header,
            timeout=2.0,
        )
        for reply in replies:
            reply.ok  # noqa: B018
        self.asked += 1


def _all_told(running: Running, storm: Storm) -> int:
    """How many were counted, once no more are under way."""
    tally = running.console.tally
    told = sum(tally.of(kind) for kind in ("second_speaker", "unknown_key", "too_large"))
    return told if told >= storm.said else 0


def _elapsed_s(running: Running) -> float:
    status = running.console.state.latest("mission")
    return status.elapsed_s if isinstance(status, pb.MissionStatus) else 0.0


def _memory_mb(node: int) -> float:
    return sum(psutil.Process(pid).memory_info().rss for pid in (node, psutil.Process().pid)) / 1e6
