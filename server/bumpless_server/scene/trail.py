"""The track behind the vehicle, coloured by mode, in constant memory.

Points are kept `spacing_m` apart. When all room is taken, every other point goes and the spacing doubles:
the whole track stays visible, only coarser. The picture is chunks of 100 line segments; while the vehicle
moves only the chunk at its end is sent again.
"""

from typing import Any

import numpy as np

from bumpless_server.scene.palette import mode_colour, vertex_colour

CHUNK = 100
FIRST_SPACING_M = 0.1


class Track:
    """The points themselves: (n, 3) NED in m and the mode's colour at each; no drawing."""

    def __init__(self, chunks: int = 20, spacing_m: float = FIRST_SPACING_M) -> None:
        self.capacity = chunks * CHUNK + 1
        self.points = np.zeros((self.capacity, 3), np.float32)
        self.colours = np.zeros((self.capacity, 3), np.uint8)
        self.first_spacing_m = spacing_m
        self.clear()

    def clear(self) -> None:
        """Forget the track."""
        self.count = 0
        self.spacing_m = self.first_spacing_m
        self.changed_from = 0  # points from here on differ from what was drawn last

    def add(self, position_ned_m: np.ndarray, mode: int) -> bool:
        """Take a point if it is far enough from the last; True if taken."""
        colour = np.asarray(vertex_colour(mode_colour(mode)), np.uint8)
        if self.count:
            step = float(np.linalg.norm(position_ned_m - self.points[self.count - 1]))
            if step < self.spacing_m:
                return False
        if self.count == self.capacity:
            self._thin()
        self.points[self.count], self.colours[self.count] = position_ned_m, colour
        self.changed_from = min(self.changed_from, self.count)
        self.count += 1
        return True

    def _thin(self) -> None:
        kept = (self.count + 1) // 2
        self.points[:kept] = self.points[: self.count : 2]
        self.colours[:kept] = self.colours[: self.count : 2]
        self.count, self.spacing_m, self.changed_from = kept, 2.0 * self.spacing_m, 0

    def chunk(self, index: int) -> tuple[np.ndarray, np.ndarray]:
        """Segments (CHUNK, 2, 3) and colours (CHUNK, 2, 3) of a chunk; unused ones collapse into a point."""
        order = np.arange(index * CHUNK, index * CHUNK + CHUNK + 1)
        order = np.minimum(order, max(self.count - 1, 0))
        ends = np.stack([order[:-1], order[1:]], axis=1)
        colours = np.repeat(self.colours[ends[:, 1]][:, None, :], 2, axis=1)
        return self.points[ends], colours


class TrailView:
    """Draws a Track."""

    def __init__(self, scene: Any, track: Track) -> None:
        self.track = track
        points, colours = np.zeros((CHUNK, 2, 3), np.float32), np.zeros((CHUNK, 2, 3), np.uint8)
        self.nodes = [
            scene.add_line_segments(
                f"/view/world/trail/{k}",
                points,
                colours,
                thickness=3.0,
                thickness_units="screen",
                visible=False,
            )
            for k in range((track.capacity - 1) // CHUNK)
        ]

    def draw(self) -> int:
        """Send what changed since the last time; returns how many chunks that was."""
        track = self.track
        if track.changed_from >= track.count and track.count:
            return 0
        first = max(track.changed_from - 1, 0) // CHUNK
        last = max(track.count - 2, 0) // CHUNK
        sent = 0
        for k, node in enumerate(self.nodes):
            visible = track.count > 1 and k <= last
            if visible and k >= first:
                node.points, node.colors = track.chunk(k)
                sent += 1
            if node.visible != visible:
                node.visible = visible
        track.changed_from = track.count
        return sent
