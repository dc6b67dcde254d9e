"""A browser that holds control is closed in flight: the vehicle hears of it and does what it declares."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from websockets.sync.client import connect

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.settings import Settings
from tests.node.test_heartbeat import with_failsafe
from tests.server.serving import Running, serving

Make = Callable[..., Settings]


@contextmanager
def started_by_a_browser(make_settings: Make, vehicle: str) -> Iterator[Running]:
    """A mission that a browser began, which is closed by now; the server goes on."""
    (bus,) = make_settings().zenoh_listen
    command = (sys.executable, "-m", "tests.node.light", bus, "realtime", "", vehicle)
    with serving(make_settings(node_command=command)) as running:
        running.until(lambda: running.console.state.latest("parameters") and running.console.speaker.session)
        cookie = running.http.get("/").headers["set-cookie"].split(";")[0]
        headers = {"cookie": cookie}
        with connect(
            f"ws://127.0.0.1:{running.port}/api/stream",
            origin=running.url,  # type: ignore[arg-type]
            additional_headers=headers,
            max_size=None,
        ):
            running.until(running.console.lease.present)
            reply = running.http.post("/api/mission/start", json={"name": "docking"}, headers=headers)
            assert reply.status_code == 200, reply.text
            running.until(lambda: phase(running) == pb.MISSION_PHASE_RUNNING)
        running.until(lambda: not running.console.lease.present())
        yield running


def phase(running: Running) -> int:
    status = running.console.state.latest("mission")
    return status.phase if isinstance(status, pb.MissionStatus) else 0


def causes(running: Running) -> list[str]:
    events = running.http.get("/api/events").json()
    return [event["details"]["cause"] for event in events if event["code"] == "failsafe"]


def test_a_page_that_is_closed_in_flight_is_told_to_the_vehicle(make_settings: Make, tmp_path: Path) -> None:
    """Protects: the server's own heartbeat hid that nobody was in control any more."""
    file = with_failsafe(tmp_path, "hold", "holder_lost", limit_s=3.0)
    with started_by_a_browser(make_settings, str(file)) as running:
        running.until(lambda: phase(running) == pb.MISSION_PHASE_PAUSED)
        assert running.until(lambda: causes(running)) == ["holder_lost"]  # the event may come a moment later
        told = {one["cause"]: one for one in running.http.get("/api/vehicle").json()["failsafe"]}
        assert (told["holder_lost"]["does"], told["holder_lost"]["limit"]) == ("holds station", 3.0)


def test_without_a_declaration_a_page_may_be_closed(make_settings: Make) -> None:
    """Protects: a lone operator who closes the page finds the mission flown on, as the sheet had said."""
    with started_by_a_browser(make_settings, "") as running:
        told = {one["cause"]: one for one in running.http.get("/api/vehicle").json()["failsafe"]}
        assert told["holder_lost"]["does"] == "goes on"
        running.until(lambda: "control_lost" in str(running.http.get("/api/events").json()))
        assert phase(running) == pb.MISSION_PHASE_RUNNING and causes(running) == []
