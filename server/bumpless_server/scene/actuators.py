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


def _azimuth(pod: Any, command: int, hull: Any) -> list[Part]:
    """A strut on the hull, a ducted pod that turns about it, and a screw that the pod carries around."""
    radius = pod.diameter_m / 2.0
    hand = -1.0 if pod.hand == "left" else 1.0
    body = mesh.rod((0.9 * radius, 0, 0), (-2.2 * radius, 0, 0), 0.3 * radius)
    stock = mesh.rod((-1.4 * radius, 0, -0.9 * radius), (-1.4 * radius, 0, 0), 0.16 * radius)
    housing = mesh.merge(mesh.duct(radius * 1.12, 0.7 * radius), body, stock)
    place = (float(pod.position_m[0]), float(pod.position_m[1]), float(pod.position_m[2]))
    parts = [
        Part(f"{pod.name}_pod", "fin", housing, place, (0.0, 0.0, 1.0), command + 1),
        Part(
            pod.name,
            "propeller",
            mesh.propeller(radius),
            place,
            (hand, 0.0, 0.0),
            command,
            "spin",
            f"{pod.name}_pod",
        ),
    ]
    offset, skin = float(np.hypot(place[1], place[2])), hull_radius_at(hull, place[0])
    if offset > skin:
        inward = -np.array([0.0, place[1], place[2]]) / offset
        strut = mesh.rod((0.0, 0.0, 0.0), inward * (offset - 0.9 * skin), 0.12 * radius)
        parts.append(Part(f"{pod.name}_strut", "frame", strut, place))
    return parts


DRAW: dict[str, Callable[[Any, int, Any], list[Part]]] = {
    "fin": _fin,
    "thruster": _thruster,
    "azimuth": _azimuth,
}
