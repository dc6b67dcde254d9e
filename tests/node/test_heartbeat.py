"""A vehicle that loses its console, or whoever held control, does what its file declares, and says so."""

from pathlib import Path

import pytest

from bumpless.config.vehicle import VehicleError, load_vehicle
from bumpless.config.vehicle.failsafe import Failsafe
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.heartbeat import OWN_FREEZE_S, Heartbeat, Presence
from tests.node.listening import Listener, light_node

RUNNING, IDLE = pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_IDLE


class Now:
    """A clock that stands until it is moved."""

    def __init__(self) -> None:
        self.s = 100.0

    def __call__(self) -> float:
        return self.s

    def pass_by(self, heart: Presence, seconds: float, phase: int = RUNNING) -> list[float]:
        """Look four times a second for so long; what was lost."""
        found = []
        for _ in range(round(4 * seconds)):
            self.s += 0.25
            found.append(heart.lost_s(phase))
        return [lost for lost in found if lost is not None]


def with_failsafe(folder: Path, reaction: str, cause: str = "heartbeat_lost", limit_s: float = 0.5) -> Path:
    """A vehicle file like ts100's that acts after so long without whom `cause` names."""
    path = folder / "ts100.toml"
    table = f'\n[failsafe]\n{cause}_s = {limit_s}\n{cause} = "{reaction}"\n'
    path.write_text(load_vehicle("ts100").text + table)
    return path


@pytest.mark.parametrize(
    ("reaction", "phase"), [("hold", pb.MISSION_PHASE_PAUSED), ("abort", pb.MISSION_PHASE_ABORTED)]
)
def test_a_silent_console_makes_the_vehicle_do_what_its_file_declares(
    bus: Listener, endpoint: str, tmp_path: Path, reaction: str, phase: int
) -> None:
    """Protects: without a console a mission is not flown on by accident, where the file says so."""
    with light_node(endpoint, "realtime", "", str(with_failsafe(tmp_path, reaction))):
        bus.until_alive()
        assert bus.start().accepted
        # heard in the mission: one that was silent before it began has not left it
        bus.session.put(keys.heartbeat("ts100"), pb.Heartbeat(time_ns=1).SerializeToString())
        (event,) = bus.until(lambda: [e for e in bus.of("event") if e.code == "failsafe"])
        assert event.severity == pb.SEVERITY_ALARM and event.details["reaction"] == reaction
        bus.until(lambda: bus.of("tlm/mission")[-1].phase == phase)


@pytest.mark.parametrize(
    ("reaction", "phase"), [("hold", pb.MISSION_PHASE_PAUSED), ("abort", pb.MISSION_PHASE_ABORTED)]
)
def test_when_nobody_is_in_control_it_does_what_its_file_declares(
    bus: Listener, endpoint: str, tmp_path: Path, reaction: str, phase: int
) -> None:
    """Protects: a server that goes on beating for an operator who is gone hides nothing from the vehicle."""
    beat = keys.heartbeat("ts100")
    with light_node(endpoint, "realtime", "", str(with_failsafe(tmp_path, reaction, "holder_lost"))):
        bus.until_alive()
        assert bus.start().accepted
        bus.session.put(beat, pb.Heartbeat(in_control=True).SerializeToString())

        def acted() -> list[pb.Event]:
            bus.session.put(beat, pb.Heartbeat(in_control=False).SerializeToString())
            return [e for e in bus.of("event") if e.code == "failsafe"]

        (event,) = bus.until(acted)
        assert event.details["cause"] == "holder_lost" and event.details["reaction"] == reaction
        bus.until(lambda: bus.of("tlm/mission")[-1].phase == phase)


def test_the_console_and_who_holds_control_are_lost_each_by_itself() -> None:
    """Protects: a console without a holder, and bytes that nobody understands, are still a console."""
    now = Now()
    heart = Heartbeat(Failsafe(heartbeat_lost_s=2.0, holder_lost_s=1.0, holder_lost="wave_off"), now)
    said = {True: pb.Heartbeat(in_control=True), False: pb.Heartbeat()}

    def fly(payload: bytes, seconds: float) -> list[tuple[str, str]]:
        found = []
        for _ in range(round(4 * seconds)):
            now.s += 0.25
            heart.beat(payload)
            found += [(cause, reaction) for cause, _, reaction in heart.lost(RUNNING)]
        return found

    assert fly(said[False].SerializeToString(), 60.0) == []  # nobody ever held control
    assert fly(said[True].SerializeToString(), 60.0) == []
    assert fly(b"\xff\xff", 60.0) == [("holder_lost", "wave_off")]
    assert fly(said[True].SerializeToString(), 5.0) == []
    lost = []
    for _ in range(40):
        now.s += 0.25
        lost += [cause for cause, _, _ in heart.lost(RUNNING)]
    assert lost == ["holder_lost", "heartbeat_lost"]


def test_who_left_before_a_mission_has_not_left_it() -> None:
    """Protects: a mission that another program begins is not held for somebody who watched yesterday."""
    now = Now()
    one = Presence(2.0, now)
    one.seen()
    assert now.pass_by(one, 60.0, IDLE) == [] and now.pass_by(one, 60.0) == []
    one.seen()
    assert now.pass_by(one, 60.0) == [2.0]


def test_it_acts_once_and_only_in_a_mission_that_somebody_watched() -> None:
    """Protects against a reaction on the bench, and against one that comes back as often as it is undone."""
    now = Now()
    heart = Presence(2.0, now)
    assert now.pass_by(heart, 60.0) == []  # nobody ever watched
    heart.seen()
    assert now.pass_by(heart, 60.0, IDLE) == []
    heart.seen()
    assert now.pass_by(heart, 1.5) == [] and now.pass_by(heart, 60.0) == [2.0]
    heart.seen()
    assert now.pass_by(heart, 60.0) == [2.0]
    never = Presence(0.0, now)
    never.seen()
    assert now.pass_by(never, 60.0) == []


def test_standing_still_oneself_is_no_silence_of_others() -> None:
    """Protects: a node that was frozen finds the beats of meanwhile in its queue a moment later."""
    now = Now()
    heart = Presence(2.0, now)
    heart.seen()
    now.s += OWN_FREEZE_S + 100.0
    assert heart.lost_s(RUNNING) is None and now.pass_by(heart, 1.5) == []


def test_a_reaction_that_nobody_knows_is_refused(tmp_path: Path) -> None:
    """Protects: a failsafe that is misspelt must not be one that does nothing."""
    with pytest.raises(VehicleError, match="failsafe"):
        load_vehicle(str(with_failsafe(tmp_path, "hope")))
