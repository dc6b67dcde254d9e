"""The flight in Foxglove's own messages, derived from the bus: poses, paths, log lines, the scene.

Frames: "map" is east-north-up (what viewers expect), "ned" and "body" hang from it. Coordinates inside
a message are those of its frame, so `/pose` in "ned" reads like the bus.
"""

from collections.abc import Callable, Iterator
from importlib import resources
from math import sqrt
from typing import Any

from foxglove_schemas_protobuf.FrameTransform_pb2 import FrameTransform
from foxglove_schemas_protobuf.FrameTransforms_pb2 import FrameTransforms
from foxglove_schemas_protobuf.Log_pb2 import Log
from foxglove_schemas_protobuf.Pose_pb2 import Pose
from foxglove_schemas_protobuf.PoseInFrame_pb2 import PoseInFrame
from foxglove_schemas_protobuf.PosesInFrame_pb2 import PosesInFrame
from foxglove_schemas_protobuf.Quaternion_pb2 import Quaternion
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import pose
from bumpless_server.views.foxglove_scene import FoxgloveScene

LAYOUT = "foxglove_layout.json"
WORLD, NED, BODY, TARGET = "map", "ned", "body", "target"
TRACK_PERIOD_NS = 2_000_000_000  # of /path/track, the whole way so far
TRACK_POSES = 400  # every second one goes when there are more
_HALF = sqrt(0.5)
_LEVELS = {pb.SEVERITY_INFO: Log.INFO, pb.SEVERITY_WARNING: Log.WARNING, pb.SEVERITY_ALARM: Log.ERROR}

View = tuple[str, Message]


class Foxglove:
    """Fed with every message of the bus in its order; answers with what follows from it.

    `ready`: see `FoxgloveScene`.
    """

    def __init__(self, ready: Callable[[], bool] = lambda: True) -> None:
        self._makers: dict[str, Callable[[Any], Iterator[View]]] = {
            "bumpless.Navigation": self._navigation,
            "bumpless.Plan": self._plan,
            "bumpless.Target": self._target,
            "bumpless.Event": self._event,
        }
        self._scene = FoxgloveScene(ready)
        self._track: list[Pose] = []
        self._track_step_ns = 500_000_000
        self._track_ns = self._track_sent_ns = 0
        self._plan_sha256 = ""
        self._target_at: tuple[float, ...] = ()

    def wants(self, schema: str) -> bool:
        """Whether messages of this full name are shown."""
        return schema in self._makers or self._scene.wants(schema)

    def see(self, message: Message) -> Iterator[View]:
        """Foxglove messages that follow from one message of the bus, as (topic, message)."""
        maker = self._makers.get(message.DESCRIPTOR.full_name)
        if maker is not None:
            yield from maker(message)
        yield from self._scene.see(message)

    def _navigation(self, message: pb.Navigation) -> Iterator[View]:
        now = message.stamp.time_ns
        here = _pose(message.position_ned_m, pose.of_attitude(message.attitude))
        world = FrameTransform(parent_frame_id=WORLD, child_frame_id=NED)
        world.rotation.CopyFrom(Quaternion(x=_HALF, y=_HALF, z=0.0, w=0.0))  # NED from ENU
        body = FrameTransform(parent_frame_id=NED, child_frame_id=BODY)
        body.translation.x, body.translation.y, body.translation.z = (
            here.position.x,
            here.position.y,
            here.position.z,
        )
        body.rotation.CopyFrom(here.orientation)
        for transform in (world, body):
            transform.timestamp.FromNanoseconds(now)
        yield "/tf", FrameTransforms(transforms=[world, body])
        placed = PoseInFrame(frame_id=NED, pose=here)
        placed.timestamp.FromNanoseconds(now)
        yield "/pose", placed
        yield from self._add_to_track(here, now)

    def _add_to_track(self, here: Pose, now: int) -> Iterator[View]:
        if now - self._track_ns >= self._track_step_ns:
            self._track_ns = now
            self._track.append(here)
            if len(self._track) > TRACK_POSES:
                self._track = self._track[::2]
                self._track_step_ns *= 2
        if now - self._track_sent_ns >= TRACK_PERIOD_NS:
            self._track_sent_ns = now
            yield "/path/track", _path(self._track, now)

    def _plan(self, message: pb.Plan) -> Iterator[View]:
        if message.sha256 != self._plan_sha256:
            self._plan_sha256 = message.sha256
            poses = [_pose(point, (1.0, 0.0, 0.0, 0.0)) for point in message.path_ned_m]
            yield "/path/planned", _path(poses, message.stamp.time_ns)

    def _target(self, message: pb.Target) -> Iterator[View]:
        at = message.position_ned_m
        place = (at.x, at.y, at.z, message.heading_deg)
        if place == self._target_at:
            return
        self._target_at = place
        transform = FrameTransform(parent_frame_id=NED, child_frame_id=TARGET)
        transform.timestamp.FromNanoseconds(message.stamp.time_ns)
        here = _pose(at, pose.of_heading(message.heading_deg))
        transform.translation.x, transform.translation.y, transform.translation.z = at.x, at.y, at.z
        transform.rotation.CopyFrom(here.orientation)
        yield "/tf", FrameTransforms(transforms=[transform])

    def _event(self, message: pb.Event) -> Iterator[View]:
        line = Log(level=_LEVELS.get(message.severity, Log.UNKNOWN), message=message.text, name=message.code)
        line.timestamp.FromNanoseconds(message.stamp.time_ns)
        yield "/log", line


def _pose(position: pb.Vector3, rotation: pose.Quaternion) -> Pose:
    """A contract position and a scalar-first quaternion as Foxglove's pose."""
    made = Pose()
    made.position.x, made.position.y, made.position.z = position.x, position.y, position.z
    w, x, y, z = rotation
    made.orientation.CopyFrom(Quaternion(x=x, y=y, z=z, w=w))
    return made


def _path(poses: list[Pose], now: int) -> PosesInFrame:
    path = PosesInFrame(frame_id=NED, poses=poses)
    path.timestamp.FromNanoseconds(now)
    return path


def layout() -> bytes:
    """A layout for our logs in Foxglove and Lichtblick."""
    return (resources.files("bumpless_server.views") / LAYOUT).read_bytes()
