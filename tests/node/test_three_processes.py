"""Router, server and vehicle as plain processes, by the words of docker-compose.yml; each may fail alone."""

import re
import subprocess
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest
from ruamel.yaml import YAML
from websockets.sync.client import connect as connect_websocket

from bumpless.contract import bumpless_pb2 as pb
from tests.node.listening import PATIENCE_S, ROOT, program
from tests.ports import free_port

PASSWORD = "a secret of this test"
FRAMES = 6000  # of the stream, after which what was waited for will not come


class Field:
    """The three services of docker-compose.yml, each to be started and killed by itself."""

    def __init__(self, data: Path) -> None:
        self.services = YAML(typ="safe").load(ROOT / "docker-compose.yml")["services"]
        self.router_at = f"tcp/127.0.0.1:{free_port()}"
        self.data = data
        self.password_file = data.with_name("password")
        self.password_file.write_text(f"{PASSWORD}\n")

    def router(self) -> Any:
        return program("-m", "tests.node.router", self.router_at)

    def vehicle(self) -> Any:
        # Across machines the endpoint alone makes the vehicle the router's client; on loopback we say so.
        return program("-m", "bumpless_server.cli.main", *self._words("vehicle"), "--mode", "client")

    def server(self) -> Any:
        environment = {k: self._here(str(v)) for k, v in self.services["server"]["environment"].items()}
        environment |= {
            "BUMPLESS_FIRST_PASSWORD_FILE": str(self.password_file),
            "BUMPLESS_HOST": "127.0.0.1",
            "BUMPLESS_PORT": "0",
            "BUMPLESS_DATA_DIR": str(self.data),
            "BUMPLESS_ZENOH_LISTEN": "tcp/127.0.0.1:0",
            "BUMPLESS_SCENE": "off",
        }
        return program("-m", "bumpless_server.cli.main", *self._words("server"), **environment)

    def _words(self, service: str) -> list[str]:
        return [self._here(word) for word in self.services[service]["command"]]

    def _here(self, word: str) -> str:
        return word.replace("tcp/router:7447", self.router_at)


class Console:
    """A browser without a screen: logged in, reading the stream."""

    def __init__(self, http: httpx.Client, frames: Any) -> None:
        self.http, self._frames = http, frames

    def until(self, topic: str, kind: Callable[[bytes], Any], true: Callable[[Any], bool]) -> Any:
        """The next message of `topic` for which `true` holds."""
        for _ in range(FRAMES):
            for message in pb.StreamFrame.FromString(self._frames.recv(PATIENCE_S)).messages:
                if message.topic == topic and true(found := kind(message.payload)):
                    return found
        raise AssertionError(f"no such {topic}")

    def until_link(self, state: int) -> pb.ServerStatus:
        return self.until("server/status", pb.ServerStatus.FromString, lambda s: s.link == state)

    def until_mission(self, true: Callable[[pb.MissionStatus], bool]) -> pb.MissionStatus:
        return self.until("tlm/mission", pb.MissionStatus.FromString, true)


@contextmanager
def console(server: "subprocess.Popen[str]") -> Iterator[Console]:
    """Open the address that the server prints."""
    assert server.stdout is not None
    lines = iter(server.stdout.readline, "")
    port = next(int(found[1]) for line in lines if (found := re.search(r"http://[^:]+:(\d+)/", line)))
    with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=PATIENCE_S) as http:
        assert http.get("/api/status").status_code == 401
        login = {"name": "engineer", "password": PASSWORD}
        assert http.post("/api/login", json=login).status_code == 204
        cookie = "; ".join(f"{name}={value}" for name, value in http.cookies.items())
        with connect_websocket(
            f"ws://127.0.0.1:{port}/api/stream",
            additional_headers={"Cookie": cookie},
            origin=f"http://127.0.0.1:{port}",  # pyright: ignore[reportArgumentType]
            compression=None,
        ) as frames:
            yield Console(http, frames)


def said(process: "subprocess.Popen[str]", words: str) -> None:
    assert process.stdout is not None
    assert any(words in line for line in iter(process.stdout.readline, ""))


@pytest.fixture
def field(tmp_path: Path) -> Field:
    return Field(tmp_path / "data")


def test_three_processes_fly_a_mission_and_outlive_each_other(field: Field) -> None:
    """Started in the worst order; then server and router go and come back while the vehicle flies on."""
    with field.vehicle() as vehicle, ExitStack() as first, ExitStack() as second:
        said(vehicle, "waiting for a router")
        server = first.enter_context(field.server())
        router = second.enter_context(field.router())
        with console(server) as screen:
            screen.until_link(pb.LINK_STATE_LIVE)
            reply = screen.http.post("/api/mission/start", json={"name": "docking"}).json()
            assert reply["accepted"], reply
            run = reply["run_id"]
            screen.until_mission(lambda m: m.run_id == run and m.phase == pb.MISSION_PHASE_RUNNING)
        server.kill()
        with field.server() as again, console(again) as screen:
            found = screen.until_mission(lambda m: m.phase == pb.MISSION_PHASE_RUNNING)
            assert found.run_id == run
            router.kill()
            screen.until_link(pb.LINK_STATE_LOST)
            with field.router():
                screen.until_link(pb.LINK_STATE_LIVE)
                later = screen.until_mission(lambda m: m.stamp.cycle > found.stamp.cycle)
                assert later.run_id == run
                assert screen.http.post("/api/mission/abort").json()["accepted"]
                assert vehicle.poll() is None
