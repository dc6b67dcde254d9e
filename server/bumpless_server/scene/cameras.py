"""Where each operator looks from. Presets are per session, so nobody moves another one's picture.

The vehicle stands at the origin of the broadcast scene and the world moves under it, which keeps the picture
still while following. For views that stand still in NED each browser has its own frame `/view`, shifted by
the vehicle's position.
"""

import threading
from collections import OrderedDict
from dataclasses import dataclass
from math import radians, tan
from typing import Any

import numpy as np

from bumpless_server.scene.labels import RULER, Box, Labelled, box_of, spread
from bumpless_server.scene.places import Places
from bumpless_server.scene.ruler import Ruler, picked

FOV_RAD = radians(42.0)
FOLLOW = "follow"
CLOSE = (FOLLOW, "target")  # views near enough for insets and small labels
DETAILS = ("/view/near", "/view/world/near")  # frames that hold those, hidden per browser
REMEMBERED = 64  # sessions whose last view is kept for a reload
FROM_STARBOARD = np.array([-2.5, 4.1, -2.1])
FOLLOW_AIM = np.array([0.0, 0.0, -0.78])


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


@dataclass
class _Asked:
    """What a session asked for last: kept for a reload of its page."""

    view: str = FOLLOW
    ruler: bool = False


class _Viewer:
    def __init__(self, client: Any, session: str, view: str) -> None:
        self.client, self.session, self.view = client, session, view
        self.frame = client.scene.add_frame("/view", show_axes=False)
        self.details = [client.scene.add_frame(name, show_axes=False) for name in DETAILS]
        self.slots: dict[str, Any] = {}
        self.ruler: Ruler | None = None
        self.away: set[str] = set()  # labels that make way for others

    def hide(self, away: set[str]) -> None:
        """Labels that make way in this browser, by the frames that hold them."""
        self.away = away
        for name in away - self.slots.keys():
            self.slots[name] = self.client.scene.add_frame(name, show_axes=False)
        for name, slot in self.slots.items():
            if slot.visible == (name in away):
                slot.visible = name not in away


class Cameras:
    """The browsers that watch, their views, and what each has of its own in the picture."""

    def __init__(self) -> None:
        self.places = Places()
        self._lock = threading.Lock()
        self._viewers: dict[int, _Viewer] = {}
        self._last: OrderedDict[str, _Asked] = OrderedDict()

    def __len__(self) -> int:
        return len(self._viewers)

    def join(self, client: Any, session: str) -> None:
        """A browser opened the scene: it gets its session's last view."""
        with self._lock:
            asked = self._last.get(session, _Asked())
            viewer = _Viewer(client, session, asked.view)
            self._viewers[client.client_id] = viewer
        client.camera.fov = FOV_RAD
        self._aim(viewer)
        if asked.ruler:
            self._rule(viewer, True)

    def leave(self, client: Any) -> None:
        """A browser closed the scene."""
        with self._lock:
            self._viewers.pop(client.client_id, None)

    def _asked(self, session: str) -> tuple[_Asked, list[_Viewer]]:
        """What a session asked for, to be changed, and its browsers. Holds the lock."""
        asked = self._last.setdefault(session, _Asked())
        self._last.move_to_end(session)
        while len(self._last) > REMEMBERED:
            self._last.popitem(last=False)
        return asked, [v for v in self._viewers.values() if v.session == session]

    def set_view(self, session: str, view: str) -> int:
        """Move a session's browsers to a preset; how many there are."""
        with self._lock:
            asked, mine = self._asked(session)
            asked.view = view
        for viewer in mine:
            viewer.view = view
            self._aim(viewer)
        return len(mine)

    def set_ruler(self, session: str, on: bool) -> int:
        """Lay the ruler down in a session's browsers or take it away; how many there are."""
        with self._lock:
            asked, mine = self._asked(session)
            asked.ruler = on
        for viewer in mine:
            self._rule(viewer, on)
        return len(mine)

    def _rule(self, viewer: _Viewer, on: bool) -> None:
        if on == (viewer.ruler is not None):
            return
        if viewer.ruler is not None:
            viewer.client.scene.remove_click_callback("all")
            ruler, viewer.ruler = viewer.ruler, None
            ruler.remove()
            return
        viewer.ruler = Ruler(viewer.client.scene)
        viewer.ruler.draw(self.places)
        viewer.client.scene.on_click()(lambda event: self.click(viewer, event))

    def click(self, viewer: _Viewer, event: Any) -> None:
        """A click in a browser whose ruler lies out: measure to what it means."""
        ruler, places = viewer.ruler, self.places
        if ruler is None:
            return
        shift = places.vehicle - np.asarray(viewer.frame.position)
        end = picked(np.asarray(event.ray_origin) + shift, np.asarray(event.ray_direction), places)
        if end is not None:
            ruler.pick(end)
            ruler.draw(places)

    def carry(self, places: Places) -> None:
        """The vehicle moved: views that stand still in NED are shifted back, rulers are drawn anew."""
        self.places = places
        with self._lock:
            viewers = list(self._viewers.values())
        for viewer in viewers:
            self._shift(viewer)
            if (ruler := viewer.ruler) is not None:
                ruler.draw(places)

    def make_way(self, labels: Labelled) -> None:
        """Hide, in each browser, the labels that would lie over more important ones."""
        standing = labels.places()
        with self._lock:
            viewers = list(self._viewers.values())
        for viewer in viewers:
            boxes = self._boxes(viewer, labels, standing)
            viewer.hide(spread(boxes, viewer.away))

    def _boxes(self, viewer: _Viewer, labels: Labelled, standing: dict[str, np.ndarray]) -> dict[str, Box]:
        offset, camera = np.asarray(viewer.frame.position, float), viewer.client.camera
        boxes = {}
        for name, at in standing.items():
            near = any(name.startswith(f"{detail}/") for detail in DETAILS)
            if near and viewer.view not in CLOSE:
                continue
            if (box := box_of(labels.labels[name], at + offset, camera)) is not None:
                boxes[name] = box
        if viewer.ruler is not None and viewer.ruler.label.visible:
            label = viewer.ruler.label
            box = box_of(label, np.asarray(label.position, float) + offset, camera)
            if box is not None:
                boxes[RULER] = box
        return boxes

    def views(self) -> list[str]:
        """The view of each browser."""
        with self._lock:
            return [v.view for v in self._viewers.values()]

    def rulers(self) -> list[Ruler]:
        """The rulers that lie out."""
        with self._lock:
            return [v.ruler for v in self._viewers.values() if v.ruler is not None]

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
