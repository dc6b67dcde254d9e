"""A convex hull as a mesh of constant shape: the support points of a fixed set of directions."""

from functools import cache

import numpy as np


@cache
def ball(subdivisions: int) -> tuple[np.ndarray, np.ndarray]:
    """Unit icosphere: directions (n, 3) and faces (m, 3), n = 10 * 4^s + 2. Do not change the arrays."""
    g = (1.0 + 5.0**0.5) / 2.0
    corners = [
        (-1, g, 0),
        (1, g, 0),
        (-1, -g, 0),
        (1, -g, 0),
        (0, -1, g),
        (0, 1, g),
        (0, -1, -g),
        (0, 1, -g),
        (g, 0, -1),
        (g, 0, 1),
        (-g, 0, -1),
        (-g, 0, 1),
    ]
    faces = [
        (0, 11, 5),
        (0, 5, 1),
        (0, 1, 7),
        (0, 7, 10),
        (0, 10, 11),
        (1, 5, 9),
        (5, 11, 4),
        (11, 10, 2),
        (10, 7, 6),
        (7, 1, 8),
        (3, 9, 4),
        (3, 4, 2),
        (3, 2, 6),
        (3, 6, 8),
        (3, 8, 9),
        (4, 9, 5),
        (2, 4, 11),
        (6, 2, 10),
        (8, 6, 7),
        (9, 8, 1),
    ]
    points = [np.asarray(c, float) / np.linalg.norm(c) for c in corners]
    for _ in range(subdivisions):
        middle: dict[tuple[int, int], int] = {}
        finer = []
        for a, b, c in faces:
            ab, bc, ca = (_midpoint(points, middle, i, j) for i, j in ((a, b), (b, c), (c, a)))
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return np.array(points), np.array(faces, np.uint32)


def _midpoint(points: list[np.ndarray], middle: dict[tuple[int, int], int], i: int, j: int) -> int:
    key = (min(i, j), max(i, j))
    if key not in middle:
        middle[key] = len(points)
        point = points[i] + points[j]
        points.append(point / np.linalg.norm(point))
    return middle[key]


def support_mesh(vertices: np.ndarray, directions: np.ndarray, skin: float) -> np.ndarray:
    """Vertices (n, 3) of the convex hull of `vertices` (m, 3), one per direction (n, 3), swollen by `skin`.

    The hull of a flat or thin set is flat; the swelling (Minkowski sum with a ball) keeps it visible.
    """
    support = vertices[np.argmax(directions @ vertices.T, axis=1)]
    return (support + skin * directions).astype(np.float32)
