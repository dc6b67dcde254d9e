"""A vehicle whose console falls silent in a mission does what its file declares, and says so."""

from pathlib import Path

import pytest

from bumpless.config.vehicle import VehicleError, load_vehicle
from bumpless.config.vehicle.failsafe import Failsafe
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.heartbeat import OWN_FREEZE_S, Heartbeat
from tests.node.listening import Listener, light_node

RUNNING, IDLE = pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_IDLE


class Now:
    """A clock that stands until it is moved."""

    def __init__(self) -> None:
        self.s = 100.0

    def __call__(self) -> float:
        return self.s

    def pass_by(self, heart: Heartbeat, seconds: float, phase: int = RUNNING) -> list[float]:
        """Look four times a second for so long; what was lost."""
        found = []
        for _ in range(round(4 * seconds)):
            self.s += 0.25
            found.append(heart.lost_s(phase))
        return [lost for lost in found if lost is not None]


def with_failsafe(folder: Path, reaction: str) -> Path:
    """A vehicle file like ts100's that acts after half a second of silence."""
    path = folder / "ts100.toml"
    table = f'\n[failsafe]\nheartbeat_lost_s = 0.5\nheartbeat_lost = "{reaction}"\n'
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
        bus.session.put(keys.heartbeat("ts100"), pb.Heartbeat(time_ns=1).SerializeToString())
        assert bus.start().accepted
        (event,) = bus.until(lambda: [e for e in bus.of("event") if e.code == "failsafe"])
        assert event.severity == pb.SEVERITY_ALARM and event.details["reaction"] == reaction
        bus.until(lambda: bus.of("tlm/mission")[-1].phase == phase)


def test_it_acts_once_and_only_in_a_mission_that_somebody_watched() -> None:
    """Protects against a reaction on the bench, and against one that comes back as often as it is undone."""
    now = Now()
    heart = Heartbeat(Failsafe(heartbeat_lost_s=2.0), now)
    assert now.pass_by(heart, 60.0) == []  # nobody ever watched
    heart.beat()
    assert now.pass_by(heart, 60.0, IDLE) == []
    heart.beat()
    assert now.pass_by(heart, 1.5) == [] and now.pass_by(heart, 60.0) == [2.0]
    heart.beat()
    assert now.pass_by(heart, 60.0) == [2.0]
    never = Heartbeat(Failsafe(), now)
    never.beat()
    assert now.pass_by(never, 60.0) == []


def test_standing_still_oneself_is_no_silence_of_others() -> None:
    """Protects: a node that was frozen finds the beats of meanwhile in its queue a moment later."""
    now = Now()
    heart = Heartbeat(Failsafe(heartbeat_lost_s=2.0), now)
    heart.beat()
    now.s += OWN_FREEZE_S + 100.0
    assert heart.lost_s(RUNNING) is None and now.pass_by(heart, 1.5) == []


def test_a_reaction_that_nobody_knows_is_refused(tmp_path: Path) -> None:
    """Protects: a failsafe that is misspelt must not be one that does nothing."""
    with pytest.raises(VehicleError, match="failsafe"):
        load_vehicle(str(with_failsafe(tmp_path, "hope")))
