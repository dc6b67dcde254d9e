"""Where a mission's local frame lies on the earth, and the way there and back."""

import math
from typing import Annotated, Any, TypeVar

import numpy as np
import numpy.typing as npt

from bumpless.config.declare import Number, model
from bumpless.config.mission.notes import direction

_A_M, _F = 6378137.0, 1.0 / 298.257223563  # WGS 84
_E2 = _F * (2.0 - _F)
_DEGREES = 180.0 / math.pi
T = TypeVar("T", float, npt.NDArray[np.float64])


@model
class Origin:
    """The place of [0, 0, 0] at the surface, and where the local frame's first axis points.

    A chart of the neighbourhood, not a projection of the earth: north and east are the ways along meridian
    and parallel at the middle latitude.
    """

    latitude_deg: Annotated[float, Number("Latitude, WGS 84", "deg", -89.0, 89.0)]
    longitude_deg: Annotated[float, Number("Longitude, WGS 84", "deg", -180.0, 180.0)]
    heading_deg: Annotated[float, direction("True heading of the local frame's first axis")] = 0.0

    def to_geographic(self, north_m: T, east_m: T) -> tuple[T, T]:
        """(latitude, longitude) in deg of a place in the local frame, m, or of an array of places."""
        c, s = math.cos(math.radians(self.heading_deg)), math.sin(math.radians(self.heading_deg))
        north, east = c * north_m - s * east_m, s * north_m + c * east_m
        latitude: T = self.latitude_deg + 0.0 * north
        for _ in range(4):  # the radius is that of the middle latitude, which it decides
            meridian, _parallel = _radii(0.5 * (latitude + self.latitude_deg))
            latitude = self.latitude_deg + _DEGREES * (north / meridian)
        _meridian, parallel = _radii(0.5 * (latitude + self.latitude_deg))
        longitude = self.longitude_deg + _DEGREES * (east / parallel)
        return latitude, (longitude + 180.0) % 360.0 - 180.0

    def to_local(self, latitude_deg: T, longitude_deg: T) -> tuple[T, T]:
        """(first axis, second axis) in m of a place on the earth, or of an array of places: north and east
        with heading 0."""
        meridian, parallel = _radii(0.5 * (latitude_deg + self.latitude_deg))
        turn = (longitude_deg - self.longitude_deg + 180.0) % 360.0 - 180.0
        north = (latitude_deg - self.latitude_deg) / _DEGREES * meridian
        east = turn / _DEGREES * parallel
        c, s = math.cos(math.radians(self.heading_deg)), math.sin(math.radians(self.heading_deg))
        return c * north + s * east, c * east - s * north


def _radii(latitude_deg: Any) -> tuple[Any, Any]:
    """Radii of the meridian and of the parallel at a latitude, m.

    Source: NIMA TR8350.2, Department of Defense World Geodetic System 1984.
    """
    phi = latitude_deg / _DEGREES
    w2 = 1.0 - _E2 * np.sin(phi) ** 2
    return _A_M * (1.0 - _E2) / w2**1.5, _A_M * np.cos(phi) / np.sqrt(w2)
