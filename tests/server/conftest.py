"""Settings of servers for tests, with a real child process that speaks the contract."""

import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from bumpless_server.settings import Settings
from tests.ports import free_port
from tests.server.serving import FAKE, Running, serving


@pytest.fixture
def make_settings(tmp_path: Path) -> Callable[..., Settings]:
    """Settings of a server of this test's own: own folder, own bus port, fake vehicle, no scene."""
    bus = f"tcp/127.0.0.1:{free_port()}"

    def make(*fake_options: str, **more: Any) -> Settings:
        return Settings(
            **{
                "data_dir": tmp_path / "data",
                "zenoh_listen": (bus,),
                "node_command": (sys.executable, str(FAKE), "--connect", bus, *fake_options),
                "scene": "off",
                **more,
            }
        )

    return make


@pytest.fixture(autouse=True)
def importable(monkeypatch: pytest.MonkeyPatch) -> None:
    """Child processes find this source tree, installed or not."""
    root = str(Path(__file__).parents[2])
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(filter(None, [root, os.environ.get("PYTHONPATH")])))


@pytest.fixture
def running(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server with a fake vehicle that is alive."""
    with serving(make_settings()) as server:
        server.until(lambda: server.console.state.latest("health"))  # the last of what it says of itself
        yield server
