"""A frozen vehicle, a router killed and back, a server killed in a mission, clocks that are far off."""

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from tests.node.listening import program
from tests.ports import free_port
from tests.trust.figure import Figure, at_most, exactly
from tests.trust.recorder import _read
from tests.trust.running import ROOT, await_true, events, light, seeing, settings, start

HOUR_S, YEARS_S = 3600.0, 10 * 365.25 * 86400.0
FROZEN_S, END_S = 5.0, 10.0
QUIET = (pb.LINK_STATE_STALE, pb.LINK_STATE_LOST)


def figures() -> Iterator[Figure]:
    """Each once."""
    yield from _frozen_and_killed()
    yield from _router()
    yield from _clocks()


def _frozen_and_killed() -> Iterator[Figure]:
    endpoint = f"tcp/127.0.0.1:{free_port()}"
    node = subprocess.Popen(light(endpoint), cwd=ROOT, stderr=subprocess.DEVNULL)
    try:
        with tempfile.TemporaryDirectory() as folder:
            of = settings(Path(folder), endpoint, manage_node=False, command_timeout_s=2.0)
            with seeing(of) as (running, seen):
                run, at = start(running), time.monotonic()
                node.send_signal(signal.SIGSTOP)
                stale = seen.until_link(*QUIET, since=at)
                assert running.http.post("/api/mission/abort").status_code == 503
                time.sleep(max(0.0, at + FROZEN_S - time.monotonic()))
                node.send_signal(signal.SIGCONT)
                seen.until_link(pb.LINK_STATE_LIVE, since=at + stale)
                aborted = len(events(running, "mission_aborted"))
                began = time.monotonic()
            ended_s = time.monotonic() - began
            with seeing(of) as (again, _):
                status = await_true(lambda: again.console.state.latest("mission"), "the mission")
                flies_on = isinstance(status, pb.MissionStatus) and status.run_id == run
    finally:
        node.kill()
        node.wait()
    yield at_most("frozen", "vehicle: until said to be stale", stale, "s", 1.0)
    yield exactly("frozen", "aborts of meanwhile carried out later", aborted, "", 0)
    yield at_most("server", "ended in a mission: time to its exit", ended_s, "s", END_S)
    yield exactly("server", "back: the same run flies on", flies_on, "", 1)


def _router() -> Iterator[Figure]:
    endpoint = f"tcp/127.0.0.1:{free_port()}"
    with tempfile.TemporaryDirectory() as folder, ExitStack() as first:
        router = first.enter_context(program("-m", "tests.node.router", endpoint))
        assert router.stdout is not None and router.stdout.readline()
        node = first.enter_context(program("-m", "bumpless_server.cli.main", "vehicle", "ts100", "--connect",
                                           endpoint, "--mode", "client"))  # fmt: skip
        of = settings(Path(folder), zenoh_listen=(), zenoh_connect=(endpoint,), manage_node=False)
        with seeing(of) as (running, seen):
            run = start(running)
            await_true(lambda: running.console.recorder.recording, "the recording")
            at = time.monotonic()
            router.kill()
            lost = seen.until_link(*QUIET, since=at)
            time.sleep(2.0)
            with program("-m", "tests.node.router", endpoint) as again:
                assert again.stdout is not None and again.stdout.readline()
                back = time.monotonic()
                live_at = at + lost + seen.until_link(pb.LINK_STATE_LIVE, since=at + lost)
                resumed = max(0.0, live_at - back)
                time.sleep(2.0)
                recording = running.console.recorder.recording
                same = recording is not None and recording.path.stem == run and node.poll() is None
                assert running.http.post("/api/mission/abort").json()["accepted"]
    yield at_most("router", "killed: until the link is said to be stale", lost, "s", 1.0)
    yield at_most("router", "back: until live again", resumed, "s", 2.0)
    yield exactly("router", "the flight goes on in the same log", same, "", 1)


def _clocks() -> Iterator[Figure]:
    unread = wrong = 0
    for offset_s in (HOUR_S, -HOUR_S, YEARS_S):
        with tempfile.TemporaryDirectory() as folder:
            endpoint = f"tcp/127.0.0.1:{free_port()}"
            environment = {**os.environ, "TRUST_OFFSET_S": str(offset_s)}
            command = (sys.executable, "-m", "tests.trust.shifted", endpoint)
            node = subprocess.Popen(command, cwd=ROOT, env=environment, stderr=subprocess.DEVNULL)
            try:
                with seeing(settings(Path(folder), endpoint, manage_node=False)) as (running, _):
                    run = start(running)
                    time.sleep(2.0)
                    wrong += abs(running.console.clock.offset_s - offset_s) > 0.5
                    assert running.http.post("/api/mission/abort").json()["accepted"]
                    await_true(lambda: running.console.recorder.recording is None, "the end of the recording")
                    rows = running.http.get("/api/runs").json()
                    wrong += [one["id"] for one in rows if one["state"] == "complete"] != [run]
                times = _read(Path(folder) / "data" / "runs" / f"{run}.mcap")
                unread += abs(times[-1] * 1e-9 - time.time()) > 60.0
            except ValueError:
                unread += 1
            finally:
                node.kill()
                node.wait()
    yield exactly(
        "clock", "vehicle's ±1 h and +10 years: logs out of order or at the wrong time", unread, "", 0
    )
    yield exactly("clock", "wrong offsets shown, or runs not listed as complete", wrong, "", 0)
