"""The same rules on a live server: over real HTTP and real WebSockets, for every route."""

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin

from tests.server.serving import Running

EVIL = {"origin": "http://evil.example"}


def test_a_foreign_page_can_command_nothing(running: Running) -> None:
    """Start, parameters and uploads sent by another site's page never reach the vehicle."""
    for method, path in (
        ("POST", "/api/mission/start"),
        ("PUT", "/api/parameters"),
        ("POST", "/api/missions?name=a"),
        ("DELETE", "/api/runs/x"),
    ):
        answer = running.http.request(method, path, headers=EVIL, content=b"{}")
        assert answer.status_code == 403
        assert answer.json()["detail"] == "requests from another origin are refused"
    assert running.http.get("/api/status", headers={"host": "evil.example"}).status_code == 421


@pytest.mark.parametrize("path", ["/api/stream", "/scene", "/nowhere"])
def test_a_foreign_page_can_listen_to_nothing(running: Running, path: str) -> None:
    """WebSockets know no same-origin rule of their own."""
    with (
        pytest.raises(InvalidStatus) as caught,
        connect(f"ws://127.0.0.1:{running.port}{path}", origin=Origin("http://evil.example")),
    ):
        pass
    assert caught.value.response.status_code == 403


def test_the_page_hands_out_the_session_that_its_stream_needs(running: Running) -> None:
    """Open the page, then the stream: what every browser does."""
    page = running.http.get("/")
    cookie = page.headers["set-cookie"]
    assert "HttpOnly" in cookie and "SameSite=Strict" in cookie
    assert page.headers["x-content-type-options"] == "nosniff"
    assert "set-cookie" not in running.http.get("/").headers
    headers = {"cookie": cookie.split(";")[0]}
    url = f"ws://127.0.0.1:{running.port}/api/stream"
    with connect(url, origin=Origin(running.url), additional_headers=headers) as socket:
        assert socket.recv()
    with pytest.raises(InvalidStatus), connect(url, origin=Origin(running.url)):
        pass
