"""The target in the scene: where a mission puts it, and nowhere without one."""

from collections.abc import Iterator

import pytest
import viser

from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.sample import Sample
from bumpless_server.live.state import State
from bumpless_server.scene.picture import Picture
from bumpless_server.scene.trail import Track


class NoSets:
    """Attainable sets that are not ready yet."""

    def vehicle(self, _vehicle: object) -> None:
        pass

    def near(self, _speed: float, _now: float) -> None:
        return None


@pytest.fixture
def server() -> Iterator[viser.ViserServer]:
    running = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield running
    running.stop()


def test_no_target_is_drawn_before_a_run_or_for_a_vehicle_that_forgot_it(server: viser.ViserServer) -> None:
    """Protects: a vehicle without a run tells a target at the origin, which was drawn around itself."""
    state = State("ts100")
    picture = Picture(state, server, Track(), NoSets(), load_vehicle, light=True)  # type: ignore[arg-type]

    def see(run_id: str, north_m: float) -> bool:
        for topic, message in (
            ("mission", pb.MissionStatus(run_id=run_id)),
            ("target", pb.Target(position_ned_m=pb.Vector3(x=north_m))),
        ):
            payload = message.SerializeToString()
            state.feed(Sample(f"tlm/{topic}", message.DESCRIPTOR.full_name, payload))
        picture.update()
        return bool(picture.target.frame.visible)

    assert not see("", 0.0)
    assert see("run-1", 26.0) and picture.target.frame.position[0] == 26.0
    assert not see("", 0.0)
