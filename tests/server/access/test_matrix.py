"""The matrix role x route x socket: every cell as declared in the table that code, tests and docs share."""

import re
from pathlib import Path
from typing import Any

import pytest
from fastapi.routing import APIRoute, APIWebSocketRoute

from bumpless_server.access.accounts import Accounts
from bumpless_server.access.lease import Lease
from bumpless_server.access.rights import ROWS, Right, Row, right_of, row_of
from bumpless_server.access.sessions import Sessions
from bumpless_server.access.who import Role, Who
from bumpless_server.scene.cameras import Cameras
from bumpless_server.scene.proxy import Proxy
from bumpless_server.settings import Settings
from bumpless_server.web.app import ROUTERS
from bumpless_server.web.auth import Auth
from bumpless_server.web.guard import Guard
from bumpless_server.web.guesses import Guesses

NOBODY = None
EVERYBODY = (NOBODY, *Role)
OTHER = Who("other", Role.operator, "other", "Other")


class Known(Auth):
    """An Auth to which everybody is whom the test says."""

    asks: Who | None = None

    def who(self, headers: Any, address: str) -> Who | None:
        return self.asks

    @property
    def open(self) -> bool:
        return False


class Door:
    """The real guard in front of an application that lets everything happen."""

    def __init__(self, folder: Path) -> None:
        accounts = Accounts(folder)
        self.auth = Known(Settings(), b"key", accounts, Sessions(folder / "s.json", accounts, 60.0))
        self.lease = Lease(lambda _: None, lambda *_: None)
        self.reached = False
        self.guard = Guard(self._app, self.auth, Guesses(lambda *_: None), self.lease)

    async def _app(self, scope: Any, receive: Any, send: Any) -> None:
        self.reached = True
        if scope["type"] == "http":
            await send({"type": "http.response.start", "status": 204, "headers": []})
            await send({"type": "http.response.body", "body": b""})

    async def ask(self, method: str, path: str, role: Role | None) -> int:
        """The status of a request by somebody of this role; 0 for a socket that opened."""
        self.auth.asks = Who(role.name, role, role.name, role.name, session="s") if role else None
        self.reached, statuses = False, []
        websocket = method == "WS"
        headers = [
            (b"host", b"127.0.0.1:8080"),
            *([(b"origin", b"http://127.0.0.1:8080")] if websocket else []),
        ]
        scope = {"type": "websocket" if websocket else "http", "path": path, "headers": headers}
        scope |= {"query_string": b"", "client": ("127.0.0.1", 1), "scheme": "http"}
        scope |= {} if websocket else {"method": method}

        async def receive() -> dict[str, Any]:
            return {"type": "websocket.connect" if websocket else "http.request"}

        async def send(message: Any) -> None:
            statuses.append(message.get("status", message.get("code", 0)))

        await self.guard(scope, receive, send)
        return statuses[0] if statuses else 0


@pytest.fixture
def door(tmp_path: Path) -> Door:
    return Door(tmp_path)


def filled(path: str) -> str:
    """A path with its names filled in."""
    return re.sub(r"\{\w+\}", "some-name.1", path)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row.method} {row.path}")
async def test_every_cell_is_as_declared(door: Door, row: Row) -> None:
    """Protects: no role reaches more, and none less, than its column says; so does control."""
    path = filled(row.path)
    assert row_of(row.method, path) == row, "an earlier row takes this path"
    for held in (False, True):
        if held:
            door.lease.take(OTHER, "the test holds control")
        for role in EVERYBODY:
            status = await door.ask(row.method, path, role)
            needed = row.right.role
            may = needed is None or (role is not None and role >= needed)
            if may and not (held and row.right.control and role is not None):
                assert door.reached and status in (0, 204), (role, held, status)
            else:
                closed = 1008 if row.method == "WS" else 423 if may else 401 if role is None else 403
                assert not door.reached and status == closed, (role, held, status)


async def test_the_holder_itself_is_not_refused(door: Door) -> None:
    """Protects: control that one holds hinders nobody but the others."""
    door.lease.use(Who("operator", Role.operator, "operator", "operator"))
    assert await door.ask("POST", "/api/mission/start", Role.operator) == 204
    assert await door.ask("POST", "/api/mission/start", Role.engineer) == 423
    for verb in ("pause", "abort"):
        assert await door.ask("POST", f"/api/mission/{verb}", Role.engineer) == 204


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("GET", "/api/nowhere"),
        ("POST", "/api/status"),
        ("PATCH", "/api/missions/x"),
        ("DELETE", "/"),
        ("POST", "/help/"),
        ("GET", "/api/missions/x/"),
        ("GET", "/api//status"),
        ("GET", "/scene/a/b"),
        ("WS", "/api/status"),
        ("WS", "/nowhere"),
        ("TRACE", "/api/health"),
    ],
)
async def test_what_stands_in_no_row_is_closed(door: Door, method: str, path: str) -> None:
    """Protects: a route that somebody forgets to declare, or an odd spelling of one, opens to nobody."""
    assert right_of(method, path) == Right(Role.engineer)
    for role in (NOBODY, Role.observer, Role.operator):
        assert await door.ask(method, path, role) != 204 and not door.reached


async def test_pages_are_for_whom_has_logged_in_and_the_login_is_for_everybody(door: Door) -> None:
    """Protects: the console and its help are no public site; the login page needs nothing that is closed."""
    for path in ("/index.html", "/help/", "/help/trust.html", "/docs"):
        assert await door.ask("GET", path, NOBODY) == 401
        assert await door.ask("GET", path, Role.observer) == 204
    assert await door.ask("GET", "/", NOBODY) == 303
    for path in ("/login", "/assets/login-x.css", "/favicon.svg", "/theme.js"):
        assert await door.ask("GET", path, NOBODY) == 204


def routes() -> set[tuple[str, str]]:
    """(method, path) of everything that the server routes."""
    routers = (*ROUTERS, Proxy(lambda _request: None, Cameras()).router)
    found = set()
    for route in (route for router in routers for route in router.routes):
        if isinstance(route, APIRoute):
            found |= {(method, route.path) for method in route.methods or ()}
        elif isinstance(route, APIWebSocketRoute):
            found.add(("WS", route.path))
    return found


# Not a router's: FastAPI's own, and rows that split one route by what it asks for.
BESIDE = {("GET", "/openapi.json"), ("POST", "/api/mission/pause"), ("POST", "/api/mission/abort")}


def test_the_table_and_the_routes_are_the_same() -> None:
    """Protects: a new route must say who may use it (bumpless_server/access/rights.py); a gone one leaves."""
    declared = {(row.method, row.path) for row in ROWS}
    assert routes() - declared == set(), "say in bumpless_server/access/rights.py who may use these"
    assert declared - routes() - BESIDE == set()
