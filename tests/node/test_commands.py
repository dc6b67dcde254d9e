"""Accepted means done: a request is checked off the loop, carried out between two cycles, then answered."""

from collections.abc import Iterator

import pytest

from bumpless.config.parameters import to_message
from bumpless.contract import bumpless_pb2 as pb
from bumpless.node.flight import Flight
from bumpless.node.loop import Handoff
from tests.node.flying import MISSIONS, Flying

RUNNING, PAUSED, ABORTED = pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED, pb.MISSION_PHASE_ABORTED


@pytest.fixture
def flying() -> Iterator[Flying]:
    made = Flying()
    yield made
    if not made.ended.is_set():
        made.end()


def test_a_mission_through_all_its_phases(flying: Flying) -> None:
    """Start, pause, resume, abort: each is in force when its answer arrives."""
    reply = flying.start()
    assert reply.accepted and flying.twin.phase == RUNNING
    assert reply.run_id.startswith("2027") and reply.run_id[15:].startswith("Z-docking-")
    assert flying.ask("pause").accepted and flying.twin.phase == PAUSED
    assert flying.ask("resume").accepted and flying.twin.phase == RUNNING
    assert flying.ask("abort").accepted and flying.twin.phase == ABORTED
    again = flying.start()
    assert again.accepted and again.run_id != reply.run_id


def test_it_surfaces_out_of_a_mission_and_out_of_a_hold(flying: Flying) -> None:
    """Protects: who wants it up need not stop its actuators and wait until it has drifted there."""
    assert flying.start().accepted
    assert flying.ask("surface").accepted and flying.twin.phase == PAUSED
    assert flying.ask("resume").accepted and flying.twin.phase == RUNNING
    flying.twin.phase = pb.MISSION_PHASE_COMPLETED
    assert flying.ask("surface").accepted and flying.twin.phase == PAUSED
    assert flying.twin.surfaced == 2
    assert flying.ask("abort").accepted
    assert not flying.ask("surface").accepted


@pytest.mark.parametrize("verb", ["pause", "resume", "surface", "abort"])
def test_what_the_phase_forbids_is_refused_with_the_phase(flying: Flying, verb: str) -> None:
    """An idle vehicle has nothing to pause, resume, bring up or abort; the refusal is an event."""
    reply = flying.ask(verb)
    assert not reply.accepted and reply.reason.endswith("the phase is IDLE")
    events = [event for cycle in flying.end() for event in cycle.events]
    assert [(e.code, e.details["verb"]) for e in events] == [("command_refused", verb)]


def test_a_vehicle_that_holds_after_its_mission_can_be_stopped(flying: Flying) -> None:
    """Protects: while an actuator may move abort is not refused, whatever the mission's phase."""
    assert flying.start().accepted
    flying.twin.phase = pb.MISSION_PHASE_COMPLETED
    assert flying.ask("abort").accepted and flying.twin.phase == ABORTED
    assert not flying.ask("abort").accepted


def test_a_running_mission_is_not_replaced(flying: Flying) -> None:
    """Whoever wants another mission aborts the one that is flown; its run id says which that is."""
    first = flying.start()
    second = flying.start("docking_current.yaml")
    assert not second.accepted and first.run_id in second.reason
    assert flying.flight.state.run_id == first.run_id


def test_a_bad_mission_is_refused_with_its_lines(flying: Flying) -> None:
    """The problems name file, line and field; nothing has been touched."""
    text = (MISSIONS / "docking.yaml").read_text().replace("duration_s:", "duration: 90\nduration_s: -1 #")
    reply = flying.start("bad.yaml", text)
    assert not reply.accepted and flying.twin.mission is None
    assert {(p.file, p.field) for p in reply.problems} >= {("bad.yaml", "duration_s")}
    assert all(p.line > 0 for p in reply.problems)


def test_parameters_are_applied_once_and_kept_for_the_next_run(flying: Flying) -> None:
    """The revision grows with each accepted change, and a run starts with what the operator chose."""
    message = to_message(flying.flight.chosen)
    message.hover.ramp_cycles = 33
    reply = flying.ask("set_parameters", message.SerializeToString())
    assert reply.accepted and reply.revision == 2
    assert flying.twin.parameters.hover.ramp_cycles == 33
    assert flying.start().accepted
    assert flying.twin.parameters.hover.ramp_cycles == 33


def test_a_missions_overrides_end_with_it(flying: Flying) -> None:
    """Overrides of one mission must not leak into the next."""
    plain = (MISSIONS / "docking.yaml").read_text()
    text = plain.split("\nparameters:")[0] + "\nparameters:\n  hover:\n    ramp_cycles: 12\n"
    before = flying.flight.chosen.hover.ramp_cycles
    assert flying.start("tuned.yaml", text).accepted
    assert flying.twin.parameters.hover.ramp_cycles == 12
    assert flying.flight.state.revision == 2
    assert flying.ask("abort").accepted
    assert flying.start("plain.yaml", plain.split("\nparameters:")[0]).accepted
    assert flying.twin.parameters.hover.ramp_cycles == before


def test_parameters_out_of_range_change_nothing(flying: Flying) -> None:
    """Refused with field and rule; the revision stays."""
    message = to_message(flying.flight.chosen)
    message.reverse.q_diagonal[0] = -1.0
    reply = flying.ask("set_parameters", message.SerializeToString())
    assert not reply.accepted and reply.revision == 1
    assert [p.field for p in reply.problems] == ["reverse.q_diagonal[0]"]
    assert flying.flight.state.revision == 1


@pytest.mark.parametrize(
    ("verb", "payload", "reason"),
    [
        ("fly_away", b"", "there is no command 'fly_away'"),
        ("start", b"\xff\xff\xff", "not a bumpless.StartMission"),
        ("start", b"\x12\x80\x80\x80\x01" + b"x" * 2_097_152, "at most 1000000 bytes"),
    ],
)
def test_nonsense_is_refused_in_words(flying: Flying, verb: str, payload: bytes, reason: str) -> None:
    """Whatever comes from the bus gets an answer and does no harm."""
    reply = flying.ask(verb, payload)
    assert not reply.accepted and reason in reply.reason


def test_a_request_that_fails_on_the_loop_does_not_stop_it(flying: Flying) -> None:
    """The vehicle flies on and the operator hears why."""

    def broken(flight: Flight) -> pb.CommandReply:
        raise ArithmeticError("no such number")

    reply = flying.loop.submit(Handoff("test", broken)).reply(60.0)
    assert "ArithmeticError: no such number" in reply.reason
    assert flying.start().accepted


def test_a_request_whose_check_breaks_is_refused_too(flying: Flying, monkeypatch: pytest.MonkeyPatch) -> None:
    """The thread that answers must outlive what nobody foresaw, or the vehicle is deaf from then on."""

    def broken(*_: object) -> None:
        raise ArithmeticError("no such number")

    with monkeypatch.context() as patched:
        patched.setattr("bumpless.config.parameters.check", broken)
        reply = flying.ask("set_parameters", to_message(flying.flight.chosen).SerializeToString())
    assert not reply.accepted and "ArithmeticError: no such number" in reply.reason
    assert flying.start().accepted


def test_a_request_refused_for_silence_is_not_carried_out_later(flying: Flying) -> None:
    """The loop stands still, the answer is no; when the loop goes on, the request is withdrawn."""
    carried_out: list[Flight] = []

    def apply(flight: Flight) -> pb.CommandReply:
        carried_out.append(flight)
        return pb.CommandReply(accepted=True)

    reply = flying.submit(Handoff("test", apply)).reply(timeout_s=0.0)
    assert not reply.accepted and "did not answer" in reply.reason
    flying.end()
    assert carried_out == []


def test_the_loop_outlives_a_publisher_that_stands_still() -> None:
    """Nobody empties the ring: a thousand cycles are flown all the same, none late for that reason."""
    flying = Flying(capacity=16)
    assert flying.start().accepted
    before = flying.twin.steps
    flying.clock.fly(1000)
    assert flying.twin.steps == before + 1000
    cycles = flying.end()
    assert flying.loop.cycles == flying.twin.steps == flying.loop.lateness.total
    assert flying.ring.dropped == flying.twin.steps - len(cycles)


def test_a_stop_in_flight_aborts_the_mission_on_record() -> None:
    """The last row says ABORTED and an event says why, so that the run's file has an end."""
    flying = Flying()
    flying.start()
    cycles = flying.end()
    assert int(cycles[-1].row["phase"]) == ABORTED
    assert cycles[-1].events[-1].text == "Mission aborted: test over."


def test_shutdown_is_accepted_before_it_happens(flying: Flying) -> None:
    """The answer must be out before the session closes; ending is the process's matter."""
    assert flying.ask("shutdown").accepted
    assert not flying.ended.is_set()
