"""The Myring hull: radius along its axis, and the integrals that strip theory needs.

Source: Prestero 2001, section 3.1 (vehicle profile); Myring 1976.
"""

import math
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle.parts import MyringHull

Array = NDArray[np.float64]
STATIONS = 4001


def myring_radius(hull: MyringHull, x: Array) -> Array:
    """Radius in m at stations x (body axis, m, forward of O_b); zero outside the hull."""
    xi = np.atleast_1d(hull.nose_to_origin_m - np.asarray(x, dtype=float))  # back from the nose tip
    d, a, c = hull.diameter_m, hull.nose_length_m, hull.tail_length_m
    slope = math.tan(math.radians(hull.tail_half_angle_deg))
    nose_end = a - hull.nose_offset_m
    tail_start = nose_end + hull.middle_length_m
    radius = np.full(xi.shape, d / 2)
    nose = xi < nose_end
    reach = np.clip((xi[nose] - nose_end) / a, -1.0, 0.0)
    radius[nose] = d / 2 * (1.0 - reach**2) ** (1.0 / hull.nose_exponent)
    tail = xi > tail_start
    s = xi[tail] - tail_start
    radius[tail] = d / 2 - (3 * d / (2 * c**2) - slope / c) * s**2 + (d / c**3 - slope / c**2) * s**3
    radius[(xi < 0) | (xi > hull.length_m)] = 0.0
    return np.maximum(radius, 0.0)


class HullStrips:
    """A Myring hull cut into strips: stations `x` (m, from tail to nose), radii `radius` (m)."""

    def __init__(self, hull: MyringHull) -> None:
        self.hull = hull
        nose = hull.nose_to_origin_m
        self.x = np.linspace(nose - hull.length_m, nose, STATIONS)
        self.radius = myring_radius(hull, self.x)

    def integral(self, integrand: Array) -> float:
        """Integral over the hull's length of values at `x`, by Simpson's rule."""
        h = self.x[1] - self.x[0]
        return float(
            h / 3 * (integrand[0] + 4 * integrand[1:-1:2].sum() + 2 * integrand[2:-1:2].sum() + integrand[-1])
        )

    @cached_property
    def volume(self) -> float:
        """Enclosed volume, m^3."""
        return self.integral(math.pi * self.radius**2)

    @cached_property
    def center(self) -> float:
        """Station of the centre of volume, m forward of O_b."""
        return self.integral(math.pi * self.radius**2 * self.x) / self.volume

    @cached_property
    def planform_area(self) -> float:
        """Area of the side view, m^2."""
        return self.integral(2 * self.radius)

    @cached_property
    def wetted_area(self) -> float:
        """Area of the skin without end plates, m^2."""
        r, h = self.radius, self.x[1] - self.x[0]
        return float(np.sum(math.pi * (r[1:] + r[:-1]) * np.hypot(np.diff(r), h)))

    @property
    def frontal_area(self) -> float:
        """Area of the largest section, m^2."""
        return math.pi * self.hull.diameter_m**2 / 4

    def uniform_inertia(self, density: float) -> tuple[float, float]:
        """(I_xx, I_yy) in kg m^2 about O_b of the hull filled with one density (kg/m^3)."""
        area = math.pi * self.radius**2
        roll = self.integral(0.5 * area * self.radius**2)
        pitch = self.integral(area * (0.25 * self.radius**2 + self.x**2))
        return density * roll, density * pitch
