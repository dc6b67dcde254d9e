"""The ring of headings that hold station, in space: by the one rule, asked for rarely, and never stale."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.foresight.told import HeldArc, HeldStation
from bumpless_server.scene import palette
from bumpless_server.scene.held_ring import RADIUS_M, STEP_MPS, HeldView, HeldWatch, ring

HELD = HeldStation(
    current_ned_mps=[-0.1, 0.0, 0.0],
    arcs=[
        HeldArc(zone="accepted", from_deg=350.0, to_deg=30.0),
        HeldArc(zone="warned", from_deg=31.0, to_deg=90.0),
        HeldArc(zone="refused", from_deg=91.0, to_deg=349.0),
    ],
    heading_deg=0.0,
    zone="accepted",
    reason="",
)


def drawn(colour: palette.Rgb) -> np.ndarray:
    """Both ends of the segments in that colour which are not points, (n, 2, 3)."""
    points, colours = ring(HELD)
    inked = (colours[:, 0] == palette.vertex_colour(colour)).all(axis=1)
    long = np.linalg.norm(points[:, 0] - points[:, 1], axis=1) > 1e-6
    return points[inked & long]


def heading_of(points: np.ndarray) -> np.ndarray:
    """The heading whose hull lies there, deg."""
    return np.degrees(np.arctan2(points[:, 1], points[:, 0])) + 180.0


def test_a_heading_stands_where_the_hull_lies_with_it_and_each_zone_has_a_shape() -> None:
    """Protects: told by colour alone, or drawn on the far side of the dock."""
    middles = drawn(palette.HOLDS).mean(axis=1)
    assert (middles[:, 0] < 0.0).all()  # headings about north: south of the dock
    assert np.ptp(np.round(np.linalg.norm(middles, axis=1), 2)) > 0.0  # double
    refused = drawn(palette.CANT_HOLD)
    assert (np.linalg.norm(refused, axis=2).max(axis=1) > RADIUS_M * 1.01).any()  # teeth
    warned = np.unique(np.round(heading_of(drawn(palette.MAY_NOT_HOLD)[:, 0]) % 360.0))
    assert 0.4 < 2.0 * len(warned) / 60.0 < 0.7 and ((warned >= 30.0) & (warned <= 91.0)).all()  # broken


class Bus:
    """What a vehicle said."""

    def __init__(self) -> None:
        self.link = pb.LINK_STATE_LIVE
        self.said: dict[str, Any] = {
            "navigation": pb.Navigation(),
            "target": pb.Target(heading_deg=0.0),
            "mission": pb.MissionStatus(run_id="run", phase=pb.MISSION_PHASE_RUNNING),
        }

    def latest(self, topic: str) -> Any:
        return self.said.get(topic)


def test_it_is_asked_for_on_change_alone_and_not_at_each_picture() -> None:
    """Protects the scene's thread: the rule takes milliseconds, and a picture comes every 40."""
    bus, asked = Bus(), []
    watch = HeldWatch(bus, lambda: asked.append(1) or HELD)
    for k in range(100):
        assert watch.now(0.04 * k) is HELD
    assert len(asked) == 1
    bus.said["navigation"].current_estimate_ned_mps.x = 3.0 * STEP_MPS
    assert watch.now(4.1) is HELD and len(asked) == 2
    bus.said["target"].heading_deg = 90.0
    assert watch.now(4.2) is HELD and len(asked) == 2  # soon enough
    assert watch.now(6.0) is HELD and len(asked) == 3


@pytest.mark.parametrize("lost", ["link", "phase", "target"])
def test_what_is_stale_or_over_is_not_drawn(lost: str) -> None:
    """Protects from a ring of a flight that is over, or of a vehicle that is not heard."""
    bus = Bus()
    watch = HeldWatch(bus, lambda: HELD)
    node = SimpleNamespace(visible=False, position=np.zeros(3))
    view = HeldView(SimpleNamespace(add_line_segments=lambda *_, **__: node))
    view.show(watch.now(0.0), np.array([26.0, 0.0, 2.3]))
    assert node.visible and tuple(node.position) == (26.0, 0.0, 2.3)
    if lost == "link":
        bus.link = pb.LINK_STATE_STALE
    elif lost == "phase":
        bus.said["mission"].phase = pb.MISSION_PHASE_ABORTED
    else:
        del bus.said["target"]
    view.show(watch.now(0.1), np.array([26.0, 0.0, 2.3]))
    assert not node.visible
