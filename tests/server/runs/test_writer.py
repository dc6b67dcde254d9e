"""Logs hold the bus's own bytes and open in readers that know nothing of Bumpless."""

from pathlib import Path

from google.protobuf import descriptor_pb2
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.runs.writer import LogWriter

from .conftest import Flight

FOXGLOVE = {
    "/tf": "foxglove.FrameTransforms",
    "/pose": "foxglove.PoseInFrame",
    "/path/planned": "foxglove.PosesInFrame",
    "/path/track": "foxglove.PosesInFrame",
    "/scene": "foxglove.SceneUpdate",
    "/log": "foxglove.Log",
}


def test_the_bus_is_kept_byte_by_byte(flight: Flight) -> None:
    """Payload, topic, schema, both times and order are what the bus carried."""
    with flight.path.open("rb") as file:
        found = [
            (m.publish_time, c.topic, s.name if s else "", m.data, m.log_time)
            for s, c, m in make_reader(file).iter_messages(log_time_order=False)
            if not c.topic.startswith("/")
        ]
    assert [item[:4] for item in found] == flight.bus
    assert all(logged == published + 1000 for published, _, _, _, logged in found)


def test_sequences_count_each_topic(flight: Flight) -> None:
    """A hole in a topic's numbers would be a lost message."""
    numbers: dict[str, list[int]] = {}
    with flight.path.open("rb") as file:
        for _, channel, message in make_reader(file).iter_messages(log_time_order=False):
            numbers.setdefault(channel.topic, []).append(message.sequence)
    assert all(found == list(range(len(found))) for found in numbers.values())


def test_schemas_are_complete_and_chunks_are_zstd(flight: Flight) -> None:
    """A reader needs nothing but the file: every schema brings its imports, dependencies first."""
    with flight.path.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    for schema in summary.schemas.values():
        files = descriptor_pb2.FileDescriptorSet.FromString(schema.data).file
        seen: set[str] = set()
        for one in files:
            assert set(one.dependency) <= seen
            seen.add(one.name)
        assert schema.encoding == "protobuf"
    assert {chunk.compression for chunk in summary.chunk_indexes} == {"zstd"}


def test_an_independent_decoder_reads_every_message(flight: Flight) -> None:
    """mcap-protobuf-support decodes all topics from the file's own schemas."""
    counts: dict[str, int] = {}
    with flight.path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for schema, channel, _, message in reader.iter_decoded_messages():
            assert schema is not None
            assert message.DESCRIPTOR.full_name == schema.name
            counts[channel.topic] = counts.get(channel.topic, 0) + 1
    assert counts["tlm/control"] == len(flight.result.log)
    assert set(FOXGLOVE) <= set(counts)


def test_metadata_and_attachments_come_back(flight: Flight) -> None:
    """Hashes and the mission itself travel with the log."""
    with flight.path.open("rb") as file:
        reader = make_reader(file)
        metadata = {record.name: record.metadata for record in reader.iter_metadata()}
        attached = {a.name: a.data for a in reader.iter_attachments()}
    assert metadata["run"]["mission_sha256"] == flight.result.mission.sha256
    assert metadata["end"] == {"state": "complete"}
    assert attached["docking.yaml"].decode() == flight.result.mission.text


def test_messages_of_an_unknown_kind_are_kept(tmp_path: Path) -> None:
    """A newer vehicle may say more than this server knows: the bytes and the name are kept."""
    path = tmp_path / "new.mcap"
    with LogWriter(path, {}) as log:
        log.write("tlm/sonar", "bumpless.Sonar", b"\x00\x01", 2, 1)
    with path.open("rb") as file:
        ((schema, channel, message),) = list(make_reader(file).iter_messages())
    assert schema is None
    assert channel.metadata["encoding"] == "application/protobuf;bumpless.Sonar"
    assert message.data == b"\x00\x01"


def test_broken_payloads_are_kept_and_show_nothing(tmp_path: Path) -> None:
    """What cannot be decoded is still evidence; the views skip it and go on."""
    path = tmp_path / "broken.mcap"
    good = pb.Navigation(stamp=pb.Stamp(time_ns=3)).SerializeToString()
    with LogWriter(path, {}) as log:
        log.write("tlm/navigation", "bumpless.Navigation", b"\xff\xff", 2, 1)
        log.write("tlm/navigation", "bumpless.Navigation", good, 4, 3)
    with path.open("rb") as file:
        topics = [channel.topic for _, channel, _ in make_reader(file).iter_messages()]
    assert topics.count("tlm/navigation") == 2
    assert topics.count("/pose") == 1
