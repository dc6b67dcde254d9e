"""Done now or not at all: what comes late, twice, too much at once or to the wrong vehicle is refused."""

import signal
import subprocess
import time

import zenoh

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.session import node_config
from tests.node.listening import PATIENCE_S, ROOT, Listener, ended

Process = subprocess.Popen[str]
DOCKING = pb.StartMission(
    file_name="docking.yaml", mission_yaml=(ROOT / "missions" / "docking.yaml").read_text()
)


def refusals(bus: Listener) -> list[str]:
    """The verbs of what the vehicle said it refused."""
    return [event.details["verb"] for event in bus.of("event") if event.code == "command_refused"]


def test_what_reaches_a_frozen_vehicle_is_not_carried_out_later(bus: Listener, node: Process) -> None:
    """Protects: start, parameters and abort were answered "no vehicle" and happened when the node woke."""
    replies: list[zenoh.Reply] = []
    node.send_signal(signal.SIGSTOP)
    soon = time.time_ns() + 200_000_000
    for number, (verb, request) in enumerate({"start": DOCKING, "abort": pb.Empty()}.items()):
        header = pb.RequestHeader(id=str(number), expires_ns=soon)
        bus.session.get(
            keys.command("ts100", verb),
            replies.append,
            payload=request.SerializeToString(),
            attachment=header.SerializeToString(),
            timeout=PATIENCE_S,
        )
    while time.time_ns() <= soon:
        pass
    node.send_signal(signal.SIGCONT)
    bus.until(lambda: set(refusals(bus)) == {"start", "abort"})
    told = [event.text for event in bus.of("event") if event.code == "command_refused"]
    assert all("after it had expired" in text for text in told)
    status = bus.until(lambda: bus.of("tlm/mission"))[-1]
    assert status.phase == pb.MISSION_PHASE_IDLE


def test_a_repeated_request_is_done_once(bus: Listener, node: Process) -> None:
    """Protects: a retry of a start that got through must not be refused, nor fly a second time."""
    first = bus.ask("start", DOCKING, id="once")
    again = bus.ask("start", DOCKING, id="once")
    assert first.accepted and first.id == "once"
    assert again == first
    assert bus.ask("abort", id="once").reason == "the id was used for 'start'"
    bus.until_all_said()
    codes = [event.code for event in bus.of("event")]
    assert codes.count("mission_started") == 1


def test_a_request_without_a_header_may_only_stop(bus: Listener, node: Process) -> None:
    """Protects: what says neither who nor until when is not begun; to stop is always allowed."""
    assert bus.ask("start", DOCKING, id="").cause == pb.REFUSAL_CAUSE_NO_HEADER
    assert bus.ask("start", DOCKING, expires_ns=0).cause == pb.REFUSAL_CAUSE_NO_HEADER
    assert bus.ask("start", DOCKING).accepted
    assert bus.ask("abort", id="").accepted


def test_a_request_for_another_session_is_not_ours(bus: Listener, node: Process) -> None:
    """Protects: two vehicles of one id both flew at one start."""
    own = bus.until(lambda: bus.of("tlm/description"))[0].session_id
    assert bus.ask("start", DOCKING, session_id="abc").cause == pb.REFUSAL_CAUSE_NOT_ADDRESSED
    assert bus.ask("start", DOCKING, session_id=own).accepted


def test_parameters_made_from_an_older_revision_are_refused(bus: Listener, node: Process) -> None:
    """Protects: of two operators the second must not undo the first one's change without knowing of it."""
    message = bus.until(lambda: bus.of("tlm/parameters"))[0]
    assert bus.ask("set_parameters", message.active, if_revision=message.revision).accepted
    late = bus.ask("set_parameters", message.active, if_revision=message.revision)
    assert late.cause == pb.REFUSAL_CAUSE_STALE_REVISION and late.revision == message.revision + 1


def test_an_abort_overtakes_what_waits(bus: Listener, node: Process) -> None:
    """Protects: an abort came 15.7 s late behind 30 starts, and the starts were flown after it."""
    replies: list[zenoh.Reply] = []
    for number in range(30):
        header = pb.RequestHeader(id=f"s{number}", expires_ns=time.time_ns() + round(PATIENCE_S * 1e9))
        bus.session.get(
            keys.command("ts100", "start"),
            replies.append,
            payload=DOCKING.SerializeToString(),
            attachment=header.SerializeToString(),
            timeout=PATIENCE_S,
        )
    stopped = bus.ask("abort")
    assert stopped.accepted
    assert len(replies) < 30, "the abort waited for every start"
    bus.until(lambda: [None for _ in replies] if len(replies) == 30 else None)
    answers = [pb.CommandReply.FromString(reply.ok.payload.to_bytes()) for reply in replies if reply.ok]
    causes = [answer.cause for answer in answers]
    assert pb.REFUSAL_CAUSE_BUSY in causes, "the queue has no bound"
    assert pb.REFUSAL_CAUSE_OVERTAKEN in causes
    bus.until_all_said()
    count = len(bus.of("tlm/mission"))
    status = bus.until(lambda: bus.of("tlm/mission")[count:])[-1]
    assert status.phase in (pb.MISSION_PHASE_IDLE, pb.MISSION_PHASE_ABORTED)


def test_an_older_rival_takes_no_vehicle_out_of_its_flight(
    bus: Listener, node: Process, endpoint: str
) -> None:
    """Protects: a claim, forged or not, ended a vehicle in flight; it flies on, says so, and yields later."""
    assert bus.ask("start", DOCKING).accepted
    with zenoh.open(node_config([endpoint])) as rival:
        serving = rival.declare_queryable(keys.schema("ts100"), _say_contract, complete=True)
        token = rival.liveliness().declare_token(keys.claim("ts100", 1, str(rival.zid())))
        bus.until(lambda: [e for e in bus.of("event") if e.code == "second_speaker"])
        assert bus.of("tlm/mission")[-1].phase == pb.MISSION_PHASE_RUNNING and node.poll() is None
        assert bus.ask("abort").accepted
        assert ended(node)[0] == 3
        token.undeclare()
        serving.undeclare()


def _say_contract(query: zenoh.Query) -> None:
    with query:
        query.reply(query.key_expr, b"a contract")
