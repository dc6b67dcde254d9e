"""Where each operator looks from. Presets are per session, so nobody moves another one's picture.

The vehicle stands at the origin of the broadcast scene and the world moves under it, which keeps the picture
still while following. For views that stand still in NED each browser has its own frame `/view`, shifted by
the vehicle's position.
"""

import threading
from collections import OrderedDict
from dataclasses import dataclass, field
from math import radians, tan
from typing import Any

import numpy as np

FOV_RAD = radians(42.0)
FOLLOW = "follow"
CLOSE = (FOLLOW, "target")  # views near enough for insets and small labels
DETAILS = ("/view/near", "/view/world/near")  # frames that hold those, hidden per browser
REMEMBERED = 64  # sessions whose last view is kept for a reload
FROM_STARBOARD = np.array([-2.5, 4.1, -2.1])
FOLLOW_AIM = np.array([0.0, 0.0, -0.78])


@dataclass
class Places:
    """What a preset must hold, NED in m; heading in rad."""

    vehicle: np.ndarray = field(default_factory=lambda: np.zeros(3))
    heading: float = 0.0
    path: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    target: np.ndarray | None = None
    target_heading: float = 0.0
    observation: np.ndarray | None = None


def turned(vector: np.ndarray, heading: float) -> np.ndarray:
    """A vector of a levelled body frame in NED."""
    c, s = np.cos(heading), np.sin(heading)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1], vector[2]])


def placed(view: str, at: Places, aspect: float = 1.7) -> tuple[np.ndarray, np.ndarray]:
    """Camera position and the point it looks at, m: from the vehicle for "follow", in NED for the others.

    `aspect` is the picture's width over its height.
    """
    if view == FOLLOW:
        return turned(FROM_STARBOARD, at.heading), FOLLOW_AIM.copy()
    if view == "target" and at.target is not None:
        aim = at.target if at.observation is None else 0.5 * (at.target + at.observation)
        reach = 1.5 + 0.6 * float(np.linalg.norm(at.target - aim))
        return aim + turned(np.array([-1.6, 3.6, -2.0]) * reach / 1.8, at.target_heading), aim
    centre, radius = _bounds(at)
    upright = radius / tan(FOV_RAD / 2.0)
    if view == "top":  # a hair south of straight down, so that north is up
        return centre + [-0.002 * upright, 0.0, -1.3 * upright], centre
    # along the path from left to right, where the picture is widest
    distance = 1.25 * upright / min(max(aspect, 0.5), 1.7)
    return centre + distance * turned(np.array([-0.22, 0.75, -0.62]), _course(at)), centre


def _course(at: Places) -> float:
    """Direction from the path's start to its end, rad; the vehicle's heading without one."""
    if len(at.path) > 1:
        north, east = (at.path[-1] - at.path[0])[:2]
        if abs(north) + abs(east) > 1.0:
            return float(np.arctan2(east, north))
    return at.heading


def _bounds(at: Places) -> tuple[np.ndarray, float]:
    points = [at.vehicle[None], at.path.reshape(-1, 3)]
    points += [p[None] for p in (at.target, at.observation) if p is not None]
    everything = np.concatenate(points)
    low, high = everything.min(axis=0), everything.max(axis=0)
    return 0.5 * (low + high), max(0.5 * float(np.linalg.norm((high - low)[:2])), 4.0)


class _Viewer:
    def __init__(self, client: Any, session: str, view: str) -> None:
        self.client, self.session, self.view = client, session, view
        self.frame = client.scene.add_frame("/view", show_axes=False)
        self.details = [client.scene.add_frame(name, show_axes=False) for name in DETAILS]


class Cameras:
    """The browsers that watch, and their views."""

    def __init__(self) -> None:
        self.places = Places()
        self._lock = threading.Lock()
        self._viewers: dict[int, _Viewer] = {}
        self._last: OrderedDict[str, str] = OrderedDict()

    def __len__(self) -> int:
        return len(self._viewers)

    def join(self, client: Any, session: str) -> None:
        """A browser opened the scene: it gets its session's last view."""
        with self._lock:
            viewer = _Viewer(client, session, self._last.get(session, FOLLOW))
            self._viewers[client.client_id] = viewer
        client.camera.fov = FOV_RAD
        self._aim(viewer)

    def leave(self, client: Any) -> None:
        """A browser closed the scene."""
        with self._lock:
            self._viewers.pop(client.client_id, None)

    def set_view(self, session: str, view: str) -> int:
        """Move a session's browsers to a preset; how many there are."""
        with self._lock:
            self._last[session] = view
            self._last.move_to_end(session)
            while len(self._last) > REMEMBERED:
                self._last.popitem(last=False)
            mine = [v for v in self._viewers.values() if v.session == session]
        for viewer in mine:
            viewer.view = view
            self._aim(viewer)
        return len(mine)

    def carry(self, places: Places) -> None:
        """The vehicle moved: views that stand still in NED are shifted back."""
        self.places = places
        with self._lock:
            viewers = list(self._viewers.values())
        for viewer in viewers:
            self._shift(viewer)

    def views(self) -> list[str]:
        """The view of each browser."""
        with self._lock:
            return [v.view for v in self._viewers.values()]

    def _shift(self, viewer: _Viewer) -> None:
        offset = np.zeros(3) if viewer.view == FOLLOW else self.places.vehicle
        viewer.frame.position = tuple(float(v) for v in offset)

    def _aim(self, viewer: _Viewer) -> None:
        position, aim = placed(viewer.view, self.places, viewer.client.camera.aspect)
        with viewer.client.atomic():
            self._shift(viewer)
            for frame in viewer.details:
                frame.visible = viewer.view in CLOSE
            viewer.client.camera.position = position
            viewer.client.camera.look_at = aim
