"""A vehicle node in a process of its own, on a real bus: what it says, what it answers, how it ends."""

import signal
import subprocess
import threading

import zenoh
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from tests.node.listening import PATIENCE_S, ROOT, Listener, ended, light_node, program

Process = subprocess.Popen[str]


def test_idle_telemetry_is_complete(bus: Listener, node: Process) -> None:
    """Without a mission every topic but the plan is said, phase idle, actuators at rest, cycles in a row."""
    wanted = {f"tlm/{name}" for name in keys.TOPICS} - {"tlm/plan"} | {"truth/state"}
    bus.until(lambda: wanted <= {topic for topic, _, _ in bus.heard})
    bus.until(lambda: len(bus.of("tlm/actuators")) >= 20)
    assert {message.phase for message in bus.of("tlm/mission")} == {pb.MISSION_PHASE_IDLE}
    assert {a.command for message in bus.of("tlm/actuators") for a in message.actuators} == {0.0}
    cycles = [message.stamp.cycle for message in bus.of("tlm/navigation")]
    assert cycles == list(range(cycles[0], cycles[0] + len(cycles)))
    described = bus.of("tlm/description")[0]
    assert described.vehicle_id == "ts100" and described.control_period_s == 0.05
    health = bus.of("tlm/health")[0]
    assert health.process_id == node.pid and health.dropped_rows == 0


def test_a_mission_is_flown_and_ended_by_command(bus: Listener, node: Process) -> None:
    """Started, paused, resumed, aborted; status, plan and events tell the same run."""
    reply = bus.start()
    assert reply.accepted and "-docking-" in reply.run_id
    assert not bus.start().accepted
    assert bus.ask("pause").accepted and bus.ask("resume").accepted and bus.ask("abort").accepted
    over = bus.until(lambda: [m for m in bus.of("tlm/mission") if m.phase == pb.MISSION_PHASE_ABORTED])[0]
    assert over.run_id == reply.run_id and over.end_reason == "Mission aborted: aborted by the operator."
    plan = bus.until(lambda: bus.of("tlm/plan"))[0]
    assert plan.sha256 == over.mission_sha256 and len(plan.path_ned_m) >= 2
    bus.until(lambda: [event for event in bus.of("event") if event.code == "mission_aborted"])
    codes = [event.code for event in bus.of("event")]
    assert codes == [
        "mission_started",
        "command_refused",
        "mission_paused",
        "mission_resumed",
        "mission_aborted",
    ]


def test_parameters_are_said_after_they_are_in_force(bus: Listener, node: Process) -> None:
    """The reply's revision comes back on the bus with the new numbers and another hash."""
    before = bus.until(lambda: bus.of("tlm/parameters"))[0]
    wanted = pb.Parameters.FromString(before.active.SerializeToString())
    wanted.hover.ramp_cycles += 7
    reply = bus.ask("set_parameters", wanted)
    assert reply.accepted and reply.revision == before.revision + 1
    after = bus.until(lambda: [m for m in bus.of("tlm/parameters") if m.revision == reply.revision])[0]
    assert after.active == wanted and after.defaults == before.defaults and after.sha256 != before.sha256
    wanted.supervisor.detection_hits = 1000
    refused = bus.ask("set_parameters", wanted)
    assert not refused.accepted and refused.problems[0].field == "supervisor.detection_hits"


def test_the_bus_explains_itself(bus: Listener, node: Process) -> None:
    """With the schema from the vehicle alone, without our generated code, its messages can be read."""
    (reply,) = bus.session.get(keys.schema("ts100"), timeout=PATIENCE_S)
    assert reply.ok is not None
    files = descriptor_pb2.FileDescriptorSet.FromString(reply.ok.payload.to_bytes())
    pool = descriptor_pool.DescriptorPool()
    for file in files.file:
        pool.Add(file)
    bus.until(lambda: bus.of("tlm/description"))
    for topic, message, payload in list(bus.heard):
        foreign = message_factory.GetMessageClass(pool.FindMessageTypeByName(message.DESCRIPTOR.full_name))
        again = foreign.FromString(payload).SerializeToString(deterministic=True)
        assert again == message.SerializeToString(deterministic=True) == payload, topic


def test_an_unknown_command_is_an_error(bus: Listener, node: Process) -> None:
    """A caller with a wrong verb must not take silence for consent."""
    (reply,) = bus.session.get(keys.command("ts100", "fly_away"), timeout=PATIENCE_S)
    assert reply.err is not None and b"there is no command 'fly_away'" in reply.err.payload.to_bytes()


def test_events_are_kept_for_who_comes_late(bus: Listener, node: Process) -> None:
    """A console opened after the fact still learns what happened."""
    bus.ask("pause")
    bus.until(lambda: bus.of("event"))
    late, got = threading.Event(), []

    def hear(sample: zenoh.Sample) -> None:
        got.append(pb.Event.FromString(sample.payload.to_bytes()))
        late.set()

    held = zenoh.ext.declare_advanced_subscriber(
        bus.session, keys.event("ts100"), hear, history=zenoh.ext.HistoryConfig(detect_late_publishers=True)
    )
    assert late.wait(PATIENCE_S)
    assert got[0].code == "command_refused"
    held.undeclare()


def test_shutdown_is_answered_then_obeyed(bus: Listener, node: Process) -> None:
    """The server's clean way to end its node: accepted, not alive any more, exit code 0."""
    assert bus.ask("shutdown").accepted
    code, output = ended(node)
    assert code == 0 and "stopped by command" in output
    bus.until(lambda: bus.alive[-1] is False)


def test_termination_in_flight_ends_the_run_on_the_bus(bus: Listener, node: Process) -> None:
    """SIGTERM aborts the mission, and its end is said before the vehicle leaves."""
    run = bus.start().run_id
    node.send_signal(signal.SIGTERM)
    assert ended(node)[0] == 0
    bus.until(lambda: bus.alive[-1] is False)
    # the token's end may overtake the last words
    last = bus.until(lambda: [m for m in bus.of("tlm/mission") if m.phase == pb.MISSION_PHASE_ABORTED])[-1]
    assert last is bus.of("tlm/mission")[-1]
    assert (last.phase, last.run_id) == (pb.MISSION_PHASE_ABORTED, run)
    assert last.end_reason == "Mission aborted: stopped by SIGTERM."


def test_virtual_time_tells_every_cycle(bus: Listener, endpoint: str) -> None:
    """A mission flown as fast as it goes is complete: no row is lost between the loop and the bus."""
    with light_node(endpoint, "fast"):
        bus.until_alive()
        assert bus.start().accepted
        bus.until(lambda: [m for m in bus.of("tlm/mission") if m.phase == pb.MISSION_PHASE_COMPLETED])
        flown = [m.stamp.mission_time_s for m in bus.of("tlm/control") if m.stamp.mission_time_s > 0]
        assert [round(t / 0.05) for t in flown[:1800]] == list(range(1, 1801))


def test_a_mission_may_be_flown_without_being_asked(bus: Listener, endpoint: str) -> None:
    """A vehicle given a mission on its command line flies it, with or without a console."""
    with light_node(endpoint, "realtime", str(ROOT / "missions" / "docking.yaml")):
        status = bus.until(lambda: [m for m in bus.of("tlm/mission") if m.run_id])[0]
        assert (status.mission_name, status.phase) == ("docking", pb.MISSION_PHASE_RUNNING)


def test_a_vehicle_that_cannot_be_loaded_is_a_sentence(endpoint: str) -> None:
    """Exit code 1 and what is wrong, not a traceback."""
    with program(
        "-m", "bumpless_server.cli.main", "vehicle", "--id", "nosuch", "--connect", endpoint
    ) as process:
        code, output = ended(process)
    assert code == 1 and "nosuch" in output and "Traceback" not in output
