"""The drawn hull: a body of Myring's form, or an open frame that fills its bounding box."""

from math import radians, tan
from typing import Any

import numpy as np
import numpy.typing as npt

from bumpless_server.scene import mesh
from bumpless_server.scene.mesh import Mesh
from bumpless_server.scene.part import Part


def myring_radius(hull: Any, from_nose_m: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Hull radius (n,) in m at distances behind the (cut) nose tip.

    Source: Myring 1976 as given by Prestero 2001, eqs. (2.1)-(2.2).
    """
    a, b, c, d = hull.nose_length_m, hull.middle_length_m, hull.tail_length_m, hull.diameter_m
    theta = radians(hull.tail_half_angle_deg)
    x = np.asarray(from_nose_m, float) + hull.nose_offset_m
    nose = 0.5 * d * np.maximum(1.0 - np.minimum((x - a) / a, 0.0) ** 2, 0.0) ** (1.0 / hull.nose_exponent)
    t = np.maximum(x - a - b, 0.0)
    tail = 0.5 * d - (1.5 * d / c**2 - tan(theta) / c) * t**2 + (d / c**3 - tan(theta) / c**2) * t**3
    return np.maximum(np.where(x < a, nose, tail), 0.0)


def hull_radius_at(hull: Any, x_m: float) -> float:
    """Radius of a Myring hull at a body station x, m; half the width of any other hull."""
    if hull.kind != "myring":
        return 0.5 * hull.size_m[1]
    behind = hull.nose_to_origin_m - x_m
    return float(myring_radius(hull, [behind])[0]) if 0.0 <= behind <= hull.length_m else 0.0


def hull_parts(hull: Any, segments: int) -> list[Part]:
    """Parts of a hull, `segments` around it."""
    return _myring(hull, segments) if hull.kind == "myring" else _frame(hull)


def _myring(hull: Any, segments: int) -> list[Part]:
    # stations crowd towards both ends, where the radius changes fastest
    behind = hull.length_m * 0.5 * (1.0 - np.cos(np.linspace(0.0, np.pi, 2 * segments)))
    radius = myring_radius(hull, behind)
    x = hull.nose_to_origin_m - behind
    closed = np.vstack([[x[0], 0.0], np.stack([x, radius], 1), [x[-1], 0.0]])
    middle = hull.nose_length_m - hull.nose_offset_m
    bands = [middle + 0.06 * hull.middle_length_m, middle + 0.94 * hull.middle_length_m]
    rings = [_band(hull, at, 0.045 * hull.length_m, segments) for at in bands]
    return [
        Part("hull", "hull", mesh.revolve(closed, segments)),
        Part("accent", "accent", mesh.merge(*rings)),
    ]


def _band(hull: Any, at: float, width: float, segments: int) -> Mesh:
    edge = np.array([at - width / 2.0, at + width / 2.0])
    radius = myring_radius(hull, edge) * 1.012
    return mesh.revolve(np.stack([hull.nose_to_origin_m - edge, radius], 1), segments)


def _frame(hull: Any) -> list[Part]:
    """Open frame vehicle: float block on top, side plates with skids, crossbars."""
    length, width, height = hull.size_m
    block = mesh.box((length * 0.92, width * 0.8, height * 0.34), (0, 0, -0.3 * height))
    plates = [
        mesh.merge(
            mesh.box((length, 0.02 * width, 0.22 * height), (0, side * 0.48 * width, -0.32 * height)),
            mesh.box((length, 0.03 * width, 0.1 * height), (0, side * 0.48 * width, 0.45 * height)),
            *(
                mesh.box(
                    (0.07 * length, 0.03 * width, 0.72 * height),
                    (end * 0.42 * length, side * 0.48 * width, 0.06 * height),
                )
                for end in (-1, 1)
            ),
        )
        for side in (-1, 1)
    ]
    bars = [
        mesh.box((0.05 * length, 0.96 * width, 0.05 * height), (end * 0.4 * length, 0, 0.4 * height))
        for end in (-1, 1)
    ]
    pod = mesh.rod((0.32 * length, 0, 0.12 * height), (-0.32 * length, 0, 0.12 * height), 0.16 * width, 20)
    stripe = mesh.box((0.2 * length, 0.82 * width, 0.36 * height), (0.18 * length, 0, -0.3 * height))
    return [
        Part("hull", "hull", mesh.merge(block, pod)),
        Part("frame", "frame", mesh.merge(*plates, *bars)),
        Part("accent", "accent", stripe),
    ]
