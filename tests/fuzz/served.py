"""The server that is fuzzed: with accounts, a vehicle that answers, and one recorded run."""

import contextlib
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bumpless_server.access.accounts import Accounts
from bumpless_server.access.who import Role
from bumpless_server.settings import Settings
from tests.ports import free_port
from tests.server.serving import FAKE, Running, serving

PASSWORD = "not a secret: a test"


@dataclass
class Fuzzed:
    """A running server, what it says of itself, and a token for each role."""

    running: Running
    document: dict[str, Any]
    tokens: dict[Role, str]
    known: dict[str, list[str]]


@contextlib.contextmanager
def fuzzed(folder: Path) -> Iterator[Fuzzed]:
    """Serve from `folder` until the block ends."""
    bus = f"tcp/127.0.0.1:{free_port()}"
    settings = Settings(
        data_dir=folder,
        zenoh_listen=(bus,),
        scene="off",
        node_command=(sys.executable, str(FAKE), "--connect", bus, "--mission-s", "0.5"),
    )
    accounts = Accounts(folder / "access")
    accounts.add("fuzz", "engineer", PASSWORD)
    tokens = {role: accounts.new_token("fuzz", f"fuzz {role.name}", role.name)[1] for role in Role}
    with serving(settings) as running:
        running.until(lambda: running.console.state.latest("health"))
        http = running.http
        http.headers["authorization"] = f"Bearer {tokens[Role.engineer]}"
        http.post("/api/mission/start", json={"name": "docking"}).raise_for_status()
        running.until(lambda: running.console.catalogue.rows())
        http.post("/api/control/release").raise_for_status()
        (run,) = (row.summary.id for row in running.console.catalogue.rows())
        known = {
            "name": ["docking", "docking_current", "fuzz", "..", "%2e%2e%2fx"],
            "run": [run, "../x", "x" * 200],
            "vehicle": ["ts100", "remus100", ".."],
            "kind": ["mission", "vehicle", "x"],
            "verb": ["pause", "resume", "surface", "abort", "shutdown"],
        }
        yield Fuzzed(running, http.get("/openapi.json").json(), tokens, known)
