"""Who gets in: decided on headers alone, so every case can be written down."""

import pytest
from pydantic import SecretStr

from bumpless_server.settings import Settings
from bumpless_server.web.auth import COOKIE, Auth

KEY = b"k" * 32
HERE = {"host": "127.0.0.1:8080"}
OWN = {**HERE, "origin": "http://127.0.0.1:8080"}


@pytest.fixture
def auth() -> Auth:
    return Auth(Settings(), KEY)


def with_cookie(auth: Auth, headers: dict[str, str]) -> dict[str, str]:
    return {**headers, "cookie": f"other=1; {COOKIE}={auth.new_session()}"}


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example",
        "http://127.0.0.1:9999",
        "https://127.0.0.1",
        "null",
        "http://127.0.0.1:8080.evil.example",
        "",
    ],
)
def test_another_origin_changes_nothing_and_opens_no_websocket(auth: Auth, origin: str) -> None:
    """Cookies ignore ports and pages may open any WebSocket: the origin must be ours, to the port."""
    headers = with_cookie(auth, {**HERE, "origin": origin})
    for refusal in (auth.refusal("POST", headers), auth.refusal("GET", headers, websocket=True)):
        assert refusal is not None and refusal[0] == 403


def test_our_own_page_may_do_everything(auth: Auth) -> None:
    """The page we serve, and tools that are no browsers, work."""
    assert auth.refusal("POST", OWN) is None
    assert auth.refusal("DELETE", HERE) is None
    assert auth.refusal("GET", with_cookie(auth, OWN), websocket=True) is None
    assert auth.refusal("GET", HERE, websocket=True) is None


def test_a_browser_without_our_session_gets_no_websocket(auth: Auth) -> None:
    """The page hands out the session; a forged or foreign cookie is none."""
    assert auth.refusal("GET", OWN, websocket=True) == (403, "no session: open the console's page first")
    forged = Auth(Settings(), b"other" * 8).new_session()
    headers = {**OWN, "cookie": f"{COOKIE}={forged}"}
    assert auth.refusal("GET", headers, websocket=True) is not None
    for broken in ("", ".", "a.b", "é.é"):
        assert not auth.is_session(broken)


def test_a_session_outlives_a_restart_but_not_a_new_token(auth: Auth) -> None:
    """A page that is open while the server restarts connects again by itself."""
    cookie = auth.new_session()
    assert Auth(Settings(), KEY).is_session(cookie)
    assert not Auth(Settings(token=SecretStr("correct horse")), KEY).is_session(cookie)


def test_a_foreign_name_for_this_machine_is_refused(auth: Auth) -> None:
    """DNS rebinding: the attacker's name resolves to loopback, and origin and host agree."""
    headers = {"host": "evil.example:8080", "origin": "http://evil.example:8080"}
    assert auth.refusal("POST", headers) == (421, "this server is not reached by that host name")
    assert auth.refusal("GET", {"host": "localhost:8080"}) is None
    assert auth.refusal("GET", {"host": "[::1]:8080"}) is None
    proxied = Auth(Settings(allowed_hosts=("console.example",)), KEY)
    assert proxied.refusal("GET", {"host": "console.example"}) is None


def test_with_a_token_nothing_is_open() -> None:
    """Every request then needs the session or the token itself."""
    auth = Auth(Settings(host="0.0.0.0", token=SecretStr("correct horse")), KEY)
    headers = {"host": "sub.example:8080"}
    assert auth.refusal("GET", headers) == (401, "a token is needed")
    assert auth.refusal("GET", {**headers, "authorization": "Bearer wrong horse"}) is not None
    assert auth.refusal("GET", {**headers, "authorization": "Bearer correct horse"}) is None
    assert auth.refusal("POST", with_cookie(auth, {**headers, "origin": "http://sub.example:8080"})) is None
