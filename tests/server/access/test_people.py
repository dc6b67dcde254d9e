"""Logging in and out, and who may change whom, on a live server."""

from collections.abc import Iterator

import httpx
import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect
from websockets.typing import Origin

from bumpless_server.access.who import Role
from bumpless_server.web.guard import ENDED
from bumpless_server.web.guesses import ALLOWED
from tests.server.access.people import PASSWORD, Make, logged_in, staffed
from tests.server.serving import PATIENCE_S, Running


@pytest.fixture
def server(make_settings: Make) -> Iterator[Running]:
    with staffed(make_settings(manage_node=False)) as running:
        yield running


def test_the_page_asks_to_log_in_and_takes_no_secret_by_address(server: Running) -> None:
    """Protects: a secret in an address ends in histories and logs; what the login page needs is open."""
    page = server.http.get("/", params={"token": PASSWORD})
    assert (page.status_code, page.headers["location"]) == (303, "/login")
    assert server.http.get("/login").status_code == 200
    assert server.http.get("/api/health").status_code == 200
    refused = server.http.get("/api/status")
    assert refused.status_code == 401 and refused.json()["detail"] == "log in first"
    assert refused.headers["www-authenticate"] == "Bearer"


def test_in_and_out(server: Running) -> None:
    """Protects: a session begins with the right password alone and is over at once after logging out."""
    with logged_in(server, Role.operator) as http:
        told = http.get("/api/me").json()
        assert (told["name"], told["role"], told["accounts"]) == ("otto", "operator", True)
        cookie = dict(http.cookies)
        assert http.post("/api/logout").status_code == 204
        assert httpx.get(f"{server.url}/api/me", cookies=cookie).status_code == 401
    entries = [(one["verb"], one["author"]) for one in server.console.audit.entries()]
    assert entries == [("log_in", "otto"), ("log_out", "otto"), ("turned_away", "")]


def test_wrong_guesses_are_few_counted_and_slowed(server: Running) -> None:
    """Protects: passwords and tokens can't be guessed without limit and without a trace."""
    for number in range(ALLOWED):
        if number % 2:
            wrong = {"authorization": f"Bearer bmp_{number}"}
            assert server.http.get("/api/status", headers=wrong).status_code == 401
        else:
            guess = {"name": "erna", "password": f"wrong {number}"}
            assert server.http.post("/api/login", json=guess).status_code == 401
    right = server.http.post("/api/login", json={"name": "erna", "password": PASSWORD})
    assert right.status_code == 429 and "try again in" in right.json()["detail"]
    wrong = {"authorization": "Bearer bmp_x"}
    assert server.http.get("/api/status", headers=wrong).status_code == 429
    assert server.http.get("/api/health").status_code == 200
    assert server.console.tally.of("refused_login") == ALLOWED


def test_who_is_logged_out_by_an_engineer_hears_nothing_more(server: Running) -> None:
    """Protects: a revoked session's stream does not run on; its control is free at once."""
    with logged_in(server, Role.operator) as otto, logged_in(server, Role.engineer) as erna:
        cookie = {"cookie": "; ".join(f"{name}={value}" for name, value in otto.cookies.items())}
        url = f"ws://127.0.0.1:{server.port}/api/stream"
        with connect(url, origin=Origin(server.url), additional_headers=cookie) as stream:
            assert otto.post("/api/control/ask", json={}).json()["holder_name"] == "otto"
            sessions = {one["user"]: one["id"] for one in erna.get("/api/sessions").json()}
            assert erna.delete(f"/api/sessions/{sessions['otto']}").status_code == 204
            with pytest.raises(ConnectionClosed) as ended:
                for _ in range(1000):
                    stream.recv(PATIENCE_S)
            assert ended.value.rcvd is not None and ended.value.rcvd.code == ENDED
        assert otto.get("/api/me").status_code == 401
        assert erna.get("/api/control").json()["holder"] == ""


def test_engineers_make_change_and_remove_accounts(server: Running) -> None:
    """Protects: a change ends the account's sessions, and each is written down without a password."""
    with logged_in(server, Role.engineer) as erna:
        new = {"name": "nina", "role": "observer", "password": PASSWORD}
        assert erna.post("/api/users", json=new).json()["role"] == "observer"
        assert erna.post("/api/users", json=new).status_code == 409
        assert erna.post("/api/users", json={**new, "name": "No"}).status_code == 422
        assert erna.post("/api/users", json={**new, "name": "x", "password": "short"}).status_code == 422
        with httpx.Client(base_url=server.url, timeout=PATIENCE_S) as nina:
            assert nina.post("/api/login", json={"name": "nina", "password": PASSWORD}).status_code == 204
            assert erna.put("/api/users/nina", json={"role": "operator"}).json()["role"] == "operator"
            assert nina.get("/api/me").status_code == 401
        assert erna.delete("/api/users/nina").status_code == 204
        assert erna.delete("/api/users/nina").status_code == 404
        assert erna.delete("/api/users/erna").status_code == 409
        verbs = [one["verb"] for one in erna.get("/api/audit").json()]
        assert verbs[:4] == ["remove_user", "turned_away", "change_user", "log_in"]
        assert PASSWORD not in erna.get("/api/audit.jsonl").text


def test_ones_own_password(server: Running) -> None:
    """Protects: only who knows the old one sets a new one; other sessions end, this one goes on."""
    with logged_in(server, Role.observer) as olga, logged_in(server, Role.observer) as other:
        body = {"old": "wrong wrong wrong", "new": PASSWORD + "!"}
        assert olga.put("/api/me/password", json=body).status_code == 401
        assert olga.put("/api/me/password", json={**body, "old": PASSWORD}).status_code == 204
        assert olga.get("/api/me").status_code == 200
        assert other.get("/api/me").status_code == 401


def test_a_token_works_until_it_is_revoked(server: Running) -> None:
    """Protects: scripts need no password, and what they hold can be taken away by name."""
    with logged_in(server, Role.engineer) as erna:
        made = erna.post("/api/tokens", json={"name": "nightly", "role": "operator"}).json()
        bearer = {"authorization": f"Bearer {made['secret']}"}
        told = server.http.get("/api/me", headers=bearer).json()
        assert (told["shown"], told["role"]) == ("nightly (erna)", "operator")
        assert server.http.get("/api/users", headers=bearer).status_code == 403
        (listed,) = erna.get("/api/tokens").json()
        assert "secret" not in listed
        assert erna.delete(f"/api/tokens/{listed['id']}").status_code == 204
    assert server.http.get("/api/me", headers=bearer).status_code == 401


def test_the_first_account_shuts_an_open_console(make_settings: Make) -> None:
    """Protects: on loopback nobody logs in, until somebody wants that: then everybody does."""
    from tests.server.serving import serving

    with serving(make_settings(manage_node=False)) as server:
        server.http.get("/")
        assert server.http.get("/api/me").json()["accounts"] is False
        assert server.http.post("/api/login", json={"name": "a", "password": "b"}).status_code == 409
        made = {"name": "ada", "role": "engineer", "password": PASSWORD}
        assert server.http.post("/api/users", json={**made, "role": "operator"}).status_code == 409
        assert server.http.post("/api/users", json=made).status_code == 201
        assert server.http.get("/api/me").status_code == 401


def test_commands_are_signed_by_the_account_whatever_the_request_says(server: Running) -> None:
    """Protects: nobody gives a command in somebody else's name."""
    with logged_in(server, Role.operator) as otto:
        assert otto.post("/api/mission/pause", headers={"x-operator": "erna"}).status_code == 503
        assert otto.get("/api/audit").json()[0]["author"] == "otto"
