"""What a chart's file holds, once it was read."""

from dataclasses import dataclass
from typing import Literal

from bumpless.chart import DepthGrid

Kind = Literal["features", "picture", "depths"]
Place = tuple[float, float]  # latitude and longitude, deg; or north and east, m
Corners = tuple[Place, Place, Place, Place]  # top left, top right, bottom right, bottom left


class NotAChart(ValueError):
    """The file can't be shown; the text says what it is and why."""


@dataclass(frozen=True)
class Said:
    """What whoever stores a chart says of it besides its bytes."""

    corners: str = ""  # of a picture that does not know its own: "a,b;a,b;a,b;a,b"
    local: bool = False  # numbers are m of the missions' frame
    depths: Literal["", "down", "up"] = ""  # of a grid's numbers; "": as they look
    epsg: int | None = None  # system of a grid's x and y, where the file does not say

    @property
    def down(self) -> bool | None:
        """Whether a grid's numbers are depths; None: nobody says."""
        return {"down": True, "up": False}.get(self.depths)


@dataclass(frozen=True)
class Feature:
    """A shape. An area's first part is its outline, the others are holes."""

    kind: Literal["point", "line", "area"]
    parts: tuple[tuple[Place, ...], ...]
    name: str = ""
    colour: str = ""  # "#rrggbb"


@dataclass(frozen=True)
class Content:
    """One of three kinds, on the earth or in m of the missions' frame."""

    kind: Kind
    format: str  # "a GeoTIFF"
    geographic: bool
    notes: tuple[str, ...] = ()
    features: tuple[Feature, ...] = ()
    picture: bytes = b""  # PNG
    corners: Corners | None = None  # of the picture
    grid: DepthGrid | None = None


def corners_of(said: Said) -> Corners:
    """The four places that somebody wrote. Raises NotAChart."""
    places: list[Place] = []
    try:
        for part in said.corners.split(";"):
            first, second = map(float, part.split(","))
            places.append((first, second))
        if len(places) != 4:
            raise ValueError
    except ValueError:
        raise NotAChart("needs four corners: top left, top right, bottom right, bottom left") from None
    if not all(abs(n) <= (1e6 if said.local else 360.0) for place in places for n in place):
        raise NotAChart("has corners that are no places")
    if not said.local and not all(abs(place[0]) <= 90.0 for place in places):
        raise NotAChart("has corners that are no latitudes: latitude comes first")
    (a, b), (c, d) = ((places[1][k] - places[0][k], places[3][k] - places[0][k]) for k in (0, 1))
    if abs(a * d - b * c) < 1e-18:
        raise NotAChart("has corners on one line")
    return places[0], places[1], places[2], places[3]
