"""A server in this process with a vehicle node in another, for trials; see `tests.server.serving`."""

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.settings import Settings
from tests.ports import free_port
from tests.server.serving import Running, serving

ROOT = Path(__file__).parents[2]
PATIENCE_S = 120.0


def settings(folder: Path, bus: str = "", **more: Any) -> Settings:
    """A server with a folder and a bus port of its own, without a scene."""
    bus = bus or f"tcp/127.0.0.1:{free_port()}"
    return Settings(**{"data_dir": folder / "data", "zenoh_listen": (bus,), "scene": "off", **more})


def light(endpoint: str, *more: str) -> tuple[str, ...]:
    """Command of a node with nothing to compile."""
    return (sys.executable, "-m", "tests.node.light", endpoint, *more)


class Seen:
    """What the server said since, and when: for waiting on links, events and cycles."""

    def __init__(self, running: Running) -> None:
        self.running = running
        self.links: list[tuple[float, int]] = []
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._look, daemon=True)
        self._thread.start()

    def _look(self) -> None:
        while not self._end.wait(0.01):
            link = self.running.console.state.link
            if not self.links or self.links[-1][1] != link:
                self.links.append((time.monotonic(), link))

    def end(self) -> None:
        self._end.set()
        self._thread.join()

    def until_link(self, *states: int, since: float = 0.0) -> float:
        """Seconds from `since` until the link was first in one of these states."""
        until = time.monotonic() + PATIENCE_S
        while time.monotonic() < until:
            for at, link in list(self.links):
                if at >= since and link in states:
                    return at - since
            time.sleep(0.005)
        raise AssertionError(f"the link never was in {states}")


@contextmanager
def seeing(of: Settings) -> Iterator[tuple[Running, Seen]]:
    """A server with its vehicle live."""
    with serving(of) as running:
        seen = Seen(running)
        try:
            running.until(lambda: running.console.state.link == pb.LINK_STATE_LIVE, PATIENCE_S)
            running.until(lambda: running.console.state.latest("parameters"), PATIENCE_S)
            yield running, seen
        finally:
            seen.end()


def events(running: Running, code: str) -> list[dict[str, Any]]:
    """All events of a code that the server still knows."""
    return [one for one in running.http.get("/api/events?limit=500").json() if one["code"] == code]


def start(running: Running, name: str = "docking") -> str:
    """Start a shipped mission; its run."""
    answer = running.http.post("/api/mission/start", json={"name": name, "despite_findings": True}).json()
    assert answer["accepted"], answer
    return answer["run_id"]


def await_true(true: Callable[[], Any], what: str) -> Any:
    """Look until it is so."""
    until = time.monotonic() + PATIENCE_S
    while time.monotonic() < until:
        if found := true():
            return found
        time.sleep(0.02)
    raise AssertionError(f"it did not come: {what}")
