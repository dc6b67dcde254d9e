"""The Foxglove topics show the same flight as the bus."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from google.protobuf.descriptor import FieldDescriptor
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from scipy.spatial.transform import Rotation

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless_server.views import foxglove
from bumpless_server.views.foxglove import Foxglove
from bumpless_server.views.foxglove_scene import METRES_PER_UNIT, FoxgloveScene
from tests.runs.flights import Flight, begin

LAYOUT = Path(foxglove.__file__).with_name("foxglove_layout.json")


@pytest.fixture(scope="module")
def shown(flight: Flight) -> dict[str, list[Any]]:
    """Decoded messages of the log by topic."""
    found: dict[str, list[Any]] = {}
    with flight.path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for _, channel, _, message in reader.iter_decoded_messages():
            found.setdefault(channel.topic, []).append(message)
    return found


def rotation(message: Any) -> Rotation:
    return Rotation.from_quat([message.x, message.y, message.z, message.w])


FOXGLOVE = {
    "/tf": "foxglove.FrameTransforms",
    "/pose": "foxglove.PoseInFrame",
    "/path/planned": "foxglove.PosesInFrame",
    "/path/track": "foxglove.PosesInFrame",
    "/scene": "foxglove.SceneUpdate",
    "/log": "foxglove.Log",
}


def test_each_topic_has_foxgloves_own_message(shown: dict[str, list[Any]]) -> None:
    """Foxglove and Lichtblick show a topic by the name of its message."""
    found = {topic: messages[0].DESCRIPTOR.full_name for topic, messages in shown.items() if topic[0] == "/"}
    assert found == FOXGLOVE


class Broken(Foxglove):
    """A view that fails."""

    def see(self, message: Any) -> Any:
        raise ValueError("cannot be shown")


def test_a_view_that_fails_ends_and_the_record_goes_on(tmp_path: Path) -> None:
    """Protects: a picture must never cost the record, nor another picture."""
    path, good = tmp_path / "run.mcap", pb.Navigation(stamp=pb.Stamp(time_ns=3)).SerializeToString()
    log = begin(path, [Broken(), Foxglove()])
    for at in (4, 5):
        log.write("tlm/navigation", "bumpless.Navigation", good, at)
    log.finish("complete", "")
    with path.open("rb") as file:
        topics = [channel.topic for _, channel, _ in make_reader(file).iter_messages()]
    assert topics.count("tlm/navigation") == topics.count("/pose") == 2


def test_broken_payloads_are_kept_and_show_nothing(tmp_path: Path) -> None:
    """What cannot be decoded is still evidence; the views skip it and go on."""
    path = tmp_path / "broken.mcap"
    good = pb.Navigation(stamp=pb.Stamp(time_ns=3)).SerializeToString()
    log = begin(path, [Foxglove()])
    log.write("tlm/navigation", "bumpless.Navigation", b"\xff\xff", 2)
    log.write("tlm/navigation", "bumpless.Navigation", good, 4)
    log.finish("complete", "")
    with path.open("rb") as file:
        topics = [channel.topic for _, channel, _ in make_reader(file).iter_messages()]
    assert topics.count("tlm/navigation") == 2
    assert topics.count("/pose") == 1


def test_the_pose_is_the_navigation(flight: Flight, shown: dict[str, list[Any]]) -> None:
    """Position and attitude of each cycle, against SciPy's own Euler angles."""
    for row, pose in zip(flight.result.log[::50], shown["/pose"][::50], strict=True):
        at = pose.pose.position
        assert [at.x, at.y, at.z] == pytest.approx(row["eta_hat"][:3].tolist())
        turned = Rotation.from_euler("ZYX", row["eta_hat"][[5, 4, 3]])
        assert (rotation(pose.pose.orientation).inv() * turned).magnitude() < 1e-9


def test_ned_hangs_upside_down_in_a_world_whose_z_is_up() -> None:
    """Viewers expect z up: north becomes y, east x, and down -z."""
    message = pb.Navigation(stamp=pb.Stamp(time_ns=1))
    tf = dict(Foxglove().see(message))["/tf"]
    world = next(t for t in tf.transforms if t.child_frame_id == "ned")  # type: ignore[attr-defined]
    assert world.parent_frame_id == "map"
    np.testing.assert_allclose(rotation(world.rotation).apply([1, 2, 3]), [2, 1, -3], atol=1e-12)


def test_the_track_grows_and_stays_bounded(shown: dict[str, list[Any]]) -> None:
    """The whole way so far, thinned out instead of growing without end."""
    lengths = [len(path.poses) for path in shown["/path/track"]]
    assert lengths == sorted(lengths)
    views, longest = Foxglove(), 0
    for second in range(3000):
        message = pb.Navigation(stamp=pb.Stamp(time_ns=second * 1_000_000_000 + 1))
        for topic, view in views.see(message):
            longest = max(longest, len(view.poses)) if topic == "/path/track" else longest  # type: ignore[attr-defined]
    assert 200 <= longest <= 401


def test_events_are_log_lines(shown: dict[str, list[Any]]) -> None:
    """Every event of the vehicle is one line, in order."""
    assert [line.message for line in shown["/log"]] == [event.text for event in shown["event"]]
    assert any("everse to hover" in line.message for line in shown["/log"])


def test_arrows_point_along_the_wrench() -> None:
    """Drawn from O_b along the force, METRES_PER_UNIT for each newton."""
    scene = FoxgloveScene()
    for i, force in enumerate(([3.0, 0, 0], [-2.0, 0, 0], [0, 0, 1.5], [1.0, -1.0, 0.5])):
        wrench = pb.Wrench(x_n=force[0], y_n=force[1], z_n=force[2])
        control = pb.Control(stamp=pb.Stamp(time_ns=(i + 1) * 1_000_000_000), demanded=wrench)
        ((_, update),) = list(scene.see(control))
        arrow = update.entities[0].arrows[0]  # type: ignore[attr-defined]
        tip = rotation(arrow.pose.orientation).apply([arrow.shaft_length + arrow.head_length, 0, 0])
        np.testing.assert_allclose(tip, METRES_PER_UNIT * np.array(force), atol=1e-9)


def test_the_scene_has_the_vehicle_its_target_and_its_sets(shown: dict[str, list[Any]]) -> None:
    """Drawn from the vehicle file that the vehicle sent; every index names a point."""
    entities = {entity.id: entity for update in shown["/scene"] for entity in update.entities}
    assert set(entities) == {
        "vehicle",
        "target",
        "demanded",
        "achieved",
        "attainable_force",
        "attainable_moment",
    }
    assert len(entities["vehicle"].triangles) >= 8
    for entity in entities.values():
        for triangles in entity.triangles:
            assert max(triangles.indices) < len(triangles.points)


def paths_of(layout: dict[str, Any]) -> Iterator[str]:
    for panel in layout["configById"].values():
        yield from (path["value"] for path in panel.get("paths", []))


def field_at(kind: Any, path: str) -> FieldDescriptor:
    name, _, rest = path.partition(".")
    field = kind.fields_by_name[name.partition("[")[0]]
    return field_at(field.message_type, rest) if rest else field


def test_the_layout_shows_what_logs_contain(shown: dict[str, list[Any]]) -> None:
    """Each plotted path is a field of the contract, each switched-on topic is written."""
    layout = json.loads(LAYOUT.read_text(encoding="utf-8"))
    for path in paths_of(layout):
        topic, _, rest = path.partition(".")
        assert field_at(TOPICS[topic.removeprefix("tlm/")].message.DESCRIPTOR, rest)
    assert set(layout["configById"]["3D!bumpless"]["topics"]) <= set(shown)
