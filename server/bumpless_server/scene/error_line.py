"""From the vehicle to where it should be: on its leg, its approach line or at its station, at the told depth.

The vehicle tells its errors across and along, and the line they are measured from is that of its plan.
"""

from math import cos, radians, sin
from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import HOVER, RUNNING
from bumpless_server.scene import palette

LEAST_M = 0.05  # below this the line would be a dot in the hull
ON_THE_LINE = (
    pb.DOCKING_STAGE_APPROACH,
    pb.DOCKING_STAGE_BACK,
    pb.DOCKING_STAGE_HOLD,
    pb.DOCKING_STAGE_CREEP,
)
ON_LEGS = (pb.DOCKING_STAGE_UNSPECIFIED, pb.DOCKING_STAGE_TRANSIT)


def leg_course(leg: int, path: np.ndarray, observation: np.ndarray | None) -> float | None:
    """Direction of a leg, rad: the last one ends at the observation point, one more leads back from there."""
    last = len(path) - 2
    if last < 0 or (leg >= last and observation is None):
        return None
    if leg < last:
        start, end = path[leg], path[leg + 1]
    elif leg == last:
        start, end = path[last], observation
    else:
        start, end = observation, path[last]
    north, east = (np.asarray(end) - np.asarray(start))[:2]
    return float(np.arctan2(east, north)) if abs(north) + abs(east) > 0.05 else None


def reference_from(
    guidance: pb.Guidance,
    supervisor: pb.Supervisor,
    depth_m: float,
    path: np.ndarray,
    observation: np.ndarray | None,
) -> np.ndarray | None:
    """From the vehicle to its reference, NED in m; None while nothing says which line it follows."""
    if supervisor.phase != RUNNING:
        return None
    stage = supervisor.docking_stage
    stays = stage in ON_LEGS and supervisor.flown == HOVER
    if stage in ON_THE_LINE or stays:
        course = radians(supervisor.approach_heading_deg)
    elif stage in ON_LEGS:
        course = leg_course(guidance.leg, path, observation)
    else:
        return None
    if course is None:
        return None
    across, along = guidance.cross_track_error_m, guidance.along_track_error_m if stays else 0.0
    return np.array(
        [
            across * sin(course) + along * cos(course),
            -across * cos(course) + along * sin(course),
            guidance.depth_reference_m - depth_m,
        ]
    )


def error_text(offset: np.ndarray) -> str:
    """The error in words: sideways or level, and in depth."""
    level, down = float(np.hypot(offset[0], offset[1])), float(offset[2])
    words = [f"{level:.2f} m off"] if level >= LEAST_M else []
    if abs(down) >= LEAST_M:
        words.append(f"{abs(down):.2f} m too {'deep' if down < 0.0 else 'shallow'}")
    return " · ".join(words)


class ErrorView:
    """Draws the line and its length. The vehicle is the view's origin."""

    def __init__(self, scene: Any) -> None:
        self.line = scene.add_line_segments(
            "/view/error",
            np.zeros((1, 2, 3)),
            palette.RESIDUAL,
            thickness=2.5,
            thickness_units="screen",
            visible=False,
        )
        self.end = scene.add_icosphere(
            "/view/error_end", 0.045, color=palette.RESIDUAL, cast_shadow=False, visible=False
        )
        self.label = scene.add_label(
            "/view/near/error_label", "", font_screen_scale=0.8, anchor="center-left", visible=False
        )

    def show(self, offset: np.ndarray | None) -> None:
        """To an offset from the vehicle, NED in m; nothing where it is None or too small to see."""
        text = "" if offset is None else error_text(offset)
        if offset is not None and text:
            self.line.points = np.array([[np.zeros(3), offset]])
            self.end.position = tuple(float(v) for v in offset)
            self.label.position = tuple(float(v) for v in offset + [0.0, 0.0, 0.1])
            if self.label.text != text:
                self.label.text = text
        for node in (self.line, self.end, self.label):
            if node.visible != bool(text):
                node.visible = bool(text)
