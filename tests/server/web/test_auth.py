"""Who gets in: decided on headers alone, so every case can be written down."""

from pathlib import Path
from typing import Any

import pytest

from bumpless_server.access import passwords
from bumpless_server.access.accounts import Accounts
from bumpless_server.access.rights import Right
from bumpless_server.access.sessions import Sessions
from bumpless_server.access.who import Role
from bumpless_server.settings import Settings
from bumpless_server.web.auth import COOKIE, Auth

KEY = b"k" * 32
HERE = {"host": "127.0.0.1:8080"}
OWN = {**HERE, "origin": "http://127.0.0.1:8080"}
SEE, ACT = Right(Role.observer), Right(Role.operator)
PASSWORD = "correct horse battery"


@pytest.fixture(autouse=True)
def cheap(monkeypatch: pytest.MonkeyPatch) -> None:
    """Hashes that take no time."""
    monkeypatch.setattr(passwords, "hashed", lambda password: password[::-1])
    monkeypatch.setattr(passwords, "matches", lambda password, kept: password[::-1] == kept)


@pytest.fixture
def accounts(tmp_path: Path) -> Accounts:
    return Accounts(tmp_path)


def make(accounts: Accounts, key: bytes = KEY, **settings: Any) -> Auth:
    return Auth(Settings(**settings), key, accounts, Sessions(Path("/nowhere/x"), accounts, 3600.0))


@pytest.fixture
def auth(accounts: Accounts) -> Auth:
    return make(accounts)


def verdict(
    auth: Auth, method: str, headers: dict[str, str], right: Right = ACT, websocket: bool = False
) -> tuple[int, str] | None:
    """As the guard asks."""
    who = auth.who(headers, "127.0.0.1")
    return auth.foreign(method, headers, websocket) or auth.refusal(who, right, headers, websocket)


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
    for refusal in (verdict(auth, "POST", headers), verdict(auth, "GET", headers, websocket=True)):
        assert refusal is not None and refusal[0] == 403


def test_our_own_page_may_do_everything(auth: Auth) -> None:
    """The page we serve, and tools that are no browsers, work."""
    assert verdict(auth, "POST", OWN) is None
    assert verdict(auth, "DELETE", HERE) is None
    assert verdict(auth, "GET", with_cookie(auth, OWN), websocket=True) is None
    assert verdict(auth, "GET", HERE, websocket=True) is None


def test_a_browser_without_our_session_gets_no_websocket(auth: Auth, accounts: Accounts) -> None:
    """The page hands out the session; a forged or foreign cookie is none."""
    no_session = (403, "no session: open the console's page first")
    assert verdict(auth, "GET", OWN, websocket=True) == no_session
    forged = make(accounts, b"other" * 8).new_session()
    headers = {**OWN, "cookie": f"{COOKIE}={forged}"}
    assert verdict(auth, "GET", headers, websocket=True) == no_session
    for broken in ("", ".", "a.b", "é.é"):
        assert not auth.is_session(broken)


def test_a_session_outlives_a_restart_but_not_the_first_account(auth: Auth, accounts: Accounts) -> None:
    """A page that is open while the server restarts connects again by itself; an account closes the door."""
    headers = with_cookie(auth, HERE)
    assert make(accounts).who(headers, "127.0.0.1") is not None
    accounts.add("ada", "engineer", PASSWORD)
    assert auth.who(headers, "127.0.0.1") is None and not auth.open
    assert verdict(auth, "GET", headers, SEE) == (401, "log in first")


def test_a_foreign_name_for_this_machine_is_refused(auth: Auth, accounts: Accounts) -> None:
    """DNS rebinding: the attacker's name resolves to loopback, and origin and host agree."""
    headers = {"host": "evil.example:8080", "origin": "http://evil.example:8080"}
    assert verdict(auth, "POST", headers) == (421, "this server is not reached by that host name")
    assert verdict(auth, "GET", {"host": "localhost:8080"}) is None
    assert verdict(auth, "GET", {"host": "[::1]:8080"}) is None
    proxied = make(accounts, allowed_hosts=("console.example",))
    assert proxied.foreign("GET", {"host": "console.example"}) is None


def test_beyond_loopback_nothing_is_open(accounts: Accounts) -> None:
    """Every request then needs a session or a token in force, also before there is any account."""
    auth = make(accounts, host="0.0.0.0", plain_http=True)
    headers = {"host": "sub.example:8080"}
    assert not auth.open
    assert verdict(auth, "GET", with_cookie(auth, headers), SEE) == (401, "log in first")
    accounts.add("ada", "engineer", PASSWORD)
    _, secret = accounts.new_token("ada", "nightly", "operator")
    assert verdict(auth, "POST", {**headers, "authorization": f"Bearer {secret}"}) is None
    assert verdict(auth, "POST", {**headers, "authorization": "Bearer bmp_wrong"}) == (401, "log in first")
    assert auth.wrong_bearer({**headers, "authorization": "Bearer bmp_wrong"})


def test_a_role_may_what_lower_ones_may_and_no_more(auth: Auth, accounts: Accounts) -> None:
    """Protects: an observer commands nothing, and is told which role it takes."""
    accounts.add("ada", "engineer", PASSWORD)
    _, secret = accounts.new_token("ada", "wall screen", "observer")
    headers = {**HERE, "authorization": f"Bearer {secret}"}
    assert verdict(auth, "GET", headers, SEE) is None
    refused = verdict(auth, "POST", headers, ACT)
    assert refused == (403, "this needs the role operator; wall screen (ada) is observer")


def test_a_cookie_is_for_our_page_alone(auth: Auth) -> None:
    """Protects: scripts can't read it, other sites can't send it, and TLS keeps it to TLS."""
    from bumpless_server.web.auth import new_cookie

    cookie = new_cookie("value", secure=True)
    for part in ("HttpOnly", "SameSite=Strict", "Secure", "Path=/"):
        assert part in cookie
    assert "Secure" not in new_cookie("value", secure=False)
    assert "Max-Age=0" in new_cookie("", secure=False)
