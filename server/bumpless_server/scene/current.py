"""The current as the vehicle estimates it: an arrow below the vehicle, in NED, with speed and set."""

from math import atan2, degrees
from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import palette, pose

METRES_PER_MPS = 8.0
LONGEST_M = 2.5
FAINTEST_MPS = 0.005  # below this there is no direction to speak of
HEIGHT_M = 0.75


def current_text(velocity_ned_mps: np.ndarray) -> str:
    """Speed and the direction it flows to, as navigators write it."""
    speed = float(np.hypot(velocity_ned_mps[0], velocity_ned_mps[1]))
    if speed < FAINTEST_MPS:
        return ""
    towards = degrees(atan2(velocity_ned_mps[1], velocity_ned_mps[0])) % 360.0
    return f"current est. {speed:.2f} m/s to {towards:03.0f}°"


class CurrentView:
    """Draws Navigation.current_estimate_ned_mps below the vehicle."""

    def __init__(self, scene: Any) -> None:
        self.arrow = scene.add_arrows(
            "/view/near/current",
            np.array([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]]),
            palette.CURRENT,
            shaft_radius=0.02,
            head_radius=0.065,
            head_length=0.2,
            visible=False,
        )
        self.label = scene.add_label(
            "/view/near/current_label", "", font_screen_scale=0.8, anchor="top-center", visible=False
        )

    def show(self, navigation: pb.Navigation, live: bool) -> None:
        """Arrow through the point under the vehicle; hidden when negligible or when telemetry is not live."""
        velocity = pose.vector(navigation.current_estimate_ned_mps)
        velocity[2] = 0.0
        text = current_text(velocity) if live else ""
        self.arrow.visible = self.label.visible = bool(text)
        if not text:
            return
        length = min(float(np.linalg.norm(velocity)) * METRES_PER_MPS, LONGEST_M)
        half = velocity / np.linalg.norm(velocity) * max(length, 0.25) / 2.0
        under = np.array([0.0, 0.0, HEIGHT_M])
        self.arrow.points = np.array([[under - half, under + half]])
        self.label.position = under + [0.0, 0.0, 0.12]
        self.label.text = text
