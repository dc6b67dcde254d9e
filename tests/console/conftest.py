"""The console in a real browser against a server that says what the test tells it."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page, expect

from tests.console import flight
from tests.console.contract_server import ContractServer
from tests.console.replies import default_replies

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
