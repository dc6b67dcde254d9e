"""A real server on a real bus in this process, and ways to wait for what happens in it."""

import asyncio
import contextlib
import socket
import ssl
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import httpx
import uvicorn

from bumpless_server.console import Console
from bumpless_server.settings import Settings
from bumpless_server.web.app import create_app
from bumpless_server.web.serving import server_config

FAKE = Path(__file__).with_name("fake_vehicle.py")
PATIENCE_S = 20.0  # how long a test waits before it fails; never how long it takes


def until(console: Console, holds: Callable[[], Any], patience_s: float = PATIENCE_S) -> Any:
    """Wait until `holds()` is true, looked at after each message that the server takes in."""
    happened = threading.Event()
    stop = console.state.subscribe(lambda _sample: happened.set())
    try:
        # the server's own status comes at 2 Hz, so this looks at least that often
        for _ in range(10_000):
            if found := holds():
                return found
            if not happened.wait(patience_s):
                break
            happened.clear()
    finally:
        stop()
    raise AssertionError("it did not happen")


@dataclass
class Running:
    """A server in this process: its console, its address, and how to end it."""

    console: Console
    port: int
    http: httpx.Client
    _stop: Callable[[], None] = field(repr=False, default=lambda: None)

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def until(self, holds: Callable[[], Any], patience_s: float = PATIENCE_S) -> Any:
        return until(self.console, holds, patience_s)

    def stop(self) -> None:
        self._stop()


@contextlib.contextmanager
def serving(settings: Settings) -> Iterator[Running]:
    """Serve `settings` with uvicorn on a thread of this process."""
    console = Console(settings)
    console.start()
    listener = socket.create_server(("127.0.0.1", 0))
    config = server_config(create_app(settings, console), console.tally.note, settings, graceful_s=1)
    server = uvicorn.Server(config)
    thread = threading.Thread(
        target=lambda: asyncio.run(server.serve(sockets=[listener])), name="uvicorn", daemon=True
    )
    thread.start()
    port = listener.getsockname()[1]
    scheme, trusted = ("https", ssl.create_default_context()) if settings.tls_cert else ("http", True)
    if isinstance(trusted, ssl.SSLContext):
        trusted.load_verify_locations(settings.tls_cert)
    with httpx.Client(base_url=f"{scheme}://127.0.0.1:{port}", timeout=PATIENCE_S, verify=trusted) as http:
        http.get("/api/health").raise_for_status()

        def stop() -> None:
            server.should_exit = True
            thread.join()
            console.stop()

        running = Running(console, port, http, stop)
        try:
            yield running
        finally:
            stop()
            listener.close()
