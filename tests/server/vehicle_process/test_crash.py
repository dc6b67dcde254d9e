"""A node that crashes is back at once, tuned as before; one that can't be kept in mind is not started."""

import errno
import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path

import psutil
import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.settings import Settings
from bumpless_server.vehicle_process import process as node_process
from bumpless_server.vehicle_process.node_command import node_command
from bumpless_server.vehicle_process.process import spawn
from tests.server.serving import Running, serving

KILLS = 4


def events(running: Running, code: str) -> list[dict]:
    return [event for event in running.http.get("/api/events?limit=500").json() if event["code"] == code]


def test_a_node_that_crashes_again_and_again_is_back_at_once_and_tuned(
    make_settings: Callable[..., Settings],
) -> None:
    """Protects: after the fifth crash the vehicle had no node for 31 s, and flew untuned from then on."""
    (bus,) = make_settings().zenoh_listen
    light = (sys.executable, "-m", "tests.node.light", bus)
    with serving(make_settings(node_command=light)) as running:
        state = running.console.state
        running.until(lambda: state.latest("parameters") and running.console.speaker.session)
        told = running.http.get("/api/parameters").json()["active"]
        told["hover"]["ramp_cycles"] = tuned = told["hover"]["ramp_cycles"] + 5
        assert running.http.put("/api/parameters", json=told).status_code == 200
        for kill in range(1, KILLS + 1):
            os.kill(running.console.supervisor.pid or 0, signal.SIGKILL)
            running.until(lambda kill=kill: len(events(running, "parameters_restored")) == kill)

            def flown_with() -> int:
                status = state.latest("parameters")
                return status.active.hover.ramp_cycles if isinstance(status, pb.ParametersStatus) else 0

            running.until(lambda: flown_with() == tuned)
        died = [event["text"] for event in events(running, "node_died")]
        assert len(died) == KILLS and all(text.endswith("it is started again") for text in died)


def test_a_node_that_cannot_be_remembered_is_ended_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a full disk at start left a node that nobody supervised and that survived a clean stop."""

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(node_process, "write_whole", full)
    before = set(psutil.Process().children())
    sleeper = (sys.executable, "-c", "import time; time.sleep(600)")
    with pytest.raises(OSError, match="No space"):
        spawn(sleeper, tmp_path / "node.log", tmp_path / "node.json")
    assert set(psutil.Process().children()) == before


def test_what_lies_in_the_working_directory_is_no_part_of_the_node(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a file of the name of one of our modules in the working directory stopped the node."""
    import subprocess

    for name in ("bumpless_server", "bumpless", "server", "zenoh", "signal"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit('taken from the working directory')\n")
    monkeypatch.delenv("PYTHONPATH", raising=False)
    python, *options = node_command(Settings())
    program = [python, *options[: options.index("vehicle") + 1], "--help"]
    done = subprocess.run(program, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
