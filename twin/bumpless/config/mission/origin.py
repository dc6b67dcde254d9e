"""Where a mission's local frame lies on the earth, and the way there and back."""

import math
from typing import Annotated

from bumpless.config.declare import Number, model
from bumpless.config.mission.notes import direction

_A_M, _F = 6378137.0, 1.0 / 298.257223563  # WGS 84
_E2 = _F * (2.0 - _F)


@model
class Origin:
    """The place of [0, 0, 0] at the surface, and where the local frame's first axis points.

    A chart of the neighbourhood, not a projection of the earth: north and east are the ways along meridian
    and parallel at the middle latitude.
    """

    latitude_deg: Annotated[float, Number("Latitude, WGS 84", "deg", -89.0, 89.0)]
    longitude_deg: Annotated[float, Number("Longitude, WGS 84", "deg", -180.0, 180.0)]
    heading_deg: Annotated[float, direction("True heading of the local frame's first axis")] = 0.0

    def to_geographic(self, north_m: float, east_m: float) -> tuple[float, float]:
        """(latitude, longitude) in deg of a place in the local frame, m."""
        c, s = math.cos(math.radians(self.heading_deg)), math.sin(math.radians(self.heading_deg))
        north, east = c * north_m - s * east_m, s * north_m + c * east_m
        latitude = self.latitude_deg
        for _ in range(4):  # the radius is that of the middle latitude, which it decides
            meridian, _parallel = _radii(0.5 * (latitude + self.latitude_deg))
            latitude = self.latitude_deg + math.degrees(north / meridian)
        _meridian, parallel = _radii(0.5 * (latitude + self.latitude_deg))
        longitude = self.longitude_deg + math.degrees(east / parallel)
        return latitude, (longitude + 180.0) % 360.0 - 180.0

    def to_local(self, latitude_deg: float, longitude_deg: float) -> tuple[float, float]:
        """(first axis, second axis) in m of a place on the earth: north and east with heading 0."""
        meridian, parallel = _radii(0.5 * (latitude_deg + self.latitude_deg))
        turn = (longitude_deg - self.longitude_deg + 180.0) % 360.0 - 180.0
        north = math.radians(latitude_deg - self.latitude_deg) * meridian
        east = math.radians(turn) * parallel
        c, s = math.cos(math.radians(self.heading_deg)), math.sin(math.radians(self.heading_deg))
        return c * north + s * east, c * east - s * north


def _radii(latitude_deg: float) -> tuple[float, float]:
    """Radii of the meridian and of the parallel at a latitude, m.

    Source: NIMA TR8350.2, Department of Defense World Geodetic System 1984.
    """
    phi = math.radians(latitude_deg)
    w2 = 1.0 - _E2 * math.sin(phi) ** 2
    return _A_M * (1.0 - _E2) / w2**1.5, _A_M * math.cos(phi) / math.sqrt(w2)
