"""Who takes a place and asks for nothing loses it: half requests, trickled bodies, masses of connections."""

import contextlib
import socket
from collections.abc import Callable, Iterator

import pytest
from websockets.exceptions import ConnectionClosedError
from websockets.sync.client import connect

from bumpless_server.settings import Settings
from bumpless_server.web import connection
from bumpless_server.web.connection import bounded_protocol
from bumpless_server.web.serving import WS_MAX_BYTES, server_config
from tests.server.serving import PATIENCE_S, Running, serving

HALF_HEAD = b"GET /api/health HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Slow: "
HALF_BODY = b"POST /api/missions?name=a HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100\r\n\r\nhalf"


@pytest.fixture
def alone(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle."""
    with serving(make_settings(manage_node=False)) as server:
        yield server


def opened(running: Running, data: bytes) -> socket.socket:
    """A connection that has said this much."""
    raw = socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE_S)
    raw.sendall(data)
    return raw


def test_unfinished_requests_lock_nobody_out(alone: Running, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: 1,100 half requests took every place; now the oldest of them makes room."""
    monkeypatch.setattr(connection, "MOST", 20)
    with contextlib.ExitStack() as stack:
        half = [stack.enter_context(opened(alone, HALF_HEAD)) for _ in range(60)]
        alone.until(lambda: alone.console.tally.of("slow_request") >= 40)
        assert alone.http.get("/api/health").status_code == 200
        closed = [raw for raw in half if _is_closed(raw)]
        assert len(closed) >= 40


def _is_closed(raw: socket.socket) -> bool:
    raw.setblocking(False)
    try:
        return raw.recv(1) == b""
    except BlockingIOError:
        return False
    except OSError:
        return True


@pytest.mark.parametrize("half", [HALF_HEAD, HALF_BODY], ids=["head", "body"])
def test_a_request_that_does_not_come_whole_is_given_up(
    alone: Running, monkeypatch: pytest.MonkeyPatch, half: bytes
) -> None:
    """Protects: a place must not be held for ever by a byte now and then."""
    monkeypatch.setattr(connection, "HEAD_S", 0.2)
    monkeypatch.setattr(connection, "BODY_S", 0.2)
    with opened(alone, half) as raw:
        with contextlib.suppress(ConnectionResetError):
            while raw.recv(1000):
                pass
    assert alone.console.tally.of("slow_request") == 1
    assert alone.http.get("/api/health").status_code == 200


def test_a_browser_cannot_fill_the_memory_by_a_socket(alone: Running) -> None:
    """Protects: ten clients held 517 MB by messages of 64 MB that nobody reads."""
    with connect(f"ws://127.0.0.1:{alone.port}/api/stream", max_size=None) as browser:
        browser.send(b"x" * (WS_MAX_BYTES + 1))
        with pytest.raises(ConnectionClosedError) as closed:
            while browser.recv(timeout=PATIENCE_S):
                pass
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1009


class _Transport:
    """As much of a transport as a connection looks at when it is made."""

    def __init__(self, plain: socket.socket) -> None:
        self._plain = plain

    def get_extra_info(self, name: str) -> object:
        return self._plain if name == "socket" else None

    def is_closing(self) -> bool:
        return True


async def test_answers_are_sent_at_once(alone: Running) -> None:
    """Protects: without TCP_NODELAY each answer on a kept connection waited 44 ms for an acknowledgement."""
    from uvicorn.server import ServerState

    from bumpless_server.web.app import create_app

    app = create_app(alone.console.settings, alone.console)
    config = server_config(app, alone.console.tally.note, alone.console.settings)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        with socket.create_connection(listener.getsockname()), listener.accept()[0] as plain:
            made = bounded_protocol(alone.console.tally.note)(config, ServerState(), {})
            made.connection_made(_Transport(plain))  # type: ignore[arg-type]
            assert plain.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)
