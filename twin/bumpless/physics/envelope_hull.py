"""Convex sets of forces or moments: their surface for drawing, their size for tables.

SciPy is imported only when a size is asked for.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Faces = NDArray[np.int64]
_FLAT = 1e-7  # extent across over extent along, below which a set counts as flat


@dataclass(frozen=True)
class Hull:
    """A convex set in force (N) or moment (N m) space, body axes.

    vertices: (n, 3) points on its boundary; faces: (m, 3) indices of triangles, seen from outside
    counter-clockwise. Of attainable sets both shapes are fixed by the number of directions, so that a
    scene can move the vertices in place; points may coincide.
    """

    vertices: Array
    faces: Faces

    @cached_property
    def dimension(self) -> int:
        """3 for a body, 2 for a flat set, 1 for a segment, 0 for a point."""
        return self.span[0]

    @cached_property
    def volume(self) -> float:
        """Volume of the convex hull, N^3 or (N m)^3; 0 for flat sets."""
        return self._size[0]

    @cached_property
    def area(self) -> float:
        """Surface, N^2 or (N m)^2; of a flat set the area of its polygon, counted once; of a segment 0."""
        return self._size[1]

    @cached_property
    def span(self) -> tuple[int, Array]:
        """The dimension, and the set's principal axes (3, 3), the widest first."""
        centered = self.vertices - self.vertices.mean(axis=0)
        _, extent, axes = np.linalg.svd(centered, full_matrices=False)
        if extent[0] == 0.0:
            return 0, axes
        return int(np.sum(extent > _FLAT * extent[0])), axes

    @cached_property
    def _size(self) -> tuple[float, float]:
        from scipy.spatial import ConvexHull  # pyright: ignore[reportMissingTypeStubs]

        dimension, axes = self.span
        if dimension == 3:
            hull = ConvexHull(self.vertices)
            return float(hull.volume), float(hull.area)
        if dimension == 2:  # in the plane SciPy's volume is the area
            return 0.0, float(ConvexHull(self.vertices @ axes[:2].T).volume)
        return 0.0, 0.0


@dataclass(frozen=True)
class Envelope:
    """AFS and AMS of one set of actuators. Source: Gao et al. 2026, eqs. (37)-(40)."""

    force: Hull
    moment: Hull


def hull_of_points(points: Array) -> Hull:
    """The convex hull of a cloud (n, 3) with only its corner points kept; flat clouds have no faces."""
    from scipy.spatial import ConvexHull  # pyright: ignore[reportMissingTypeStubs]

    cloud = Hull(points, np.zeros((0, 3), np.int64))
    if cloud.dimension < 2:
        along = (points - points[0]) @ cloud.span[1][0]
        return Hull(points[[int(along.argmin()), int(along.argmax())]], cloud.faces)
    if cloud.dimension == 2:
        corners = ConvexHull(points @ cloud.span[1][:2].T).vertices
        return Hull(points[corners], cloud.faces)
    hull = ConvexHull(points)
    renumber = np.zeros(len(points), np.int64)
    renumber[hull.vertices] = np.arange(len(hull.vertices))
    return Hull(points[hull.vertices], _outward(points, hull.simplices.astype(np.int64), renumber))


def _outward(points: Array, triangles: Faces, renumber: Faces) -> Faces:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - points.mean(axis=0)) < 0
    faces = triangles.copy()
    faces[inward] = faces[inward][:, ::-1]
    return renumber[faces]


@lru_cache(maxsize=8)
def direction_sphere(n: int) -> tuple[Array, Faces]:
    """n unit directions spread evenly, (n, 3), and the triangles between neighbours, (2n - 4, 3).

    Points of a Fibonacci lattice: no poles, no two equal, any n >= 4.
    """
    k = np.arange(n) + 0.5
    z = 1.0 - 2.0 * k / n
    angle = np.pi * (1.0 + 5.0**0.5) * k
    around = np.sqrt(1.0 - z**2)
    directions = np.column_stack([around * np.cos(angle), around * np.sin(angle), z])
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    faces = hull_of_points(directions).faces
    directions.setflags(write=False)
    faces.setflags(write=False)
    return directions, faces
