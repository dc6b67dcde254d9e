"""The vehicle in the scene: nodes built once from its parts, then only turned and recoloured."""

from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import palette, pose
from bumpless_server.scene.model import parts_of
from bumpless_server.scene.palette import Rgb
from bumpless_server.scene.part import Part, joint_angle, spin_step

ROOT = "/view/vehicle"
COLOURS: dict[str, Rgb] = {
    "hull": palette.HULL,
    "accent": palette.IDLE,
    "frame": palette.FRAME,
    "fin": palette.FIN,
    "propeller": palette.PROPELLER,
}
STALE_OPACITY = 0.45
LONGEST_STEP_S = 0.2  # a pause in telemetry must not spin the screws on


class VehicleView:
    """Draws one vehicle. Its frame sits at the origin of the view: the world moves, see `live`."""

    def __init__(self, scene: Any, vehicle: Any, light: bool = False) -> None:
        self._scene = scene
        self.parts: tuple[Part, ...] = parts_of(vehicle, 20 if light else 40)
        self.frame = scene.add_frame(ROOT, show_axes=False)
        at = {"": (0.0, 0.0, 0.0)} | {part.name: part.position for part in self.parts}
        self.nodes = {
            part.name: scene.add_mesh_simple(
                "/".join((ROOT, *filter(None, (part.carrier, part.name)))),
                *part.mesh,
                color=COLOURS[part.role],
                side="double",
                flat_shading=part.role in ("frame", "fin", "propeller"),
                position=np.subtract(part.position, at[part.carrier]),
                cast_shadow=False,
                receive_shadow=False,
            )
            for part in self.parts
        }
        self._angle = {part.name: 0.0 for part in self.parts}
        self._time_s: float | None = None
        self._look: tuple[int, bool] | None = None

    def remove(self) -> None:
        """Take the vehicle out of the scene."""
        self.frame.remove()

    def turn(self, attitude: pb.Attitude) -> None:
        """Body attitude against NED."""
        self.frame.wxyz = pose.of_attitude(attitude)

    def move_actuators(self, actuators: pb.Actuators) -> None:
        """Fins and pods to their measured angle, screws onward by their measured speed."""
        now = actuators.stamp.time_ns * 1e-9
        dt = 0.0 if self._time_s is None else min(max(now - self._time_s, 0.0), LONGEST_STEP_S)
        self._time_s = now
        for part in self.parts:
            if part.axis is None or part.command >= len(actuators.actuators):
                continue
            feedback = actuators.actuators[part.command].feedback
            if part.motion == "turn":
                angle = joint_angle(feedback)
            else:
                angle = self._angle[part.name] + spin_step(feedback, dt)
            if angle != self._angle[part.name]:
                self._angle[part.name] = angle
                self.nodes[part.name].wxyz = pose.about(part.axis, angle)

    def angle(self, name: str) -> float:
        """Present drawn angle of a part, rad."""
        return self._angle[name]

    def show(self, mode: int, live: bool) -> None:
        """Mode colour on the bands; all grey and see-through when what we know is not live."""
        if self._look == (mode, live):
            return
        self._look = (mode, live)
        for part in self.parts:
            colour = palette.mode_colour(mode) if part.role == "accent" else COLOURS[part.role]
            node = self.nodes[part.name]
            node.color = colour if live else palette.STALE
            node.opacity = None if live else STALE_OPACITY
