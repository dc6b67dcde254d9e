"""Every run is recorded by itself: the bus's own bytes, readable at every moment, closed at every end."""

import hashlib
import io
import json
import os
import signal
from collections import Counter
from collections.abc import Callable
from pathlib import Path

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.names import record_kind
from bumpless.runs.read import log_messages
from bumpless.runs.records import is_whole
from bumpless_server.live.link import LOST_WITHOUT_TOKEN_S
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

PER_CYCLE = ("tlm/navigation", "tlm/control")


def start(running: Running) -> str:
    answer = running.http.post("/api/mission/start", json={"name": "docking"})
    return answer.json()["run_id"]


def recorded(running: Running, run: str, state: str = "complete") -> dict:
    """The finished run, once it is in the list."""
    return running.until(
        lambda: next(
            (r for r in running.http.get("/api/runs").json() if r["id"] == run and r["state"] == state), None
        )
    )


def test_a_run_holds_each_of_its_messages_with_the_bytes_of_the_bus(
    make_settings: Callable[..., Settings], tmp_path: Path
) -> None:
    """From the first cycle to the last and the end's status: nothing missing, nothing changed."""
    told = tmp_path / "told.txt"
    with serving(make_settings("--mission-s", "2", "--told", str(told))) as running:
        running.until(lambda: running.console.state.latest("parameters"))
        run = start(running)
        row = recorded(running, run)
    path = running.console.data.runs / f"{run}.mcap"
    assert is_whole(path)
    assert (row["mission"], row["end_reason"], row["dropped"]) == ("docking", "mission completed", 0)
    lines = [line.rsplit(" ", 3) for line in told.read_text().splitlines()]
    ended = max(int(cycle) for topic, _, cycle, of in lines if topic == "event" and of == run)
    spoken = Counter(
        (topic, digest)
        for topic, digest, cycle, of in lines
        if of == run and topic in (*PER_CYCLE, "event") and int(cycle) <= ended
    )
    kept = Counter(
        (topic, hashlib.sha256(record.data).hexdigest())
        for topic, record in log_messages(path, {*PER_CYCLE, "event"})
    )
    assert row["outcome"] is None  # this vehicle describes itself in no terms that a flight can be judged by
    assert spoken == kept and sum(kept.values()) > 40
    last = [pb.MissionStatus.FromString(r.data) for _, r in log_messages(path, {"tlm/mission"})][-1]
    assert last.phase == pb.MISSION_PHASE_COMPLETED


def test_independent_readers_open_the_log_and_find_mission_parameters_and_hashes(
    make_settings: Callable[..., Settings],
) -> None:
    """The mcap reader and mcap-protobuf-support know nothing of us and read everything."""
    with serving(make_settings("--mission-s", "1")) as running:
        running.until(lambda: running.console.state.latest("parameters"))
        run = start(running)
        recorded(running, run)
        content = running.http.get(f"/api/runs/{run}/log.mcap")
        part = running.http.get(f"/api/runs/{run}/log.mcap", headers={"range": "bytes=0-7"})
        yaml = running.http.get("/api/missions/docking").json()
    assert part.status_code == 206 and part.content == b"\x89MCAP0\r\n"
    reader = make_reader(io.BytesIO(content.content), decoder_factories=[DecoderFactory()])
    decoded = {channel.topic for _, channel, _, _ in reader.iter_decoded_messages()}
    assert {"tlm/navigation", "tlm/mission", "tlm/plan", "tlm/description", "event"} <= decoded
    times = [(m.log_time, m.publish_time) for _, c, m in reader.iter_messages(["tlm/navigation"])]
    assert all(0 < published <= logged for logged, published in times)
    attached = {a.name: a.data for a in reader.iter_attachments()}
    assert attached["docking.yaml"].decode() == yaml["yaml"]
    assert b"q_diagonal" in attached["parameters.json"]
    metadata = {record_kind(m.name): m.metadata for m in reader.iter_metadata()}
    assert metadata["run"]["mission_sha256"] == yaml["sha256"]
    assert metadata["run"]["vehicle"] == "ts100"
    assert metadata["end"]["state"] == "complete"


def test_a_run_can_be_downloaded_while_it_is_recorded(running: Running) -> None:
    """What is on the disk so far arrives whole and can be read up to the last flush."""
    run = start(running)
    going = running.until(lambda: (r := running.console.recorder.recording) and r.messages > 20 and r)
    first = going.flushed_bytes
    running.until(lambda: going.flushed_bytes > first)
    content = running.http.get(f"/api/runs/{run}/log.mcap").content
    assert len(content) >= first
    copy = running.console.data.root / "copy.mcap"
    copy.write_bytes(content)
    assert sum(1 for _ in log_messages(copy, {"tlm/navigation"})) > 0
    listed = running.http.get("/api/runs").json()[0]
    assert (listed["id"], listed["state"]) == (run, "recording")
    assert running.http.get(f"/api/runs/{run}").json()["bytes"] > 0
    assert running.http.delete(f"/api/runs/{run}").status_code == 409
    assert running.http.get(f"/api/runs/{run}/metrics").status_code == 404


def test_killing_the_vehicle_closes_the_file_at_once_and_readable(running: Running) -> None:
    """kill -9: LOST by the end of its token and not by its silence; the run is closed, interrupted."""
    run = start(running)
    running.until(lambda: (r := running.console.recorder.recording) and r.messages > 20)
    ages: list[float] = []

    def note(sample) -> None:
        status = sample.decode()
        if isinstance(status, pb.ServerStatus) and status.link == pb.LINK_STATE_LOST:
            ages.append(status.telemetry_age_s)

    running.console.state.subscribe(note)
    os.kill(running.console.supervisor.pid or 0, signal.SIGKILL)
    running.until(lambda: ages)
    assert ages[0] < LOST_WITHOUT_TOKEN_S
    row = recorded(running, run, "interrupted")
    assert row["end_reason"] == "link to the vehicle lost" and row["messages"] > 20
    path = running.console.data.runs / f"{run}.mcap"
    assert is_whole(path)
    assert make_reader(path.open("rb")).get_summary() is not None


def test_runs_are_deleted_on_demand_and_strange_names_find_nothing(
    make_settings: Callable[..., Settings],
) -> None:
    """File and index go together; a name is never a path."""
    with serving(make_settings("--mission-s", "0.5")) as running:
        running.until(lambda: running.console.state.latest("parameters"))
        run = start(running)
        recorded(running, run)
        for name in ("..%2fsecret", "%2e%2e", "nowhere", "..%5cx"):
            assert running.http.get(f"/api/runs/{name}/log.mcap").status_code == 404
            assert running.http.delete(f"/api/runs/{name}").status_code in (404, 405)
        assert running.http.delete(f"/api/runs/{run}").status_code == 204
        assert running.http.get(f"/api/runs/{run}").status_code == 404
        assert not (running.console.data.runs / f"{run}.mcap").exists()
        assert running.http.get("/api/runs").json() == []


def test_who_asked_for_what_stands_in_the_log(make_settings: Callable[..., Settings]) -> None:
    """Protects: a log tells by whom a flight was begun and changed, also to who has the file alone."""
    with serving(make_settings()) as running:
        running.until(lambda: running.console.state.latest("parameters"))
        running.http.post("/api/mission/start", json={"name": "docking", "operator": "Ada"})
        (entry,) = running.http.get("/api/audit").json()
        running.until(lambda: running.console.recorder.recording)
        assert running.http.post("/api/mission/pause").status_code == 200
        assert running.http.post("/api/mission/resume").status_code == 200
        assert running.http.post("/api/mission/abort").status_code == 200
        row = running.until(lambda: next(iter(running.console.catalogue.rows()), None))
    path = running.console.data.runs / f"{row.summary.id}.mcap"
    told = [pb.AuditEntry.FromString(record.data) for _, record in log_messages(path, {"server/audit"})]
    done = [(one.verb, one.answer) for one in told]
    assert done[:3] == [("start", "accepted"), ("pause", "accepted"), ("resume", "accepted")]
    assert done[3:] in ([], [("abort", "accepted")])  # its answer comes when the file may be closed
    assert told[0].author == "Ada" and told[0].id == entry["id"]
    assert json.loads(told[0].details_json)["mission"] == "docking.yaml"
    assert is_whole(path)
