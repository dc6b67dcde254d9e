"""The vehicle node lives: started, adopted, started again when it dies, and gone when the server goes."""

import os
import signal
import sys
from collections.abc import Callable
from typing import Any

import psutil

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving


def events(running: Running) -> list[str]:
    return [event["code"] for event in running.http.get("/api/events").json()]


def live(running: Running) -> bool:
    return running.console.state.link == pb.LINK_STATE_LIVE


def test_a_killed_node_is_started_again_and_the_operator_is_told(running: Running) -> None:
    """kill -9: LOST, a new process, the count, an alarm, and the new node's words only."""
    first = running.console.supervisor.pid
    session = running.http.get("/api/status").json()["vehicle"]["session_id"]
    os.kill(first or 0, signal.SIGKILL)
    running.until(lambda: running.console.state.link == pb.LINK_STATE_LOST)
    running.until(lambda: live(running))

    def another() -> Any:
        status = running.http.get("/api/status").json()
        return status if status["vehicle"] and status["vehicle"]["session_id"] != session else None

    status = running.until(another)
    assert status["node_restarts"] == 1
    assert running.console.supervisor.pid not in (None, first)
    told = events(running)
    assert {"node_died", "link_lost"} <= set(told) and told.count("node_started") == 2
    died = next(e for e in running.http.get("/api/events").json() if e["code"] == "node_died")
    assert died["severity"] == "SEVERITY_ALARM" and "SIGKILL" in died["text"]
    assert running.http.post("/api/mission/start", json={"name": "docking"}).json()["accepted"]


def test_a_frozen_node_is_lost_within_its_lease_and_comes_back(running: Running) -> None:
    """SIGSTOP: nothing of it looks live; when it goes on, so does everything."""
    pid = running.console.supervisor.pid or 0
    os.kill(pid, signal.SIGSTOP)
    try:
        running.until(lambda: running.console.state.link == pb.LINK_STATE_LOST)
    finally:
        os.kill(pid, signal.SIGCONT)
    running.until(lambda: live(running))
    assert running.console.supervisor.pid == pid
    assert running.console.supervisor.restarts == 0


def test_stopping_the_server_leaves_no_process(make_settings: Callable[..., Settings]) -> None:
    """The node it started, and nothing else, ends with it."""
    with serving(make_settings()) as running:
        running.until(lambda: live(running))
        process = psutil.Process(running.console.supervisor.pid)
    assert not process.is_running()
    assert not running.console.data.node_record.exists()


def test_a_node_that_dies_at_once_is_tried_again_with_patience(
    make_settings: Callable[..., Settings],
) -> None:
    """A broken node does not make the server spin, and the operator sees why nothing happens."""
    with serving(make_settings("--exit", "7")) as running:
        running.until(lambda: "node_died" in events(running))
        died = next(e for e in running.http.get("/api/events").json() if e["code"] == "node_died")
        assert "exit code 7" in died["text"] and "started again in 1 s" in died["text"]
        running.until(lambda: running.console.supervisor.restarts >= 2)


def test_a_node_that_cannot_be_started_is_told(make_settings: Callable[..., Settings]) -> None:
    """A wrong command is an event, not a crash."""
    with serving(make_settings(node_command=("/no/such/program",))) as running:
        running.until(lambda: "node_not_started" in events(running))
        assert running.http.get("/api/health").status_code == 200


def test_a_vehicle_that_is_there_already_is_used_and_never_stopped(
    make_settings: Callable[..., Settings], tmp_path
) -> None:
    """Somebody else's node is no business of ours; our own second one gives way to it."""
    from bumpless_server.vehicle_process.process import spawn

    foreign_settings = make_settings()
    foreign = spawn(foreign_settings.node_command, tmp_path / "foreign.log", tmp_path / "foreign.json")
    try:
        taken = make_settings(node_command=(sys.executable, "-c", "raise SystemExit(3)"))
        with serving(taken) as running:
            running.until(lambda: live(running) and "node_elsewhere" in events(running))
            assert running.console.supervisor.restarts == 0
            answer = running.http.post("/api/mission/start", json={"name": "docking"})
            assert answer.json()["accepted"]
        assert foreign.alive()
    finally:
        foreign.signal(signal.SIGTERM)
        foreign.wait(20)
