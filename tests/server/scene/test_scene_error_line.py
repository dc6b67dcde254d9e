"""The line from the vehicle to its reference, and the words at it."""

import numpy as np
import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene.error_line import error_text, reference_from

PATH = np.array([[0.0, 0.0, 3.0], [20.0, 0.0, 3.0], [20.0, 20.0, 3.0]])
POINT = np.array([20.0, 18.0, 3.0])
RUNNING = pb.MISSION_PHASE_RUNNING


def _supervisor(**said: object) -> pb.Supervisor:
    return pb.Supervisor(**{"phase": RUNNING, "flown": pb.MODE_FORWARD} | said)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("leg", "across", "level"),
    [
        (0, 0.5, (0.0, -0.5)),  # northwards, east of the line: the line lies to the west
        (1, 0.5, (0.5, 0.0)),  # eastwards, to starboard is south: the line lies to the north
        (2, 0.5, (-0.5, 0.0)),  # back from the observation point, westwards
    ],
)
def test_the_line_leads_to_the_leg_the_vehicle_follows(
    leg: int, across: float, level: tuple[float, float]
) -> None:
    """Protects the side: an error line to the wrong side of the path is worse than none."""
    guidance = pb.Guidance(leg=leg, leg_count=2, cross_track_error_m=across, depth_reference_m=3.2)
    offset = reference_from(guidance, _supervisor(), 3.0, PATH, POINT)
    assert offset is not None
    np.testing.assert_allclose(offset, [*level, 0.2], atol=1e-9)


def test_a_vehicle_that_stays_is_measured_to_its_station() -> None:
    """In H both errors count: the station is a point, not a line."""
    guidance = pb.Guidance(cross_track_error_m=0.3, along_track_error_m=0.4, depth_reference_m=3.0)
    supervisor = _supervisor(flown=pb.MODE_HOVER, approach_heading_deg=90.0)
    offset = reference_from(guidance, supervisor, 3.0, PATH, POINT)
    assert offset is not None
    np.testing.assert_allclose(offset, [0.3, 0.4, 0.0], atol=1e-9)


def test_the_approach_line_counts_while_docking() -> None:
    """On the approach the legs no longer count, the approach heading in use does."""
    guidance = pb.Guidance(leg=0, cross_track_error_m=0.3, along_track_error_m=5.0, depth_reference_m=3.0)
    supervisor = _supervisor(docking_stage=pb.DOCKING_STAGE_APPROACH, approach_heading_deg=90.0)
    offset = reference_from(guidance, supervisor, 3.0, PATH, POINT)
    assert offset is not None
    np.testing.assert_allclose(offset, [0.3, 0.0, 0.0], atol=1e-9)


@pytest.mark.parametrize(
    "supervisor",
    [
        _supervisor(phase=pb.MISSION_PHASE_ABORTED),
        _supervisor(phase=pb.MISSION_PHASE_PAUSED, flown=pb.MODE_HOVER),
        _supervisor(docking_stage=pb.DOCKING_STAGE_CAPTURED),
        _supervisor(docking_stage=pb.DOCKING_STAGE_ENTRY),
    ],
)
def test_no_line_where_nobody_says_what_is_followed(supervisor: pb.Supervisor) -> None:
    """Protects from a guess: a braked vehicle holds a place that it does not tell."""
    guidance = pb.Guidance(cross_track_error_m=0.3, depth_reference_m=3.0)
    assert reference_from(guidance, supervisor, 3.0, PATH, POINT) is None
    assert reference_from(guidance, _supervisor(), 3.0, PATH[:1], None) is None


def test_words_name_the_direction_in_depth_and_leave_out_what_is_small() -> None:
    """A reference above the vehicle means that it is too deep."""
    assert error_text(np.array([0.3, 0.4, -0.2])) == "0.50 m off · 0.20 m too deep"
    assert error_text(np.array([0.0, 0.01, 0.3])) == "0.30 m too shallow"
    assert error_text(np.array([0.02, 0.01, 0.03])) == ""
