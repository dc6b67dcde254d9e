"""The water around: NED frame, a reference plane under everything, and the vehicle's plumb line
from the surface down.

Nobody tells the console where the seabed is, so none is drawn: the plane is a measuring plane at a round
depth below vehicle, path and target, and its label says so.
"""

from math import ceil
from typing import Any

import numpy as np

from bumpless_server.scene import mesh, palette

WORLD = "/view/world"
AXIS_M = 3.0
CLEARANCE_M = 1.5


def plane_depth(*depths_m: float) -> float:
    """Depth of the reference plane: the next whole metre at least CLEARANCE_M below the deepest, m."""
    return float(ceil(max((d for d in depths_m if np.isfinite(d)), default=0.0) + CLEARANCE_M))


class WaterView:
    """Static surroundings in NED under WORLD; the plane sinks when something goes deeper."""

    def __init__(self, scene: Any) -> None:
        self.frame = scene.add_frame(WORLD, show_axes=False)
        self.depth_m = plane_depth(0.0)
        self.plane = scene.add_grid(
            f"{WORLD}/plane",
            width=200.0,
            height=200.0,
            plane="xy",
            infinite_grid=True,
            cell_size=1.0,
            section_size=5.0,
            cell_color=palette.GRID_CELL,
            section_color=palette.GRID_SECTION,
            cell_thickness=0.6,
            section_thickness=1.2,
            fade_distance=70.0,
            fade_strength=1.5,
            shadow_opacity=0.0,
            position=(0.0, 0.0, self.depth_m),
        )
        self.plane_label = scene.add_label(
            f"{WORLD}/plane_label",
            "",
            font_screen_scale=0.8,
            position=(0.0, 0.0, self.depth_m),
        )
        self.axes = scene.add_frame(f"{WORLD}/ned", show_axes=False)
        self._axis(scene, "N", (1.0, 0.0, 0.0), palette.AXIS_NORTH)
        self._axis(scene, "E", (0.0, 1.0, 0.0), palette.AXIS_EAST)
        self._axis(scene, "D", (0.0, 0.0, 1.0), palette.AXIS_DOWN)
        # a segment one metre down, stretched from the surface through the vehicle to the plane
        unit = np.array([[[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]])
        thin: dict[str, Any] = {"thickness": 1.0, "thickness_units": "screen"}
        self.plumb = scene.add_line_segments("/view/plumb", unit, palette.GRID_SECTION, **thin)
        self.foot = scene.add_line_segments("/view/foot", mesh.circle(0.3, 32), palette.GRID_SECTION, **thin)
        self.surface = scene.add_line_segments(
            "/view/near/surface",
            mesh.circle(0.2, 32),
            palette.AXIS_DOWN,
            thickness=2.0,
            thickness_units="screen",
        )
        scene.add_label(
            "/view/near/surface/label",
            "water surface",
            position=(0.0, 0.0, -0.08),
            font_screen_scale=0.8,
            anchor="bottom-center",
        )
        self.sink(self.depth_m)

    def _axis(self, scene: Any, name: str, along: tuple[float, float, float], colour: palette.Rgb) -> None:
        end = AXIS_M * np.asarray(along) * (0.5 if name == "D" else 1.0)
        scene.add_arrows(
            f"{WORLD}/ned/{name}",
            np.array([[[0.0, 0.0, 0.0], end]]),
            colour,
            shaft_radius=0.025,
            head_radius=0.08,
            head_length=0.24,
        )
        scene.add_label(f"{WORLD}/ned/{name}_label", name, position=end * 1.06, font_screen_scale=0.9)

    def sink(self, depth_m: float) -> None:
        """Move the reference plane to a depth, m."""
        self.depth_m = depth_m
        at = (0.0, 0.0, depth_m)
        self.plane.position = at
        self.axes.position = at
        self.plane_label.position = (AXIS_M + 0.6, 0.4, depth_m)
        self.plane_label.text = f"reference plane {depth_m:.0f} m deep · 1 m cells"

    def follow(self, position_ned_m: np.ndarray) -> None:
        """Bring the vehicle to the view's origin and hang its plumb line."""
        north, east, down = (float(v) for v in position_ned_m)
        self.frame.position = (-north, -east, -down)
        self.plumb.position = self.surface.position = (0.0, 0.0, -down)
        self.plumb.scale = (1.0, 1.0, self.depth_m)
        self.foot.position = (0.0, 0.0, self.depth_m - down)
