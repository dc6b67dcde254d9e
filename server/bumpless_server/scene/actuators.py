"""How each kind of actuator is drawn: its parts, and which command moves them."""

from collections.abc import Callable
from math import cos, radians, sin
from typing import Any

import numpy as np

from bumpless_server.scene import mesh
from bumpless_server.scene.hull import hull_radius_at
from bumpless_server.scene.part import Part


def actuator_parts(actuator: Any, command: int, hull: Any) -> list[Part]:
    """Parts of one actuator; `command`: the place in u of its first command.

    Raises: ValueError when the actuator's kind is not known.
    """
    if actuator.kind not in DRAW:
        raise ValueError(f"{actuator.name}: unknown kind of actuator {actuator.kind!r}; {', '.join(DRAW)}")
    return DRAW[actuator.kind](actuator, command, hull)


def _fin(fin: Any, command: int, hull: Any) -> list[Part]:
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
    return [Part(fin.name, "fin", blade, (fin.x_m, float(stock[1]), float(stock[2])), (x, y, z), command)]


def _thruster(thruster: Any, command: int, hull: Any) -> list[Part]:
    along = np.asarray(thruster.direction, float)
    along = along / np.linalg.norm(along)
    at = np.asarray(thruster.position_m, float)
    radius = thruster.diameter_m / 2.0
    turn = mesh.frame_along(along)
    hand = -1.0 if thruster.hand == "left" else 1.0
    x, y, z = (float(v) for v in hand * along)
    place = (float(at[0]), float(at[1]), float(at[2]))
    blades = mesh.moved(mesh.propeller(radius), turn)
    screw = Part(thruster.name, "propeller", blades, place, (x, y, z), command, "spin")
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


DRAW: dict[str, Callable[[Any, int, Any], list[Part]]] = {"fin": _fin, "thruster": _thruster}
