"""A bus of the test's own on a free port of loopback, and a live vehicle on it."""

import subprocess
from collections.abc import Iterator

import pytest

from tests.node.listening import Listener, light_node, listening
from tests.ports import free_port


@pytest.fixture
def endpoint() -> str:
    return f"tcp/127.0.0.1:{free_port()}"


@pytest.fixture
def bus(endpoint: str) -> Iterator[Listener]:
    with listening(endpoint) as listener:
        yield listener


@pytest.fixture
def node(bus: Listener, endpoint: str) -> Iterator["subprocess.Popen[str]"]:
    with light_node(endpoint) as process:
        bus.until_alive()
        yield process
