"""One vehicle id, one node; and who is dead or frozen is seen to be."""

import os
import select
import signal
import subprocess

from bumpless.contract import keys
from tests.node.listening import PATIENCE_S, Listener, ended, light_node, listening

Process = subprocess.Popen[str]


def test_a_second_node_for_a_live_vehicle_refuses_to_start(
    bus: Listener, node: Process, endpoint: str
) -> None:
    """Exit code 3 and a sentence; the first flies on untouched, and the second was never heard."""
    run = bus.start().run_id
    with light_node(endpoint) as second:
        code, output = ended(second)
    assert code == 3 and "already alive" in output
    assert node.poll() is None
    count = len(bus.of("tlm/mission"))
    status = bus.until(lambda: bus.of("tlm/mission")[count:])[-1]
    assert status.run_id == run
    assert bus.alive == [True]
    assert len({m.session_id for m in bus.of("tlm/description")}) == 1
    cycles = [m.stamp.cycle for m in bus.of("tlm/navigation")]
    assert cycles == sorted(set(cycles))  # one voice


def test_of_two_started_at_once_exactly_one_stays(bus: Listener, endpoint: str) -> None:
    """Neither sees the other alive when it starts; the claims decide, and both sides alike."""
    with light_node(endpoint) as one, light_node(endpoint) as other:
        bus.until_alive()
        loser = _first_to_end(one, other)
        assert ended(loser)[0] == 3
        winner = other if loser is one else one
        bus.until(lambda: bus.of("tlm/description"))
        assert len({m.session_id for m in bus.of("tlm/description")}) == 1 and bus.alive == [True]
        assert bus.ask("shutdown").accepted
        assert ended(winner)[0] == 0


def test_two_that_met_only_later_leave_one(endpoint: str) -> None:
    """Both start while the bus is away, as after a power cut: one stays, the other was never heard."""
    with light_node(endpoint) as one:
        _until_said(one, "says nothing before")
        with light_node(endpoint) as other:
            _until_said(other, "says nothing before")
            with listening(endpoint) as bus:
                bus.until_alive()
                loser = _first_to_end(one, other)
                winner = other if loser is one else one
                code, output = ended(loser)
                assert code == 3 and ("giving way" in output or "already alive" in output)
                assert winner.poll() is None
                bus.until(lambda: bus.of("tlm/description"))
                assert len({m.session_id for m in bus.of("tlm/description")}) == 1  # the loser said nothing
                assert bus.alive == [True]
                assert bus.ask("shutdown").accepted
                assert ended(winner)[0] == 0


def test_a_killed_node_is_missed(bus: Listener, node: Process) -> None:
    """After kill -9 the token goes, without any goodbye."""
    node.kill()
    bus.until(lambda: bus.alive[-1] is False)


def test_a_frozen_node_is_missed_and_comes_back(bus: Listener, node: Process) -> None:
    """Stopped, it is as good as dead; continued, it counts the deadlines it missed and flies on."""
    bus.until(lambda: bus.of("tlm/health"))
    node.send_signal(signal.SIGSTOP)
    bus.until(lambda: bus.alive[-1] is False)
    before = bus.of("tlm/health")[-1]  # a busy machine may have missed some by then
    node.send_signal(signal.SIGCONT)
    bus.until_alive(2)
    later = bus.until(lambda: [m for m in bus.of("tlm/health") if m.missed_cycles > before.missed_cycles])
    missed = later[0].missed_cycles - before.missed_cycles
    assert later[0].lateness_max_ms > 50.0 * missed / 2


def test_the_vehicle_outlives_the_server_and_is_found_again(endpoint: str) -> None:
    """The bus goes away in flight; a new one at the same address finds the same run further on."""
    with light_node(endpoint) as node:
        with listening(endpoint) as bus:
            bus.until_alive()
            run = bus.start().run_id
            session = bus.until(lambda: bus.of("tlm/description"))[0].session_id
            before = bus.until(lambda: bus.of("tlm/navigation"))[-1].stamp.cycle
        with listening(endpoint) as bus:
            bus.until_alive()
            status = bus.until(lambda: bus.of("tlm/mission"))[0]
            assert status.run_id == run and status.stamp.cycle > before
            described = bus.until(lambda: bus.of("tlm/description"))[0]
            assert described.session_id == session
            first = bus.until(lambda: bus.of("tlm/navigation"))[0]
            assert described.stamp.cycle - first.stamp.cycle <= 5  # told anew, not when next due
            assert bus.ask("abort").accepted
            assert node.poll() is None


def test_claims_order_by_age_then_session() -> None:
    """Both sides compare the same strings, so times must sort as text."""
    older, younger = keys.claim("ts100", 999, "a"), keys.claim("ts100", 1000, "a")
    assert older < younger < keys.claim("ts100", 1000, "b")


def _until_said(process: Process, words: str) -> None:
    assert process.stdout is not None
    for line in process.stdout:
        if words in line:
            return
    raise AssertionError(f"the node ended without saying {words!r}")


def _first_to_end(*processes: Process) -> Process:
    """Wait for whichever ends first."""
    watched = {os.pidfd_open(process.pid): process for process in processes}
    ready, _, _ = select.select(list(watched), [], [], PATIENCE_S)
    for descriptor in watched:
        os.close(descriptor)
    return watched[ready[0]]
