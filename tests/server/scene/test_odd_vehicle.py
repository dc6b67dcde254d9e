"""The scene draws nothing that is no place in space, and no hull that is not the vehicle's."""

import math

from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene.finite import Finite
from tests.server.scene.harness import serve


class _Told:
    """A state that says what a test tells it."""

    link = pb.LINK_STATE_LIVE

    def __init__(self) -> None:
        self.message: pb.Navigation | None = None

    def latest(self, topic: str) -> pb.Navigation | None:
        return self.message


def test_a_message_with_an_infinity_is_not_drawn() -> None:
    """Protects: one `inf` ended the scene; the last good message stays until the next one."""
    state = _Told()
    shown = Finite(state)
    assert shown.latest("navigation") is None
    state.message = pb.Navigation(depth_m=math.inf)
    assert shown.latest("navigation") is None
    state.message = good = pb.Navigation(depth_m=2.0)
    assert shown.latest("navigation") is good
    state.message = pb.Navigation(position_ned_m=pb.Vector3(x=math.nan))
    assert shown.latest("navigation") is good
    assert shown.link == pb.LINK_STATE_LIVE


def test_a_vehicle_whose_file_cannot_be_read_has_no_hull() -> None:
    """Protects: it kept the hull of the vehicle before it."""
    with serve() as served:
        stamp = pb.Stamp(time_ns=1)
        text = load_vehicle("ts100").text
        served.tell("description", pb.VehicleDescription(stamp=stamp, vehicle_toml=text, sha256="1"))
        served.scene.live.stop()  # the picture is ours alone
        picture = served.scene.live.picture or served.scene.live._make_picture()
        picture.update()
        assert picture.vehicle is not None
        served.tell("description", pb.VehicleDescription(stamp=stamp, vehicle_toml="no toml", sha256="2"))
        picture.update()
        assert picture.vehicle is None
