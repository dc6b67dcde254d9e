"""Foxglove's `/scene`: the vehicle's shape, its target, wrench arrows and what its actuators can do.

The shape comes from the vehicle file that the vehicle itself sends. Arrows start at O_b in body axes;
one newton, and one newton metre, is drawn as 0.2 m.
"""

from collections.abc import Callable, Iterator
from math import isfinite, sqrt
from typing import Any

import numpy as np
from foxglove_schemas_protobuf.ArrowPrimitive_pb2 import ArrowPrimitive
from foxglove_schemas_protobuf.Color_pb2 import Color
from foxglove_schemas_protobuf.CubePrimitive_pb2 import CubePrimitive
from foxglove_schemas_protobuf.SceneEntity_pb2 import SceneEntity
from foxglove_schemas_protobuf.SceneUpdate_pb2 import SceneUpdate
from foxglove_schemas_protobuf.TriangleListPrimitive_pb2 import TriangleListPrimitive
from google.protobuf.message import Message

from bumpless.config.problems import ProblemsError
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import model, palette

ARROW_PERIOD_NS = 200_000_000
ENVELOPE_PERIOD_NS = 2_000_000_000
ENVELOPE_DIRECTIONS = 200
METRES_PER_UNIT = 0.2
_POINT_TAG = TriangleListPrimitive.DESCRIPTOR.fields_by_name["points"].number << 3 | 2
_POINT_TAGS = {"tag": _POINT_TAG, "length": 27, "tag_x": 0x09, "tag_y": 0x11, "tag_z": 0x19}
_POINT_WIRE = np.dtype(
    [("tag", "u1"), ("length", "u1")]
    + [pair for axis in "xyz" for pair in ((f"tag_{axis}", "u1"), (axis, "<f8"))]
)
_WANTED = ("bumpless.VehicleDescription", "bumpless.Navigation", "bumpless.Control", "bumpless.Target")
_ROLES = {
    "hull": palette.HULL,
    "accent": palette.TARGET,
    "frame": palette.FRAME,
    "fin": palette.FIN,
    "propeller": palette.PROPELLER,
}


class FoxgloveScene:
    """Fed with the bus's messages; answers with updates of `/scene`.

    `ready` says whether the attainable sets may be computed now: their first computation compiles.
    """

    def __init__(self, ready: Callable[[], bool] = lambda: True) -> None:
        self._ready = ready
        self._description = ""
        self._record: Any = None  # MODEL of the vehicle, for the envelopes
        self._surge_speed = 0.0
        self._arrows_ns = self._envelope_ns = 0
        self._target_drawn = False

    def wants(self, schema: str) -> bool:
        """Whether messages of this kind matter here."""
        return schema in _WANTED

    def see(self, message: Message) -> Iterator[tuple[str, Message]]:
        """Updates that follow from one message, as (topic, message)."""
        entities: list[SceneEntity] = []
        now = message.stamp.time_ns if hasattr(message, "stamp") else 0  # type: ignore[attr-defined]
        if isinstance(message, pb.VehicleDescription):
            entities = self._vehicle(message)
        elif isinstance(message, pb.Navigation):
            self._surge_speed = message.velocity_through_water_body_mps.x
            due = self._record is not None and now - self._envelope_ns >= ENVELOPE_PERIOD_NS
            if due and self._ready():
                self._envelope_ns = now
                entities = _envelopes(self._record, self._surge_speed)
        elif isinstance(message, pb.Control) and now - self._arrows_ns >= ARROW_PERIOD_NS:
            self._arrows_ns = now
            entities = [
                _arrows("demanded", message.demanded, palette.DEMANDED),
                _arrows("achieved", message.achieved, palette.ACHIEVED),
            ]
        elif isinstance(message, pb.Target) and not self._target_drawn:
            self._target_drawn = True
            entities = [_target()]
        if entities:
            for entity in entities:
                entity.timestamp.FromNanoseconds(now)
                entity.frame_locked = True
            yield "/scene", SceneUpdate(entities=entities)

    def _vehicle(self, message: pb.VehicleDescription) -> list[SceneEntity]:
        if message.sha256 == self._description:
            return []
        self._description = message.sha256
        from bumpless.config.vehicle import parse_vehicle
        from bumpless.physics.model import build_model

        try:
            vehicle = parse_vehicle(message.vehicle_toml, f"{message.vehicle_id}.toml")
        except ProblemsError:
            return []  # a vehicle of a newer kind is still recorded, only not drawn
        self._record = build_model(vehicle)
        entity = SceneEntity(id="vehicle", frame_id="body")
        for part in model.parts_of(vehicle, segments=20):
            vertices, faces = part.mesh
            colour = _colour(_ROLES[part.role], 1.0)
            entity.triangles.append(_triangles(vertices + np.asarray(part.position), faces, colour))
        return [entity]


def _envelopes(record: Any, surge_speed_mps: float) -> list[SceneEntity]:
    from bumpless.physics.envelope import attainable_sets

    sets = attainable_sets(record, surge_speed_mps, ENVELOPE_DIRECTIONS)
    made = []
    for name, hull, rgb in (
        ("force", sets.force, palette.FORCE_SET),
        ("moment", sets.moment, palette.MOMENT_SET),
    ):
        entity = SceneEntity(id=f"attainable_{name}", frame_id="body")
        vertices = METRES_PER_UNIT * np.asarray(hull.vertices)
        entity.triangles.append(_triangles(vertices, hull.faces, _colour(rgb, 0.15)))
        made.append(entity)
    return made


def _triangles(vertices: Any, faces: Any, colour: Color) -> TriangleListPrimitive:
    made = TriangleListPrimitive(color=colour, indices=np.asarray(faces).ravel().tolist())
    made.pose.orientation.w = 1.0
    made.MergeFromString(_points(np.asarray(vertices, float)))
    return made


def _points(vertices: np.ndarray) -> bytes:
    """Protobuf's bytes of `points` for (n, 3) vertices: thousands at once take long to be made one by one."""
    wire = np.zeros(len(vertices), _POINT_WIRE)
    for name, byte in _POINT_TAGS.items():
        wire[name] = byte
    wire["x"], wire["y"], wire["z"] = vertices.T
    return wire.tobytes()


def _arrows(name: str, wrench: pb.Wrench, rgb: palette.Rgb) -> SceneEntity:
    entity = SceneEntity(id=name, frame_id="body")
    force = (wrench.x_n, wrench.y_n, wrench.z_n)
    moment = (wrench.k_nm, wrench.m_nm, wrench.n_nm)
    entity.arrows.extend(_arrow(v, w, rgb) for v, w in ((force, 0.03), (moment, 0.015)))
    return entity


def _arrow(vector: tuple[float, float, float], width: float, rgb: palette.Rgb) -> ArrowPrimitive:
    """An arrow from O_b; Foxglove's point along +x, so it is turned from there."""
    x, y, z = (component if isfinite(component) else 0.0 for component in vector)
    length = sqrt(x * x + y * y + z * z)
    made = ArrowPrimitive(
        shaft_length=0.8 * METRES_PER_UNIT * length,
        head_length=0.2 * METRES_PER_UNIT * length,
        shaft_diameter=width,
        head_diameter=2.0 * width,
        color=_colour(rgb, 1.0),
    )
    turn = made.pose.orientation
    along = (x / length, y / length, z / length) if length > 0.0 else (1.0, 0.0, 0.0)
    turn.w, turn.x, turn.y, turn.z = _from_x_axis(*along)
    return made


def _from_x_axis(x: float, y: float, z: float) -> tuple[float, float, float, float]:
    """Scalar-first quaternion of the shortest turn from +x to a unit vector."""
    if x < -0.999999:
        return (0.0, 0.0, 0.0, 1.0)
    norm = sqrt((1.0 + x) * (1.0 + x) + z * z + y * y)
    return ((1.0 + x) / norm, 0.0, -z / norm, y / norm)


def _target() -> SceneEntity:
    entity = SceneEntity(id="target", frame_id="target")
    plate = CubePrimitive(color=_colour(palette.TARGET, 0.9))
    plate.pose.orientation.w = 1.0
    plate.size.x, plate.size.y, plate.size.z = 0.05, 0.6, 0.6
    entity.cubes.append(plate)
    return entity


def _colour(rgb: palette.Rgb, alpha: float) -> Color:
    r, g, b = (value / 255.0 for value in rgb)
    return Color(r=r, g=g, b=b, a=alpha)
