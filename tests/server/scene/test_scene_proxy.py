"""Only our own page, with our session, reaches the scene; nothing else reaches viser's port."""

import time
from collections.abc import Iterator

import httpx
import pytest
import viser
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Subprotocol

from bumpless_server.scene.page import POLICY, page_html
from tests.server.scene.harness import Served, serve

PROTOCOL = Subprotocol(f"viser-v{viser.__version__}")


@pytest.fixture(scope="module")
def served() -> Iterator[Served]:
    with serve() as running:
        yield running


def _session(served: Served) -> str:
    answer = httpx.get(served.origin)
    return "; ".join(f"{name}={value}" for name, value in answer.cookies.items())


def _socket(served: Served, **headers: str):
    address = served.origin.replace("http", "ws") + "/scene"
    return connect(address, subprotocols=[PROTOCOL], additional_headers=headers, proxy=None)


def test_the_console_sees_the_scene(served: Served) -> None:
    """Own origin and session: viser answers through the proxy, in its own protocol."""
    with _socket(served, Cookie=_session(served), Origin=served.origin) as ws:
        assert ws.subprotocol == PROTOCOL
        assert len(ws.recv(timeout=10)) > 100


@pytest.mark.parametrize("origin", ["http://evil.example", "http://127.0.0.1:1", "null"])
def test_a_foreign_page_is_refused(served: Served, origin: str) -> None:
    """A page elsewhere in the same browser has our cookie but not our origin."""
    with pytest.raises((InvalidStatus, ConnectionClosed)):
        with _socket(served, Cookie=_session(served), Origin=origin) as ws:
            ws.recv(timeout=10)


@pytest.mark.parametrize("with_origin", [True, False])
def test_no_session_is_refused(served: Served, with_origin: bool) -> None:
    """Neither our own page without a cookie nor a bare client gets in."""
    headers = {"Origin": served.origin} if with_origin else {}
    with pytest.raises((InvalidStatus, ConnectionClosed)):
        with _socket(served, **headers) as ws:
            ws.recv(timeout=10)
    assert httpx.get(f"{served.origin}/scene/").status_code == 401


def test_visers_own_port_is_shut(served: Served) -> None:
    """Its page and its socket answer 403 to whoever does not know the secret."""
    port = served.scene.viser.get_port()
    assert served.scene.viser.get_host() == "127.0.0.1"
    assert httpx.get(f"http://127.0.0.1:{port}/").status_code == 403
    with pytest.raises(InvalidStatus) as refused:
        connect(f"ws://127.0.0.1:{port}", subprotocols=[PROTOCOL], proxy=None)
    assert refused.value.response.status_code == 403


def test_nobody_can_share_the_scene_with_a_foreign_host(served: Served) -> None:
    """A client may ask viser for a public tunnel; the server never opens one."""
    assert served.scene.viser.request_share_url() is None


def test_the_page_carries_its_policy(served: Served) -> None:
    """No foreign script, style, font or connection; no frame but the console's."""
    answer = httpx.get(f"{served.origin}/scene/", headers={"Cookie": _session(served)})
    assert answer.status_code == 200
    assert answer.headers["content-security-policy"] == POLICY
    assert "unsafe-eval'" not in POLICY.replace("wasm-unsafe-eval'", "")
    assert "hasFocus" in answer.text and "<title>Bumpless scene</title>" in answer.text


def test_camera_presets_need_our_own_page(served: Served) -> None:
    """A foreign page cannot move the operator's camera; an unknown view is named as such."""
    cookie, url = _session(served), f"{served.origin}/api/scene/camera"
    foreign = httpx.post(
        url, json={"view": "top"}, headers={"Cookie": cookie, "Origin": "http://evil.example"}
    )
    assert foreign.status_code == 403
    own = {"Cookie": cookie, "Origin": served.origin}
    assert httpx.post(url, json={"view": "top"}, headers=own).json() == {"view": "top", "viewers": 0}
    assert httpx.post(url, json={"view": "sideways"}, headers=own).status_code == 422


def test_page_is_built_once() -> None:
    """The page is over a megabyte: it is read and put together a single time."""
    assert page_html() is page_html()


def test_with_nobody_watching_nothing_is_drawn(served: Served) -> None:
    """The update loop waits: no picture is drawn without a browser."""
    from bumpless.contract import bumpless_pb2 as pb

    before = served.scene.live.pictures
    for cycle in range(50):
        stamp = pb.Stamp(time_ns=time.time_ns(), cycle=cycle)
        served.tell("navigation", pb.Navigation(stamp=stamp))
    assert served.scene.live.pictures == before
