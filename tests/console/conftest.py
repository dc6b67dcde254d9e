"""The console in a real browser against a server that says what the test tells it."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from bumpless_server.settings import Settings
from tests.console import flight
from tests.console.contract_server import ContractServer
from tests.console.replies import default_replies
from tests.ports import free_port
from tests.server.serving import Running, serving

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_MS = 30_000  # a busy machine is no failure
expect.set_options(timeout=PATIENCE_MS)


@pytest.fixture
def server() -> Iterator[ContractServer]:
    """A server in use whose vehicle waits for a mission."""
    running = ContractServer()
    default_replies(running)
    running.keep_saying(flight.hello())
    yield running
    running.stop()


@pytest.fixture
def running(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Running]:
    """Server, node and foresight as `bumpless serve` starts them, without the scene."""
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")])))
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    with serving(Settings(data_dir=tmp_path / "data", zenoh_listen=bus, scene="off")) as server:
        yield server


@pytest.fixture
def console(page: Page, server: ContractServer) -> Iterator[Page]:
    """The console's page; fails the test when the page logs an error of its own."""
    errors: list[str] = []

    def note(message: object) -> None:
        kind, text = getattr(message, "type", ""), str(getattr(message, "text", ""))
        # Chromium itself logs refused requests and lost sockets; the tests cause them on purpose.
        if kind == "error" and "Failed to load resource" not in text and "WebSocket connection" not in text:
            errors.append(text)

    page.on("console", note)
    page.goto(server.url)
    expect(page.get_by_label("Link: Live")).to_be_visible()
    yield page
    assert not errors, f"errors in the page's console: {errors}"


def show(page: Page, view: str) -> None:
    """Go to a view by its tab."""
    page.get_by_role("navigation").get_by_role("link", name=view).click()
