"""Commands over HTTP with a real vehicle node: once, in time, by whom, and never in each other's way."""

import json
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator

import pytest
import zenoh

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import session_config
from bumpless_server.live.desk import AT_ONCE
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

Make = Callable[..., Settings]


def light(make_settings: Make, **more: object) -> Settings:
    """Settings of a server whose vehicle is a real node with a light twin."""
    (bus,) = make_settings().zenoh_listen
    return make_settings(node_command=(sys.executable, "-m", "tests.node.light", bus), **more)


@pytest.fixture
def flying(make_settings: Make) -> Iterator[Running]:
    with serving(light(make_settings)) as running:
        running.until(lambda: running.console.state.latest("parameters") and running.console.speaker.session)
        yield running


def phase(running: Running) -> int:
    status = running.console.state.latest("mission")
    return status.phase if isinstance(status, pb.MissionStatus) else 0


def test_what_was_answered_503_does_not_happen_afterwards(make_settings: Make) -> None:
    """Protects: start and parameters sent to a frozen vehicle were carried out when it woke, 5.5 s later."""
    with serving(light(make_settings, command_timeout_s=1.0)) as running:
        state = running.console.state
        before = running.until(lambda: running.console.speaker.session and state.latest("parameters"))
        pid = running.console.supervisor.pid or 0
        os.kill(pid, signal.SIGSTOP)
        try:
            start = running.http.post("/api/mission/start", json={"name": "docking"})
            tune = running.http.put(
                "/api/parameters", json=running.http.get("/api/parameters").json()["active"]
            )
        finally:
            os.kill(pid, signal.SIGCONT)
        assert start.status_code == tune.status_code == 503
        assert "no vehicle" in start.json()["detail"]
        running.until(lambda: state.link == pb.LINK_STATE_LIVE)
        told = running.until(lambda: (s := state.latest("parameters")) is not before and s)
        assert phase(running) == pb.MISSION_PHASE_IDLE and told.revision == before.revision
        entries = running.http.get("/api/audit").json()
        assert [(e["verb"], e["answer"]) for e in entries] == [("set_parameters", "none"), ("start", "none")]


def test_the_same_key_is_the_same_command(flying: Running) -> None:
    """Protects: a page that asks again after a lost answer must not fly twice, nor be told it failed."""
    key = {"idempotency-key": "start-1"}
    first = flying.http.post("/api/mission/start", json={"name": "docking"}, headers=key)
    again = flying.http.post("/api/mission/start", json={"name": "docking"}, headers=key)
    assert first.json()["accepted"] and first.json()["id"] == "start-1"
    assert again.json() == first.json()
    odd = flying.http.post("/api/mission/abort", headers={"idempotency-key": "../x"})
    assert odd.status_code == 422 and "Idempotency-Key" in odd.json()["detail"]
    assert flying.http.post("/api/mission/abort").json()["accepted"]


def test_a_change_made_from_an_old_revision_is_412(flying: Running) -> None:
    """Protects: the second of two operators undid the first one's change without knowing of it."""
    told = flying.http.get("/api/parameters").json()
    seen = {"if-match": f'"{told["revision"]}"'}
    told["active"]["hover"]["ramp_cycles"] += 1
    assert flying.http.put("/api/parameters", json=told["active"], headers=seen).status_code == 200
    late = flying.http.put("/api/parameters", json=told["active"], headers=seen)
    assert late.status_code == 412 and late.json()["revision"] == told["revision"] + 1
    assert (
        flying.http.put("/api/parameters", json=told["active"], headers={"if-match": "x"}).status_code == 422
    )


def test_every_command_is_written_down_and_still_there_after_a_restart(make_settings: Make) -> None:
    """Protects: who changed what from what to what, and what the vehicle said, in a file that only grows."""
    settings = light(make_settings)
    with serving(settings) as running:
        running.until(lambda: running.console.state.latest("parameters") and running.console.speaker.session)
        told = running.http.get("/api/parameters").json()["active"]
        before = told["hover"]["ramp_cycles"]
        told["hover"]["ramp_cycles"] = before + 1
        who = {"x-operator": "Ada\tforged"}
        assert running.http.put("/api/parameters", json=told, headers=who).status_code == 200
        assert running.http.post("/api/mission/abort").status_code == 409
    with settings.data_dir.joinpath("audit.jsonl").open("a") as file:
        file.write('{"half a line')
    with serving(make_settings(manage_node=False)) as again:
        assert again.http.post("/api/mission/pause").status_code == 503
        pause, abort, tune = again.http.get("/api/audit").json()
        lines = again.http.get("/api/audit.jsonl").text.splitlines()
    assert (pause["verb"], pause["answer"]) == ("pause", "none")
    assert (abort["verb"], abort["answer"], abort["address"]) == ("abort", "refused", "127.0.0.1")
    assert tune["author"] == "Ada\\tforged" and tune["said"].startswith("parameters are in force")
    assert tune["details"]["changes"] == {"hover.ramp_cycles": [before, before + 1]}
    assert len(lines) == 4 and json.loads(lines[-1])["verb"] == "pause"


def test_hanging_commands_keep_nobody_else_waiting(make_settings: Make) -> None:
    """Protects: health waited behind 80 hanging commands, an abort behind 30 starts."""
    waiting: list[zenoh.Query] = []

    def hang(query: zenoh.Query) -> None:
        if str(query.key_expr).endswith("abort"):
            with query:
                assert query.attachment is not None
                header = pb.RequestHeader.FromString(query.attachment.to_bytes())
                reply = pb.CommandReply(accepted=True, id=header.id)
                query.reply(query.key_expr, reply.SerializeToString())
            return
        waiting.append(query)

    with serving(make_settings(manage_node=False, command_timeout_s=60.0)) as running:
        with zenoh.open(session_config("peer", running.console.settings.zenoh_listen)) as vehicle:
            held = vehicle.declare_queryable(keys.command("ts100", "*"), hang, complete=True)
            running.until(lambda: running.http.post("/api/mission/abort").status_code == 200)
            statuses: list[int] = []

            def ask() -> None:
                statuses.append(running.http.post("/api/mission/resume").status_code)

            threads = [threading.Thread(target=ask) for _ in range(80)]
            for thread in threads:
                thread.start()
            running.until(lambda: len(statuses) == 80 - AT_ONCE)
            assert set(statuses) == {503}
            assert running.http.get("/api/health").status_code == 200
            assert running.http.post("/api/mission/abort").json()["accepted"]
            running.until(lambda: len(waiting) == AT_ONCE)
            held.undeclare()
            for query in waiting:
                query.drop()
            for thread in threads:
                thread.join()
        kinds = {one["kind"]: one["count"] for one in running.http.get("/api/diagnostics").json()["counted"]}
        assert kinds["too_many_commands"] == 80 - AT_ONCE and kinds["no_answer"] >= AT_ONCE
