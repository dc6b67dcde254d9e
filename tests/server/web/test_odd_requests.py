"""No request is answered with a 500, whatever stands in it, and none by a hint of what is inside."""

import errno
import socket
from collections.abc import Iterator

import pytest

from bumpless_server.plan import missions
from bumpless_server.settings import Settings
from tests.server.serving import PATIENCE_S, Running, serving


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """A server without a vehicle."""
    settings = Settings(
        data_dir=tmp_path_factory.mktemp("data"), zenoh_listen=(), manage_node=False, scene="off"
    )
    with serving(settings) as server:
        yield server


def raw_status(running: Running, request: bytes) -> int:
    """The status of an answer to bytes that no client library would send; 0 when the connection is closed."""
    with socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE_S) as raw:
        raw.sendall(request)
        line = raw.makefile("rb").readline()
    return int(line.split()[1]) if line else 0


@pytest.mark.parametrize(
    "head",
    [
        b"GET / HTTP/1.1\r\nHost: [\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: [::1\r\n\r\n",
        b"POST /api/mission/abort HTTP/1.1\r\nHost: 127.0.0.1\r\nOrigin: http://[\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nCookie: bumpless_session=\xe9.\xff; \x80=\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer \xff\r\n\r\n",
        b"GET /api/runs/" + b"a" * 256 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /api/runs/" + b"a" * 256 + b"/log.mcap HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /api/runs/%00/log.mcap HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /api/missions/%ff%fe HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /help/%00 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /%00 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /" + b"a" * 5000 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /api/events?limit=99999999999999999999 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /api/audit?limit=-5 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"PUT /api/parameters HTTP/1.1\r\nHost: 127.0.0.1\r\nIf-Match: \xb2\r\nContent-Length: 2\r\n\r\n{}",
        b"POST /api/missions?name=%00 HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1\r\n\r\nx",
        b"\x00\xff\xfe\r\n\r\n",
        b"GET / HTTP/1.1\r\n\r\n",
    ],
)
def test_odd_bytes_are_a_clients_fault(alone: Running, head: bytes) -> None:
    """Protects: `Host: [` and others answered 500 before any login."""
    assert raw_status(alone, head) < 500


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("PUT", "/api/parameters"),
        ("PUT", "/api/presets/a"),
        ("POST", "/api/mission/start"),
        ("POST", "/api/missions?name=a"),
    ],
)
@pytest.mark.parametrize(
    "body",
    [
        b'{"name": "\\ud800", "operator": "\\udfff", "\\ud800": 1}',
        b'{"name": "docking", "operator": "\\ud800"}',
        b'{"name": "a", "seed": NaN}',
        b'{"hover": {"lambda": 1e999, "q_diagonal": [NaN]}}',
        b"[" * 50_000,
        b'{"parameters": ' * 500 + b"1" + b"}" * 500,
        b"\xff\xfe\x00",
        b"\x00",
        b"1" * 5000,
    ],
)
def test_odd_bodies_are_a_clients_fault(alone: Running, method: str, path: str, body: bytes) -> None:
    """Protects: half a surrogate pair in JSON answered 500."""
    json = {"content-type": "application/json"}
    answer = alone.http.request(method, path, content=body, headers=json)
    assert 400 <= answer.status_code < 500 or answer.status_code == 503, answer.text
    assert answer.json()["detail"]


def test_an_upload_on_a_full_disk_says_so(alone: Running, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: "no room" is an answer, not a traceback; nothing half is kept."""

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(missions, "write_whole", full)
    text = alone.http.get("/api/missions/docking").json()["yaml"]
    answer = alone.http.post("/api/missions?name=mine", content=text)
    assert answer.status_code == 507 and answer.json()["detail"] == "the disk has no room; nothing was kept"


def test_what_nobody_foresaw_tells_nothing_of_it(alone: Running, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: an answer in our one shape, without paths, names or code."""

    def broken(*_: object) -> None:
        raise ArithmeticError("secret /path/of/mine")

    monkeypatch.setattr(alone.console.catalogue, "rows", broken)
    answer = alone.http.get("/api/runs")
    assert answer.status_code == 500
    assert answer.json() == {"detail": "an internal error; the server's log tells more", "problems": []}
