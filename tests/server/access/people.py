"""A server with one account of each role, and clients that have logged in."""

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

import httpx

from bumpless_server.access.accounts import Accounts
from bumpless_server.access.who import Role
from bumpless_server.settings import Settings
from tests.server.serving import PATIENCE_S, Running, serving

PASSWORD = "correct horse battery"
NAMES = {Role.observer: "olga", Role.operator: "otto", Role.engineer: "erna"}


@contextlib.contextmanager
def staffed(settings: Settings) -> Iterator[Running]:
    """Serve `settings` with the accounts of NAMES."""
    accounts = Accounts(settings.data_dir / "access")
    for role in reversed(Role):
        accounts.add(NAMES[role], role.name, PASSWORD)
    with serving(settings) as server:
        yield server


@contextlib.contextmanager
def logged_in(server: Running, role: Role) -> Iterator[httpx.Client]:
    """A client of the role's account, with its cookie."""
    with httpx.Client(base_url=server.url, timeout=PATIENCE_S) as http:
        answer = http.post("/api/login", json={"name": NAMES[role], "password": PASSWORD})
        assert answer.status_code == 204, answer.text
        yield http


Make = Callable[..., Any]
