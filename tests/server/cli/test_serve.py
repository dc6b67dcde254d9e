"""The server as a program: its first words, its faults in one line, its end, and its survival by parts."""

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest
from websockets.sync.client import connect

from bumpless.config.vehicle import VehicleError
from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.read import log_messages
from bumpless.runs.records import is_whole
from bumpless_server.console import Console
from bumpless_server.data_dir import DataDir, DataDirError
from bumpless_server.live.bus import BusError
from bumpless_server.settings import Settings
from bumpless_server.vehicle_process.process import adopt
from tests.server.serving import PATIENCE_S

RUN = (sys.executable, "-m", "bumpless_server.cli.main", "serve")


class Server:
    """A server process and what it serves."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process = process
        assert process.stdout is not None
        self.words = process.stdout.readline()
        self.address = self.words.split("//", 1)[-1].split("/", 1)[0]

    def get(self, path: str) -> Any:
        with urllib.request.urlopen(f"http://{self.address}{path}", timeout=PATIENCE_S) as answer:
            return json.load(answer)

    def post(self, path: str, body: dict[str, Any]) -> Any:
        request = urllib.request.Request(
            f"http://{self.address}{path}", json.dumps(body).encode(), {"content-type": "application/json"}
        )
        with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
            return json.load(answer)

    def until(self, holds: Callable[[], Any]) -> Any:
        """Look after every frame of the stream until `holds()` is true."""
        with connect(f"ws://{self.address}/api/stream", max_size=None) as stream:
            for _ in range(2000):
                if found := holds():
                    return found
                stream.recv(timeout=PATIENCE_S)
        raise AssertionError("it did not happen")

    def until_said(self, topic: str, kind: type, holds: Callable[[Any], Any]) -> Any:
        """Wait for a message on the stream."""
        with connect(f"ws://{self.address}/api/stream", max_size=None) as stream:
            for _ in range(2000):
                frame = pb.StreamFrame.FromString(stream.recv(timeout=PATIENCE_S, decode=False))
                for message in frame.messages:
                    if message.topic == topic and holds(said := kind.FromString(message.payload)):
                        return said
        raise AssertionError("it was not said")


def environment(settings: Settings) -> dict[str, str]:
    import shlex

    return {
        **os.environ,
        "BUMPLESS_PORT": "0",
        "BUMPLESS_DATA_DIR": str(settings.data_dir),
        "BUMPLESS_ZENOH_LISTEN": ",".join(settings.zenoh_listen),
        "BUMPLESS_NODE_COMMAND": shlex.join(settings.node_command),
        "BUMPLESS_SCENE": "off",
    }


@pytest.fixture(autouse=True)
def no_node_left(make_settings: Callable[..., Settings]) -> Iterator[None]:
    """A test that fails between two servers must not leave the vehicle flying."""
    yield
    node = adopt(make_settings().data_dir / "node.json")
    if node is not None:
        node.signal(signal.SIGKILL)


@contextmanager
def server(settings: Settings, **more: str) -> Iterator[Server]:
    """A server process; killed if the test leaves it."""
    process = subprocess.Popen(
        RUN,
        env=environment(settings) | more,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    try:
        yield Server(process)
    finally:
        if process.poll() is None:
            process.kill()
        process.communicate()


def node_pid(settings: Settings) -> int:
    return json.loads((settings.data_dir / "node.json").read_text())["pid"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_says_its_address_and_ends_cleanly_with_a_browser_open(
    make_settings: Callable[..., Settings], number: signal.Signals
) -> None:
    """Ctrl-C, a service manager, a closed terminal: exit code 0, no process left, nobody waited for."""
    settings = make_settings()
    with server(settings) as running:
        assert running.words.startswith("Bumpless is at http://127.0.0.1:")
        running.until_said("tlm/mission", pb.MissionStatus, lambda _: True)
        node = psutil.Process(node_pid(settings))
        with connect(f"ws://{running.address}/api/stream"):
            running.process.send_signal(number)
            assert running.process.wait(PATIENCE_S) == 0
        assert not node.is_running()


def test_it_ends_when_the_reader_of_its_words_is_gone(make_settings: Callable[..., Settings]) -> None:
    """Protects: `serve 2>&1 | tee log` did not end on Ctrl-C: tee ends first."""
    settings = make_settings()
    process = subprocess.Popen(
        RUN, env=environment(settings), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        assert process.stdout is not None
        running = Server(process)
        while not running.words.startswith("Bumpless is at"):  # the log comes the same way
            running = Server(process)
        running.until_said("tlm/mission", pb.MissionStatus, lambda _: True)
        node = psutil.Process(node_pid(settings))
        process.stdout.close()
        process.send_signal(signal.SIGINT)
        assert process.wait(PATIENCE_S) == 0
        assert not node.is_running()
    finally:
        process.kill()
        process.wait()


def fault_of(settings: Settings, **more: str) -> str:
    ended = subprocess.run(
        RUN,
        env=environment(settings) | more,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert ended.returncode == 1
    assert "Traceback" not in ended.stderr
    (line,) = ended.stderr.strip().splitlines()
    return line


def test_a_taken_port_is_one_clear_line(make_settings: Callable[..., Settings]) -> None:
    """And nothing has been started by then."""
    settings = make_settings()
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        line = fault_of(settings, BUMPLESS_PORT=str(port))
    assert line == f"bumpless: port {port} on 127.0.0.1 is taken; choose another with --port"
    assert not (settings.data_dir / "node.json").exists()


def test_a_taken_bus_port_and_a_data_folder_in_use_are_one_clear_line_each(
    make_settings: Callable[..., Settings], tmp_path: Path
) -> None:
    """Two servers never share a folder or a bus endpoint."""
    settings = make_settings(manage_node=False)
    with server(settings, BUMPLESS_MANAGE_NODE="0"):
        assert "is in use by another server" in fault_of(settings)
        other = tmp_path / "other"
        fault = fault_of(settings, BUMPLESS_DATA_DIR=str(other))
        assert "cannot open the bus on tcp/127.0.0.1:" in fault and ".rs" not in fault
        assert "choose another with BUMPLESS_ZENOH_LISTEN" in fault


def test_a_killed_server_leaves_the_mission_flying_and_a_new_one_takes_it_up(
    make_settings: Callable[..., Settings],
) -> None:
    """kill -9 of the server: the vehicle flies on; the next server adopts it and records it again."""
    settings = make_settings()
    with server(settings) as first:
        first.until_said("tlm/mission", pb.MissionStatus, lambda _: True)
        run = first.post("/api/mission/start", {"name": "docking"})["run_id"]
        first.until_said("tlm/mission", pb.MissionStatus, lambda status: status.elapsed_s > 2.5)
        pid = node_pid(settings)
        first.process.kill()
        first.process.wait()
    node = psutil.Process(pid)
    assert node.is_running()
    cut = settings.data_dir / "runs" / f"{run}.mcap"
    assert not is_whole(cut)
    with server(settings) as second:
        status = second.until_said("tlm/mission", pb.MissionStatus, lambda s: s.run_id == run)
        assert status.phase == pb.MISSION_PHASE_RUNNING
        codes: set[str] = set()

        def told() -> bool:
            codes.update(event["code"] for event in second.get("/api/events"))
            return {"node_adopted", "run_repaired"} <= codes

        second.until(told)
        assert "node_started" not in codes and node_pid(settings) == pid
        second.until_said("server/status", pb.ServerStatus, lambda s: s.recording_run_id == f"{run}.2")
        assert second.post("/api/mission/abort", {})["accepted"]
        second.until(lambda: second.get(f"/api/runs/{run}.2")["state"] == "complete")
        listed = {row["id"]: row["state"] for row in second.get("/api/runs")}
        assert listed == {run: "interrupted", f"{run}.2": "complete"}
        assert is_whole(cut) and sum(1 for _ in log_messages(cut, {"tlm/navigation"})) > 0
        second.process.send_signal(signal.SIGINT)
        assert second.process.wait(PATIENCE_S) == 0
    assert not node.is_running()


def test_an_old_record_of_a_node_is_not_taken_for_a_living_one(
    make_settings: Callable[..., Settings],
) -> None:
    """A process id that somebody else has by now is neither adopted nor ever signalled."""
    settings = make_settings()
    settings.data_dir.mkdir(parents=True)
    record = settings.data_dir / "node.json"
    for told in ({"pid": os.getpid(), "created": 1.0}, {"pid": 2**22 + 1, "created": 1.0}, {"pid": "x"}, []):
        record.write_text(json.dumps(told))
        assert adopt(record) is None
    record.write_text("{")
    assert adopt(record) is None


def test_a_start_that_fails_leaves_nothing_half_started(
    make_settings: Callable[..., Settings], tmp_path: Path
) -> None:
    """No thread, lock or process stays behind a fault, and the fault is one sentence."""
    (tmp_path / "file").write_text("")
    with pytest.raises(DataDirError, match="cannot write to the data folder"):
        Console(make_settings(data_dir=tmp_path / "file")).start()
    with pytest.raises(VehicleError, match="no such vehicle"):
        Console(make_settings(vehicle=str(tmp_path / "none.toml")))
    before = threading.active_count()
    with pytest.raises(BusError, match="cannot open the bus on"):
        Console(make_settings(zenoh_listen=("tcp/127.0.0.1:99999",))).start()
    assert threading.active_count() == before
    lock = DataDir(make_settings().data_dir)
    lock.open()
    lock.close()
