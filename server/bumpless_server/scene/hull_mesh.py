"""A convex hull as a mesh of constant shape, for sets that may be flat, thin or a single line."""

from dataclasses import dataclass

import numpy as np

VERTICES, FACES = 400, 796  # room of every mesh; viser updates arrays in place only while shapes stay
SKIN_SHARE = 0.012  # a direction in which a set is thinner than this share of its size gets that much body


@dataclass(frozen=True)
class HullMesh:
    """vertices (VERTICES, 3) in the set's own unit, faces (FACES, 3); unused ones collapse into a point."""

    vertices: np.ndarray
    faces: np.ndarray

    @property
    def extent(self) -> float:
        """Largest absolute coordinate."""
        return float(np.abs(self.vertices).max())


def hull_mesh(points: np.ndarray) -> HullMesh:
    """The convex hull of points (n, 3), n > 0."""
    from scipy.spatial import ConvexHull

    cloud = np.asarray(points, float).reshape(-1, 3)
    size = max(float(np.abs(cloud).max()), 1e-3)
    cloud = np.unique(np.round(cloud / size, 3), axis=0)
    hull = ConvexHull(_with_body(cloud))
    corners = hull.points[hull.vertices]
    if len(corners) > VERTICES:  # keep corners spread over the whole hull and close it anew
        corners = corners[np.round(np.linspace(0, len(corners) - 1, VERTICES)).astype(int)]
        hull = ConvexHull(corners)
        corners = hull.points[hull.vertices]
    order = np.zeros(len(hull.points), np.int64)
    order[hull.vertices] = np.arange(len(hull.vertices))
    faces = _outwards(hull.points, hull.simplices, hull.equations[:, :3])
    vertices_out = np.repeat(corners[:1], VERTICES, axis=0)
    vertices_out[: len(corners)] = corners
    faces_out = np.zeros((FACES, 3), np.uint32)
    faces_out[: len(faces)] = order[faces]
    return HullMesh((vertices_out * size).astype(np.float32), faces_out)


def _with_body(cloud: np.ndarray) -> np.ndarray:
    """Points of unit size, doubled across every principal direction in which they are thin."""
    middle = cloud.mean(axis=0)
    _, _, axes = np.linalg.svd(np.vstack([cloud - middle, np.zeros((3, 3))]), full_matrices=False)
    for axis in axes:
        if np.ptp((cloud - middle) @ axis) < SKIN_SHARE:
            cloud = np.concatenate([cloud + 0.5 * SKIN_SHARE * axis, cloud - 0.5 * SKIN_SHARE * axis])
    return cloud


def _outwards(points: np.ndarray, simplices: np.ndarray, normals: np.ndarray) -> np.ndarray:
    a, b, c = (points[simplices[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), normals) < 0.0
    faces = simplices.copy()
    faces[inward, 1], faces[inward, 2] = simplices[inward, 2], simplices[inward, 1]
    return faces
