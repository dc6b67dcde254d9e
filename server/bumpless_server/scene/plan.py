"""The planned path: constant-shape line segments and waypoint marks in NED."""

from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import palette
from bumpless_server.scene.water import WORLD

LONGEST = 256  # points drawn; a longer path is thinned


def path_points(plan: pb.Plan) -> np.ndarray:
    """The plan's points (n, 3) NED in m, at most LONGEST, ends kept."""
    points = np.array([[p.x, p.y, p.z] for p in plan.path_ned_m], np.float32).reshape(-1, 3)
    points = points[np.isfinite(points).all(axis=1)]
    if len(points) > LONGEST:
        points = points[np.round(np.linspace(0, len(points) - 1, LONGEST)).astype(int)]
    return points


class PlanView:
    """Draws the path of the mission that is loaded."""

    def __init__(self, scene: Any) -> None:
        self._shown = b""
        self.points = np.zeros((0, 3), np.float32)
        self.line = scene.add_line_segments(
            f"{WORLD}/plan/line",
            np.zeros((LONGEST - 1, 2, 3)),
            palette.PATH,
            thickness=2.0,
            thickness_units="screen",
            visible=False,
        )
        self.marks = scene.add_point_cloud(
            f"{WORLD}/plan/marks",
            np.zeros((LONGEST, 3)),
            palette.PATH,
            point_size=0.045,
            point_shape="circle",
            point_shading="flat",
            precision="float32",
            visible=False,
        )

    def show(self, plan: pb.Plan) -> bool:
        """Draw the path if it is another one than before; True when it changed."""
        points = path_points(plan)
        key = points.tobytes()
        if key == self._shown:
            return False
        self._shown, self.points = key, points
        visible = len(points) > 1
        if visible:
            order = np.minimum(np.arange(LONGEST), len(points) - 1)
            self.line.points = np.stack([points[order[:-1]], points[order[1:]]], axis=1)
            self.marks.points = points[order]
        self.line.visible = self.marks.visible = visible
        return True
