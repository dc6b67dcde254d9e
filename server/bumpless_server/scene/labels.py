"""Labels that do not lie over each other: in each browser the less important one of two makes way.

A label hangs in a frame of its own, which each browser's own scene can hide; so what one operator's camera
brings together is hidden for that operator alone.
"""

from dataclasses import dataclass
from math import tan
from typing import Any

import numpy as np

EM_PX = 12.0  # viser's: an em at scale 1, in a picture of any height
WIDTH_EM, HEIGHT_EM = 0.56, 1.4  # of a letter, of a line with its ground
APART_PX = 4.0  # a hidden label comes back once this much clear
RULER = "/view/ruler_label"  # each browser's own, and asked for: it never makes way
# What matters first. A label whose name holds none of these comes last.
RANKS = (RULER, "status", "target/", "error", "observation", "ring_", "current", "title", "axis_", "plane")


@dataclass(frozen=True)
class Box:
    """A label's place on the screen, px from the middle."""

    left: float
    top: float
    width: float
    height: float

    def hits(self, other: "Box", apart: float = 0.0) -> bool:
        """Whether the two lie over each other, or nearer than `apart`."""
        return (
            self.left < other.left + other.width + apart
            and other.left < self.left + self.width + apart
            and self.top < other.top + other.height + apart
            and other.top < self.top + self.height + apart
        )


def rank(name: str) -> int:
    """Place in the order of what matters."""
    return next((k for k, part in enumerate(RANKS) if part in name), len(RANKS))


def spread(boxes: dict[str, Box], hidden: set[str]) -> set[str]:
    """Names of the labels that make way. `hidden`: those that did before, which wait for room to spare."""
    kept: list[Box] = []
    away: set[str] = set()
    for name in sorted(boxes, key=lambda one: (rank(one), one)):
        box, apart = boxes[name], APART_PX if name in hidden else 0.0
        if any(box.hits(other, apart) for other in kept):
            away.add(name)
        else:
            kept.append(box)
    return away


class Labelled:
    """A scene whose labels each get a frame of their own, and are known here."""

    def __init__(self, scene: Any) -> None:
        self._scene = scene
        self.labels: dict[str, Any] = {}  # by the frame that holds it

    def add_label(self, name: str, text: str, **look: Any) -> Any:
        """As viser's."""
        label = self._scene.add_label(f"{name}_slot/text", text, **look)
        self.labels[f"{name}_slot"] = label
        return label

    def __getattr__(self, name: str) -> Any:
        return getattr(self._scene, name)

    def places(self) -> dict[str, np.ndarray]:
        """Where each label that is seen and says something stands, in the view's frame, m."""
        return {
            name: at
            for name, label in self.labels.items()
            if label.text and (at := self._place(label)) is not None
        }

    def _place(self, label: Any) -> np.ndarray | None:
        """Through all frames that hold it, but for the view itself, which is each browser's own."""
        if not label.visible:
            return None
        at = np.asarray(label.position, float)
        parts = label.name.split("/")[:-1]
        while len(parts) > 2:
            frame = self._scene.get_handle_by_name("/".join(parts))
            parts.pop()
            if frame is None:
                continue
            if not frame.visible:
                return None
            at = turned_by(frame.wxyz, at) + np.asarray(frame.position)
        return at


def turned_by(wxyz: Any, vector: np.ndarray) -> np.ndarray:
    """A vector turned by a unit quaternion."""
    w, xyz = float(wxyz[0]), np.asarray(wxyz[1:], float)
    return vector + 2.0 * np.cross(xyz, np.cross(xyz, vector) + w * vector)


def box_of(label: Any, at: np.ndarray, camera: Any) -> Box | None:
    """Where a label that stands at `at` (world, m) is seen; None behind the camera or beside the picture."""
    w, x, y, z = (float(v) for v in camera.wxyz)
    right, down, ahead = turned_by((w, -x, -y, -z), at - np.asarray(camera.position, float))
    if ahead <= 0.05:
        return None
    height = float(camera.image_height)
    focal = 0.5 * height / tan(0.5 * float(camera.fov))
    across, below = focal * right / ahead, focal * down / ahead
    if abs(below) > 0.6 * height or abs(across) > 0.6 * height * float(camera.aspect):
        return None
    em = EM_PX * label.font_screen_scale
    wide, tall = (0.6 + WIDTH_EM * len(label.text)) * em, HEIGHT_EM * em
    vertical, horizontal = label.anchor.split("-")
    left = across - {"left": 0.0, "center": 0.5, "right": 1.0}[horizontal] * wide
    top = below - {"top": 0.0, "center": 0.5, "bottom": 1.0}[vertical] * tall
    return Box(left, top, wide, tall)
