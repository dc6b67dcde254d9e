"""The docking target with its approach heading, the observation point, and the ranges at which modes switch.

Ranges are measured to the observation point (Supervisor.range_m), so the circles stand around it.
"""

from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import mesh, palette, pose
from bumpless_server.scene.water import WORLD

ROOT = f"{WORLD}/target"
DETAIL = f"{WORLD}/near/observation"  # labels that only close views show, see `cameras`
RINGS = (("fr", "range_fr_lower_m", "F→R", palette.REVERSE), ("rh", "range_rh_lower_m", "R→H", palette.HOVER))


def dock_mesh() -> mesh.Mesh:
    """A docking frame 1.1 m wide: entrance ring facing back along the approach, board with code, struts."""
    ring = mesh.duct(0.55, 0.08, 32)
    board = mesh.box((0.04, 0.5, 0.5), (0.9, 0.0, 0.0))
    struts = []
    for angle in np.arange(4) * np.pi / 2.0 + np.pi / 4.0:
        y, z = 0.5 * np.cos(angle), 0.5 * np.sin(angle)
        struts.append(mesh.rod((0.0, y, z), (0.9, 0.45 * y, 0.45 * z), 0.022, 8))
    return mesh.merge(ring, board, *struts)


class TargetView:
    """Draws a Target message and the supervisor's thresholds."""

    def __init__(self, scene: Any) -> None:
        self.frame = scene.add_frame(ROOT, show_axes=False, visible=False)
        vertices, faces = dock_mesh()
        self.dock = scene.add_mesh_simple(
            f"{ROOT}/dock",
            vertices,
            faces,
            color=palette.TARGET,
            side="double",
            flat_shading=True,
            cast_shadow=False,
            receive_shadow=False,
        )
        self.approach = scene.add_arrows(
            f"{ROOT}/approach",
            np.array([[[-2.2, 0.0, 0.0], [-0.7, 0.0, 0.0]]]),
            palette.TARGET,
            shaft_radius=0.014,
            head_radius=0.05,
            head_length=0.16,
        )
        self.label = scene.add_label(
            f"{ROOT}/label",
            "target",
            position=(0.5, 0.0, 0.7),
            anchor="top-center",
            font_screen_scale=0.9,
        )
        self.point = scene.add_frame(f"{WORLD}/observation", show_axes=False, visible=False)
        cross = np.array(
            [[[-0.3, 0, 0], [0.3, 0, 0]], [[0, -0.3, 0], [0, 0.3, 0]], [[0, 0, -0.3], [0, 0, 0.3]]]
        )
        scene.add_line_segments(
            f"{WORLD}/observation/cross", cross, palette.HOVER, thickness=2.5, thickness_units="screen"
        )
        scene.add_label(
            f"{DETAIL}/label",
            "observation point",
            position=(0.0, 0.0, 0.45),
            anchor="top-center",
            font_screen_scale=0.8,
        )
        self.detail = scene.add_frame(DETAIL, show_axes=False, visible=False)
        self.rings: dict[str, Any] = {}
        self.ring_labels: dict[str, Any] = {}
        self._radius: dict[str, float] = {}
        self._known = True
        for name, _, _, colour in RINGS:
            ring = f"{WORLD}/observation/ring_{name}"
            self.rings[name] = scene.add_line_segments(
                ring, mesh.circle(1.0), colour, thickness=2.0, thickness_units="screen", visible=False
            )
            self.ring_labels[name] = scene.add_label(
                f"{DETAIL}/ring_{name}" if name == "rh" else f"{ring}_label",
                "",
                anchor="center-center",
                font_screen_scale=0.8,
                visible=False,
            )

    def show(self, target: pb.Target) -> None:
        """Place target and observation point."""
        self.frame.position = pose.vector(target.position_ned_m)
        self.frame.wxyz = pose.of_heading(target.heading_deg)
        self.point.position = self.detail.position = pose.vector(target.observation_point_ned_m)
        self.frame.visible = self.point.visible = self.detail.visible = True

    def hide(self) -> None:
        """No mission, no target."""
        self.frame.visible = self.point.visible = self.detail.visible = False

    def name(self, target: pb.Target, live: bool, known: bool = True, holds: str = "") -> None:
        """Approach heading and, while that is known, whether the camera sees the target.

        known: False when nothing keeps the target's place up to date, as after an abort.
        holds: whether its heading holds station, in words; "" where that is not known.
        """
        words = f"target {target.heading_deg % 360.0:03.0f}°"
        if self._known != known:
            self._known = known
            self.dock.color = palette.TARGET if known else palette.STALE
            self.dock.opacity = None if known else 0.3
        if not known:
            words += " · last known place"
        elif live:
            words += " · detected" if target.detected else " · not detected"
            words += f" · {holds}" if holds else ""
        self.label.text = words

    def thresholds(self, supervisor: pb.Supervisor) -> None:
        """Circles at d_FR^L and d_RH^L. Source: Gao et al. 2026, eq. (53)."""
        for name, field, text, _ in RINGS:
            radius = float(getattr(supervisor, field))
            if self._radius.get(name) == radius:
                continue
            self._radius[name] = radius
            shown = bool(np.isfinite(radius) and radius > 0.0)
            self.rings[name].visible = self.ring_labels[name].visible = shown
            if shown:
                self.rings[name].scale = (radius, radius, 1.0)
                self.ring_labels[name].position = (-radius * 0.7071, radius * 0.7071, 0.0)
                self.ring_labels[name].text = f"{text} {radius:g} m"
