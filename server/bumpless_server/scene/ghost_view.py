"""Ghosts of flights ahead, as it is and with a draft: a dashed track, and a pale hull that flies along it."""

from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import palette, pose
from bumpless_server.scene.ghosts import Ghost, Ghosts
from bumpless_server.scene.model import parts_of
from bumpless_server.scene.palette import Rgb
from bumpless_server.scene.water import WORLD

DASHES = 120  # of a track
OPACITY = 0.32
LOOKS: dict[str, Rgb] = {"as_it_is": palette.STALE, "draft": palette.GHOST}


class GhostView:
    """Draws them. `update` is called with each picture."""

    def __init__(self, scene: Any, ghosts: Ghosts) -> None:
        self._scene, self._ghosts = scene, ghosts
        self._shown: dict[str, Ghost] = {}
        self._hulls: dict[str, list[Any]] = {name: [] for name in LOOKS}
        self.frames = {name: scene.add_frame(f"{WORLD}/ghost/{name}", show_axes=False, visible=False)
                       for name in LOOKS}  # fmt: skip
        self.lines = {
            name: scene.add_line_segments(
                f"{WORLD}/ghost_track/{name}",
                np.zeros((DASHES, 2, 3), np.float32),
                colour,
                thickness=2.5 if name == "draft" else 1.5,
                thickness_units="screen",
                visible=False,
            )
            for name, colour in LOOKS.items()
        }

    def describe(self, vehicle: Any) -> None:
        """Another vehicle: its hull, for each ghost."""
        for name, colour in LOOKS.items():
            for node in self._hulls[name]:
                node.remove()
            self._hulls[name] = [
                self._scene.add_mesh_simple(
                    f"{WORLD}/ghost/{name}/{part.name}",
                    *part.mesh,
                    color=colour,
                    opacity=OPACITY,
                    side="double",
                    position=part.position,
                    cast_shadow=False,
                    receive_shadow=False,
                )
                for part in parts_of(vehicle, 12)
                if part.role in ("hull", "frame")
            ]

    def update(self, run: str, time_s: float) -> None:
        """Show what reaches beyond now, each hull where its flight would be now."""
        ghosts = self._ghosts.of(run, time_s)
        for name, line in self.lines.items():
            ghost = ghosts.get(name)
            frame = self.frames[name]
            if frame.visible != (ghost is not None):
                frame.visible = line.visible = ghost is not None
            if ghost is None:
                continue
            if self._shown.get(name) is not ghost:
                line.points = _dashes(ghost)
                self._shown[name] = ghost
            place, (roll, pitch, yaw) = ghost.at(time_s)
            frame.position = tuple(place)
            frame.wxyz = pose.of_attitude(pb.Attitude(roll_deg=roll, pitch_deg=pitch, yaw_deg=yaw))


def _dashes(ghost: Ghost) -> np.ndarray:
    """Segments (DASHES, 2, 3) with gaps as long as they are."""
    at = np.linspace(ghost.time_s[0], ghost.time_s[-1], 2 * DASHES)
    points = np.stack([np.interp(at, ghost.time_s, column) for column in ghost.position_ned_m.T], axis=1)
    return points.reshape(DASHES, 2, 3).astype(np.float32)
