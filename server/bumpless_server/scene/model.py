"""The vehicle's shape out of its parsed file: what is fixed, what deflects, what turns. Pure geometry.

Body axes: x forward, y starboard, z down, origin O_b; m and radians.
"""

from dataclasses import dataclass
from math import cos, radians, sin, tan
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from bumpless_server.scene import mesh
from bumpless_server.scene.mesh import Mesh

Role = Literal["hull", "accent", "frame", "fin", "propeller"]
SPIN_SHARE = 0.2  # screws are drawn at a fifth of their speed: at 20 pictures a second the true one aliases


@dataclass(frozen=True)
class Part:
    """A rigid piece: its mesh about `position`, and the axis about which an actuator turns it, if any."""

    name: str
    role: Role
    mesh: Mesh
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    axis: tuple[float, float, float] | None = None
    actuator: int = -1  # index in the vehicle file's order


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


def parts_of(vehicle: Any, segments: int = 40) -> tuple[Part, ...]:
    """Every part of a vehicle. `segments` around the hull: 40 is round, 20 is light."""
    parts = _myring(vehicle.hull, segments) if vehicle.hull.kind == "myring" else _frame(vehicle.hull)
    for index, actuator in enumerate(vehicle.actuators):
        make = _fin if actuator.kind == "fin" else _thruster
        parts += make(actuator, index, vehicle.hull)
    return tuple(parts)


def joint_angle(feedback_deg: float) -> float:
    """Turn of a fin about its part's axis, rad: positive deflection lifts its leading edge along e_L."""
    return radians(feedback_deg)


def spin_step(shaft_speed_rpm: float, dt_s: float) -> float:
    """Drawn turn of a screw in dt, rad, slowed by SPIN_SHARE."""
    return shaft_speed_rpm / 60.0 * 2.0 * np.pi * SPIN_SHARE * dt_s


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


def _fin(fin: Any, index: int, hull: Any) -> list[Part]:
    angle = radians(fin.radial_direction_deg)
    radial = np.array([0.0, cos(angle), sin(angle)])
    root = max(fin.arm_m - fin.span_m / 2.0, 0.0)
    skin = hull_radius_at(hull, fin.x_m)
    forward = np.array([1.0, 0.0, 0.0])
    mounting = np.stack([forward, np.cross(radial, forward), radial], axis=1)
    blade = mesh.moved(mesh.foil(fin.chord_m, fin.span_m), mounting)
    if root > skin:
        blade = mesh.merge(blade, mesh.rod(radial * (skin - root) * 1.05, radial * 0.01, 0.06 * fin.chord_m))
    x, y, z = np.cross(forward, np.asarray(fin.direction))
    stock = radial * root
    return [Part(fin.name, "fin", blade, (fin.x_m, float(stock[1]), float(stock[2])), (x, y, z), index)]


def _thruster(thruster: Any, index: int, hull: Any) -> list[Part]:
    along = np.asarray(thruster.direction, float)
    along = along / np.linalg.norm(along)
    at = np.asarray(thruster.position_m, float)
    radius = thruster.diameter_m / 2.0
    turn = mesh.frame_along(along)
    hand = -1.0 if thruster.hand == "left" else 1.0
    x, y, z = (float(v) for v in hand * along)
    place = (float(at[0]), float(at[1]), float(at[2]))
    screw = Part(
        thruster.name, "propeller", mesh.moved(mesh.propeller(radius), turn), place, (x, y, z), index
    )
    offset = float(np.hypot(at[1], at[2]))
    if offset < 0.25 * hull.diameter_m and abs(along[0]) > 0.9:  # on the axis, behind the hull: no nozzle
        return [screw]
    housing = mesh.moved(mesh.duct(radius * 1.12, 0.7 * radius), turn)
    skin = hull_radius_at(hull, float(at[0]))
    if offset > skin + radius:
        inward = -np.array([0.0, at[1], at[2]]) / offset
        strut = mesh.rod(inward * radius * 1.08, inward * (offset - 0.9 * skin), 0.12 * radius)
        housing = mesh.merge(housing, strut)
    return [screw, Part(f"{thruster.name}_housing", "frame", housing, place)]
