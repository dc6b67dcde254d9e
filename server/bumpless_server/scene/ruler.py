"""A ruler: how far it is from one thing or place to another, in one browser's picture.

It begins between vehicle and dock. A click measures from the vehicle to what was clicked, the next one from
there to the next. Vehicle and dock are followed as they move; any other place is where the look meets the
vehicle's depth.
"""

from dataclasses import dataclass
from math import atan2, cos, degrees, radians
from typing import Any

import numpy as np

from bumpless_server.scene import palette
from bumpless_server.scene.labels import RULER
from bumpless_server.scene.places import Places

VEHICLE, DOCK, POINT = "vehicle", "dock", "observation point"
NEAR_RAD = radians(2.2)  # a click this close to a thing means the thing
FARTHEST_M = 2000.0
IN_SIGHT_M = 1.2  # from the vehicle: a camera that follows it sees no more


@dataclass(frozen=True)
class End:
    """One end: a thing that is followed by its name, or a place in NED, m."""

    thing: str = ""
    place: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def at(self, places: Places) -> np.ndarray | None:
        """Where it is now, NED in m; None for a thing that is not there."""
        return things(places).get(self.thing) if self.thing else np.array(self.place)


def things(places: Places) -> dict[str, np.ndarray]:
    """What can be measured by its name."""
    found = {VEHICLE: places.vehicle, DOCK: places.target, POINT: places.observation}
    return {name: at for name, at in found.items() if at is not None}


def picked(origin: np.ndarray, along: np.ndarray, places: Places) -> End | None:
    """What a look from `origin` (NED, m) in direction `along` means; None for the sky."""
    along = along / max(float(np.linalg.norm(along)), 1e-12)
    named = [(End(name), at) for name, at in things(places).items()]
    for end, at in (*named, *((End(place=_place(at)), at) for at in places.path)):
        to = at - origin
        if float(to @ along) > cos(NEAR_RAD) * float(np.linalg.norm(to)):
            return end
    if abs(along[2]) < 1e-6:
        return None
    reach = float((places.vehicle[2] - origin[2]) / along[2])
    return End(place=_place(origin + reach * along)) if 0.0 < reach < FARTHEST_M else None


def _place(at: np.ndarray) -> tuple[float, float, float]:
    north, east, down = (float(v) for v in at)
    return north, east, down


def beside(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Where the words stand: in the middle, but near the vehicle where it is an end, and so in sight."""
    near, far = (a, b) if np.linalg.norm(a) <= np.linalg.norm(b) else (b, a)
    half, length = 0.5 * (far - near), float(np.linalg.norm(far - near))
    if float(np.linalg.norm(near)) > 1e-6 or length <= 2.0 * IN_SIGHT_M:
        return near + half
    return IN_SIGHT_M / length * (far - near)


def ruler_text(start: np.ndarray, end: np.ndarray) -> str:
    """Distance, level distance with bearing, and depth between two places in NED, m."""
    north, east, down = (float(v) for v in end - start)
    whole = float(np.linalg.norm(end - start))
    bearing = round(degrees(atan2(east, north))) % 360
    level = float(np.hypot(north, east))
    words = [f"{whole:.2f} m"]
    if level >= 0.005:
        words.append(f"level {level:.2f} m to {bearing:03d}°")
    if abs(down) >= 0.005:
        words.append(f"{abs(down):.2f} m {'deeper' if down > 0.0 else 'shallower'}")
    return " · ".join(words)


class Ruler:
    """One browser's ruler, drawn into its own scene."""

    def __init__(self, scene: Any) -> None:
        self.ends = (End(VEHICLE), End(DOCK))
        self.line = scene.add_line_segments(
            "/view/ruler",
            np.zeros((1, 2, 3)),
            palette.RULER,
            thickness=2.0,
            thickness_units="screen",
            visible=False,
        )
        self.label = scene.add_label(RULER, "", anchor="top-center", visible=False)

    def remove(self) -> None:
        """Take it out of the scene."""
        self.line.remove()
        self.label.remove()

    def pick(self, end: End) -> None:
        """Measure to this: from the vehicle at first, later from what was picked before."""
        first = self.ends == (End(VEHICLE), End(DOCK))
        self.ends = (End(VEHICLE) if first else self.ends[1], end)

    def draw(self, places: Places) -> None:
        """As its ends lie now. The vehicle is the view's origin."""
        start, end = (end.at(places) for end in self.ends)
        if start is None or end is None:
            self.line.visible = False
            self.label.text, self.label.visible = "no dock to measure to: click what to measure", True
            self.label.position = (0.0, 0.0, -0.6)
            return
        a, b = start - places.vehicle, end - places.vehicle
        self.line.points = np.array([[a, b]])
        self.label.position = tuple(float(v) for v in beside(a, b))
        self.label.text = ruler_text(start, end)
        self.line.visible = self.label.visible = True
