"""What the actuators can do now: the attainable force and moment sets with tau_d and tau_c inside.

Two insets in body axes above the vehicle: forces to the right of it, moments to the left, as seen from
starboard. Each has its own scale, written on its axes, that moves in steps of 1-2-5.
Source: Gao et al. 2026, eqs. (37)-(40).
"""

from math import ceil, floor, log10
from typing import Any

import numpy as np

from bumpless_server.scene import palette
from bumpless_server.scene.hull_mesh import FACES, VERTICES, HullMesh

AXIS_M = 0.8  # drawn length of full scale
OVERSHOOT = 1.3  # an arrow beyond full scale is cut here


def full_scale(extent: float, present: float) -> float:
    """A round number (1, 2 or 5 times a power of ten) that holds `extent`; keeps `present` while it suits."""
    if extent <= present and extent > 0.3 * present:
        return present
    wanted = max(extent * 1.05, 0.1)
    power = 10.0 ** floor(log10(wanted))
    mantissa = next(m for m in (1.0, 2.0, 5.0, 10.0) if m >= ceil(wanted / power * 1e6) / 1e6 or m == 10.0)
    return mantissa * power


def clipped(vector: np.ndarray, scale: float) -> np.ndarray:
    """A wrench's half (3,) as a drawn vector in m, cut at OVERSHOOT times full scale."""
    drawn = np.nan_to_num(vector) * AXIS_M / scale
    length = float(np.linalg.norm(drawn))
    return drawn * min(1.0, OVERSHOOT * AXIS_M / length) if length > 0.0 else drawn


class SetView:
    """One inset: hull, axes, arrows."""

    def __init__(self, scene: Any, name: str, title: str, axes: str, unit: str, colour: palette.Rgb) -> None:
        self.root, self.axes, self.unit, self.title = f"/view/near/{name}", axes, unit, title
        self.scale = 0.0
        self.frame = scene.add_frame(self.root, show_axes=False, visible=False)
        self.hull = scene.add_mesh_simple(
            f"{self.root}/hull",
            np.zeros((VERTICES, 3)),
            np.zeros((FACES, 3), np.uint32),
            color=colour,
            opacity=0.26,
            side="double",
            flat_shading=True,
            cast_shadow=False,
            receive_shadow=False,
        )
        lines = np.array([[-AXIS_M * e, AXIS_M * e] for e in np.eye(3)])
        self.lines = scene.add_line_segments(
            f"{self.root}/axes", lines, palette.GRID_SECTION, thickness=1.0, thickness_units="screen"
        )
        self.labels = [
            scene.add_label(
                f"{self.root}/axis_{k}",
                axes[k],
                position=np.eye(3)[k] * AXIS_M * 1.06,
                font_screen_scale=0.8,
                anchor="center-center",
            )
            for k in range(3)
        ]
        self.heading = scene.add_label(
            f"{self.root}/title",
            title,
            position=(0.0, 0.0, -AXIS_M * 1.12),
            font_screen_scale=0.9,
            anchor="bottom-center",
        )
        self.achieved = self._arrow(scene, "achieved", palette.ACHIEVED, 0.016, 0.04, 0.1)
        self.demanded = self._arrow(scene, "demanded", palette.DEMANDED, 0.008, 0.032, 0.13)
        self.residual = scene.add_line_segments(
            f"{self.root}/residual",
            np.zeros((1, 2, 3)),
            palette.RESIDUAL,
            thickness=2.5,
            thickness_units="screen",
        )

    def _arrow(
        self, scene: Any, name: str, colour: palette.Rgb, shaft: float, head: float, length: float
    ) -> Any:
        return scene.add_arrows(
            f"{self.root}/{name}",
            np.zeros((1, 2, 3)),
            colour,
            shaft_radius=shaft,
            head_radius=head,
            head_length=length,
            visible=False,
        )

    def show_set(self, hull: HullMesh, title: str) -> None:
        """The set, in N or N m."""
        scale = full_scale(hull.extent, self.scale)
        if scale != self.scale:
            self.scale = scale
            self.hull.scale = AXIS_M / scale
            for label, axis in zip(self.labels, self.axes, strict=True):
                label.text = f"{axis} {scale:g} {self.unit}"
        self.hull.vertices, self.hull.faces = hull.vertices, hull.faces
        self.heading.text = title
        self.frame.visible = True

    def show_wrench(self, demanded: np.ndarray, achieved: np.ndarray) -> None:
        """Arrows of tau_d and tau_c (3,), N or N m, and the residual between their tips."""
        if self.scale == 0.0:
            return
        d, c = clipped(demanded, self.scale), clipped(achieved, self.scale)
        for node, tip in ((self.demanded, d), (self.achieved, c)):
            visible = bool(np.linalg.norm(tip) > 0.01)
            if visible:
                node.points = np.array([[np.zeros(3), tip]])
            node.visible = visible
        self.residual.points = np.array([[c, d]])

    def place(self, position: np.ndarray, wxyz: tuple[float, float, float, float]) -> None:
        """Where the inset stands and how body axes are turned."""
        self.frame.position, self.frame.wxyz = position, wxyz

    def show_live(self, live: bool, colour: palette.Rgb) -> None:
        """Grey when what it shows is not live."""
        self.hull.color = colour if live else palette.STALE
        if not live:
            self.demanded.visible = self.achieved.visible = False
            self.residual.points = np.zeros((1, 2, 3))
