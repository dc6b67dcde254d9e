"""Small meshes as (vertices (n, 3) float32 in m, faces (m, 3) uint32), wound counter-clockwise outside."""

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float32]
Faces = npt.NDArray[np.uint32]
Mesh = tuple[Array, Faces]
Vector = npt.ArrayLike


def _mesh(vertices: npt.ArrayLike, faces: npt.ArrayLike) -> Mesh:
    return np.asarray(vertices, np.float32).reshape(-1, 3), np.asarray(faces, np.uint32).reshape(-1, 3)


def merge(*meshes: Mesh) -> Mesh:
    """Several meshes as one."""
    offsets = np.cumsum([0] + [len(v) for v, _ in meshes[:-1]])
    vertices = np.concatenate([v for v, _ in meshes])
    return _mesh(vertices, np.concatenate([f + o for (_, f), o in zip(meshes, offsets, strict=True)]))


def moved(mesh: Mesh, rotation: npt.ArrayLike | None = None, offset: Vector = (0.0, 0.0, 0.0)) -> Mesh:
    """The mesh turned by a (3, 3) rotation, then shifted by offset, m."""
    vertices = mesh[0] if rotation is None else mesh[0] @ np.asarray(rotation, np.float32).T
    return _mesh(vertices + np.asarray(offset, np.float32), mesh[1])


def revolve(stations: npt.ArrayLike, segments: int) -> Mesh:
    """Surface of revolution about x through stations (n, 2) of [x, radius], x falling from nose to tail."""
    profile = np.asarray(stations, float)
    angle = np.linspace(0.0, 2.0 * np.pi, segments, endpoint=False)
    ring = np.stack([np.zeros(segments), np.cos(angle), np.sin(angle)], axis=1)
    vertices = profile[:, None, 1, None] * ring[None]
    vertices[:, :, 0] = profile[:, 0, None]
    i, j = np.meshgrid(np.arange(len(profile) - 1), np.arange(segments), indexing="ij")
    a, b = i * segments + j, i * segments + (j + 1) % segments
    faces = np.stack([a, b + segments, b, a, a + segments, b + segments], axis=-1)
    return _mesh(vertices, faces)


def box(size: Vector, centre: Vector = (0.0, 0.0, 0.0)) -> Mesh:
    """Box of size [x y z] in m, each side with its own corners, so that edges stay sharp."""
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (1.0, -1.0):
            quad = np.zeros((4, 3))
            quad[:, axis] = sign
            quad[:, u] = np.array([-1.0, 1.0, 1.0, -1.0]) * sign
            quad[:, v] = [-1.0, -1.0, 1.0, 1.0]
            quads.append(quad)
    faces = np.concatenate([np.array([[0, 1, 2], [0, 2, 3]]) + 4 * k for k in range(6)])
    return _mesh(np.concatenate(quads) * np.asarray(size, float) / 2.0 + np.asarray(centre, float), faces)


def rod(start: Vector, end: Vector, radius: float, segments: int = 10) -> Mesh:
    """Cylinder from start to end."""
    a, b = np.asarray(start, float), np.asarray(end, float)
    length = float(np.linalg.norm(b - a))
    stations = [(0.0, 0.0), (0.0, radius), (-length, radius), (-length, 0.0)]
    return moved(revolve(stations, segments), frame_along(a - b), a)


def duct(radius: float, length: float, segments: int = 24) -> Mesh:
    """Open ring about x, centred: a thruster's nozzle, seen from inside and outside."""
    half, inner = length / 2.0, radius * 0.9
    return revolve([(half, inner), (half, radius), (-half, radius), (-half, inner), (half, inner)], segments)


def propeller(radius: float, blades: int = 3) -> Mesh:
    """Hub and flat pitched blades about x."""
    hub = revolve(
        [
            (0.3 * radius, 0.0),
            (0.15 * radius, 0.22 * radius),
            (-0.25 * radius, 0.22 * radius),
            (-0.25 * radius, 0.0),
        ],
        12,
    )
    blade = moved(box((0.06 * radius, 0.34 * radius, 0.8 * radius)), turn((0, 0, 1), 0.6))
    blade = moved(blade, None, (0.0, 0.0, 0.55 * radius))
    return merge(hub, *(moved(blade, turn((1, 0, 0), 2.0 * np.pi * k / blades)) for k in range(blades)))


def foil(chord: float, span: float, taper: float = 0.7, thickness: float = 0.12) -> Mesh:
    """Fin with its stock at the origin: leading edge along +x, root at z = 0, tip at z = span.

    The stock stands a quarter chord behind the leading edge; section is a thin diamond-like NACA shape.
    """
    x = np.array([0.25, 0.12, -0.15, -0.75, -0.15, 0.12]) * chord
    y = np.array([0.0, 0.7, 0.9, 0.0, -0.9, -0.7]) * 0.5 * thickness * chord
    root = np.stack([x, y, np.zeros(6)], axis=1)
    tip = np.stack([x * taper, y * taper, np.full(6, span)], axis=1)
    k = np.arange(6)
    n = (k + 1) % 6
    sides = np.concatenate([np.stack([k, n, n + 6], 1), np.stack([k, n + 6, k + 6], 1)])
    caps = [(6, 6 + i, 7 + i) for i in range(1, 5)] + [(0, i + 1, i) for i in range(1, 5)]
    return _mesh(np.concatenate([root, tip]), np.concatenate([sides, caps]))


def turn(axis: Vector, angle: float) -> npt.NDArray[np.float64]:
    """Rotation matrix (3, 3) about an axis by an angle, rad, right-handed. Source: Rodrigues' formula."""
    a = np.asarray(axis, float)
    a = a / np.linalg.norm(a)
    k = np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])
    return np.eye(3) + np.sin(angle) * k + (1.0 - np.cos(angle)) * (k @ k)


def frame_along(direction: Vector) -> npt.NDArray[np.float64]:
    """A rotation (3, 3) whose first column is the direction."""
    x = np.asarray(direction, float)
    x = x / np.linalg.norm(x)
    helper = np.eye(3)[int(np.argmin(np.abs(x)))]
    y = np.cross(helper, x)
    y /= np.linalg.norm(y)
    return np.stack([x, y, np.cross(x, y)], axis=1)


def circle(radius: float, segments: int = 96) -> Array:
    """Line segments (segments, 2, 3) of a horizontal circle about the origin."""
    angle = np.linspace(0.0, 2.0 * np.pi, segments + 1)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(segments + 1)], axis=1)
    return np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)
