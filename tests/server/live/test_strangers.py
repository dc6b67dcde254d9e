"""Others on the bus, with a real node, a real server and real sessions: heard and counted, not believed."""

import os
import signal
import sys
from collections.abc import Callable, Iterator

import pytest
import zenoh
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import session_config
from bumpless_server.live.stream import EVENT_BYTES
from bumpless_server.settings import Settings
from tests.server.serving import PATIENCE_S, Running, serving

STAMP = pb.Stamp(time_ns=1, cycle=10**9)


@pytest.fixture
def flying(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server whose vehicle is a real node with a light twin."""
    (bus,) = make_settings().zenoh_listen
    light = (sys.executable, "-m", "tests.node.light", bus)
    with serving(make_settings(node_command=light)) as running:
        running.until(lambda: running.console.state.latest("parameters") and running.console.speaker.session)
        yield running


@pytest.fixture
def stranger(flying: Running) -> Iterator[zenoh.Session]:
    """A session of somebody who reaches the bus."""
    with zenoh.open(session_config("peer", flying.console.settings.zenoh_listen)) as session:
        yield session


def say(session: zenoh.Session, topic: str, message: Message) -> None:
    """Put a message on a topic of the vehicle's, such as "tlm/navigation" or "event"."""
    encoding = keys.encoding_of(message)
    session.put(f"bumpless/ts100/{topic}", message.SerializeToString(), encoding=encoding)


def events(running: Running) -> list[dict]:
    return running.http.get("/api/events").json()


def counted(running: Running) -> dict[str, int]:
    return {one["kind"]: one["count"] for one in running.http.get("/api/diagnostics").json()["counted"]}


def test_forged_telemetry_is_not_the_vehicles_and_raises_an_alarm(
    flying: Running, stranger: zenoh.Session
) -> None:
    """Protects: forged navigation won the screen over the vehicle's own."""
    heard: list[float] = []

    def note(sample) -> None:
        message = sample.decode()
        if isinstance(message, pb.Navigation):
            heard.append(message.depth_m)

    flying.console.state.subscribe(note)
    for _ in range(20):
        say(stranger, "tlm/navigation", pb.Navigation(stamp=STAMP, depth_m=4321.0))
    flying.until(lambda: flying.console.tally.of("second_speaker") >= 20)
    flying.until(lambda: any(e["code"] == "second_speaker" for e in events(flying)))
    (alarm,) = [e for e in events(flying) if e["code"] == "second_speaker"]
    assert alarm["severity"] == "SEVERITY_ALARM" and "not listened to" in alarm["text"]
    flying.until(lambda: len(heard) > 10)
    assert 4321.0 not in heard
    assert counted(flying)["second_speaker"] >= 20


def test_a_stranger_does_not_keep_a_frozen_vehicle_live(flying: Running, stranger: zenoh.Session) -> None:
    """Protects: a stopped vehicle must look stopped, whoever else says its words."""
    pid = flying.console.supervisor.pid or 0
    os.kill(pid, signal.SIGSTOP)
    try:

        def lost() -> bool:
            say(stranger, "tlm/navigation", pb.Navigation(stamp=STAMP, depth_m=4321.0))
            return flying.console.state.link == pb.LINK_STATE_LOST

        flying.until(lost)
        for _ in range(50):
            say(stranger, "tlm/navigation", pb.Navigation(stamp=STAMP, depth_m=4321.0))
        before = flying.console.tally.of("second_speaker")
        say(stranger, "tlm/navigation", pb.Navigation(stamp=STAMP, depth_m=4321.0))
        flying.until(lambda: flying.console.tally.of("second_speaker") > before)
        assert flying.console.state.link == pb.LINK_STATE_LOST
    finally:
        os.kill(pid, signal.SIGCONT)
    flying.until(lambda: flying.console.state.link == pb.LINK_STATE_LIVE)


def test_a_foreign_answer_to_an_abort_does_not_count(flying: Running, stranger: zenoh.Session) -> None:
    """Protects: a foreign queryable answered an abort "accepted" while the vehicle flew on."""
    asked: list[str] = []

    def accept(query: zenoh.Query) -> None:
        with query:
            asked.append(str(query.key_expr))
            header = pb.RequestHeader.FromString(query.attachment.to_bytes()) if query.attachment else None
            reply = pb.CommandReply(accepted=True, reason="of course", id=header.id if header else "")
            query.reply(keys.command("ts100", "abort"), reply.SerializeToString())

    held = stranger.declare_queryable(keys.command("ts100", "*"), accept, complete=True)
    flying.until(lambda: flying.http.post("/api/mission/abort").status_code and asked)
    answer = flying.http.post("/api/mission/abort")
    assert answer.status_code == 409 and "nothing is flown" in answer.json()["detail"]
    flying.until(lambda: flying.console.tally.of("foreign_reply") > 0)
    assert flying.http.post("/api/mission/start", json={"name": "docking"}).json()["accepted"]
    stopped = flying.http.post("/api/mission/abort").json()
    assert stopped["accepted"] and stopped["reason"] == "aborted by the operator"
    held.undeclare()


def test_forged_statuses_cut_no_flight_into_pieces(flying: Running, stranger: zenoh.Session) -> None:
    """Protects: one flight became 33 files, and names from the bus became paths outside the data folder."""
    run = flying.http.post("/api/mission/start", json={"name": "docking"}).json()["run_id"]
    flying.until(lambda: (r := flying.console.recorder.recording) and r.id == run)
    for name in ("other", "../../x", "/etc/x", "x" * 300, "a\nb"):
        forged = pb.MissionStatus(stamp=STAMP, phase=pb.MISSION_PHASE_RUNNING, run_id=name)
        say(stranger, "tlm/mission", forged)
    flying.until(lambda: flying.console.tally.of("second_speaker") >= 5)
    assert flying.http.post("/api/mission/abort").json()["accepted"]
    flying.until(lambda: flying.http.get(f"/api/runs/{run}").json().get("state") == "complete")
    assert [path.stem for path in flying.console.data.runs.iterdir()] == [run]


def test_invented_topics_and_masses_of_events_are_not_kept(flying: Running, stranger: zenoh.Session) -> None:
    """Protects: 300 invented topics of 1 MB were kept for each new browser, 580 events made 2.1 GB."""

    def masses() -> bool:
        for topic, size in (("tlm/invented", 1_000_000), ("event", 4_000_000)):
            encoding = keys.encoding_of(pb.Event)
            stranger.put(f"bumpless/ts100/{topic}", b"x" * size, encoding=encoding)
        return counted(flying)["unknown_key"] > 2 and counted(flying)["too_large"] > 2

    flying.until(masses)
    state = flying.console.state
    told = {sample.topic for sample in state.samples() if sample.from_vehicle}
    assert told <= {f"tlm/{name}" for name in keys.TOPICS}
    assert sum(len(sample.payload) for sample in state.events()) < EVENT_BYTES


def test_a_second_node_is_not_started_by_the_same_command(flying: Running, stranger: zenoh.Session) -> None:
    """Protects: two vehicles of one id both flew at one start: a request names the session it is for."""
    headers: list[pb.RequestHeader] = []

    def listen(query: zenoh.Query) -> None:
        with query:
            if query.attachment is not None:
                headers.append(pb.RequestHeader.FromString(query.attachment.to_bytes()))
            query.reply_err(b"not mine")

    held = stranger.declare_queryable(keys.command("ts100", "*"), listen, complete=True)
    flying.until(lambda: flying.http.post("/api/mission/abort").status_code and headers)
    assert headers[0].session_id == flying.console.speaker.session != str(stranger.zid())
    assert headers[0].id and headers[0].expires_ns
    held.undeclare()


def test_an_open_bus_says_so_all_the_time(make_settings: Callable[..., Settings]) -> None:
    """Protects: without keys on a shared network the console says so, on the status and as an event."""
    (bus,) = make_settings().zenoh_listen
    shared = bus.replace("127.0.0.1", "0.0.0.0")
    with serving(make_settings(manage_node=False, zenoh_listen=(shared,))) as running:
        assert "The bus has no keys" in running.http.get("/api/status").json()["bus_notice"]
        running.until(lambda: "bus_open" in [event["code"] for event in events(running)])
    with serving(make_settings(manage_node=False)) as running:
        assert running.http.get("/api/status").json()["bus_notice"] == ""


def test_one_bad_topic_takes_nothing_from_the_others(
    make_settings: Callable[..., Settings],
) -> None:
    """Protects: one undecodable topic cost the rest of each frame; NaN and a missing stamp were 500s."""
    with serving(make_settings(manage_node=False)) as running:
        with zenoh.open(session_config("peer", running.console.settings.zenoh_listen)) as vehicle:
            token = vehicle.liveliness().declare_token(keys.alive("ts100"))
            nav = pb.Navigation(stamp=STAMP, depth_m=2.0)
            encoding = keys.encoding_of(nav)

            def hostile() -> bool:
                vehicle.put(
                    "bumpless/ts100/tlm/control",
                    b"\xff\xff",
                    encoding="application/protobuf;bumpless.Control",
                )
                vehicle.put("bumpless/ts100/tlm/health", b"", encoding="text/plain")
                vehicle.put("bumpless/ts100/tlm/target", nav.SerializeToString(), encoding=encoding)
                say(vehicle, "tlm/description", pb.VehicleDescription(vehicle_id="ts100"))
                say(vehicle, "tlm/mission", pb.MissionStatus(stamp=STAMP, elapsed_s=float("nan")))
                say(vehicle, "tlm/allocation", pb.Allocation(stamp=STAMP, cost=float("inf")))
                say(vehicle, "tlm/navigation", nav)
                return isinstance(running.console.state.latest("allocation"), pb.Allocation)

            running.until(hostile)
            running.until(lambda: hostile() and running.console.state.latest("navigation"))
            wanted = {"undecodable", "wrong_type", "no_stamp", "non_finite"}
            running.until(lambda: wanted <= {kind for kind, count in counted(running).items() if count})
            for path in ("/api/status", "/api/events", "/api/diagnostics", "/api/runs"):
                assert running.http.get(path).status_code == 200
            assert running.console.state.latest("control") is None
            kept = {kind["kind"]: kind for kind in running.http.get("/api/diagnostics").json()["counted"]}
            assert kept["non_finite"]["example"] and kept["non_finite"]["last"]
            token.undeclare()


def test_the_server_says_that_it_is_there(flying: Running, stranger: zenoh.Session) -> None:
    """Protects: a vehicle can only miss a console that said it was there."""
    heard: list[bytes] = []
    held = stranger.declare_subscriber(
        keys.heartbeat("ts100"), lambda sample: heard.append(sample.payload.to_bytes())
    )
    flying.until(lambda: len(heard) > 1)
    assert pb.Heartbeat.FromString(heard[0]).session_id
    declared = flying.http.get("/api/vehicle").json()["failsafe"]
    (lost,) = [one for one in declared if one["cause"] == "heartbeat_lost"]
    assert lost["reaction"] == "none" and lost["limit"] is None
    assert {one["cause"]: one["does"] for one in declared}["leak"] == "holds station at the surface"
    held.undeclare()


def test_each_topic_has_an_age_of_its_own(flying: Running) -> None:
    """Protects: a topic that stopped looked as live as the link; what was never heard is late, not fresh."""

    def ages() -> dict[str, dict]:
        return {one["topic"]: one for one in flying.http.get("/api/diagnostics").json()["topics"]}

    told = flying.until(lambda: (now := ages())["tlm/navigation"]["late"] is False and now)
    assert told.keys() == {f"tlm/{name}" for name in keys.TOPICS}
    assert told["tlm/plan"] == {"topic": "tlm/plan", "age_s": None, "fresh_for_s": 5.0, "late": True}
    status = flying.http.get("/api/status").json()
    assert {one["topic"] for one in status["topics"]} == told.keys()
    assert abs(status["clock_offset_s"]) < PATIENCE_S
