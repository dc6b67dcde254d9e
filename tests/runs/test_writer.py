"""Logs hold the bus's own bytes and open in readers that know nothing of Bumpless."""

import hashlib
import json
from pathlib import Path

import pytest
from google.protobuf import descriptor_pb2
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.names import BadName
from bumpless.metrics import as_dict
from bumpless.runs.mcap_file import McapFile
from bumpless.runs.names import record_kind
from bumpless.runs.summary import summarise
from bumpless.runs.writer import RunWriter
from tests.runs.flights import Flight, begin


def test_the_bus_is_kept_byte_by_byte(flight: Flight) -> None:
    """Payload, topic, schema, both times and order are what the bus carried; the outcome comes last."""
    with flight.path.open("rb") as file:
        found = [
            (m.publish_time, c.topic, s.name if s else "", m.data, m.log_time)
            for s, c, m in make_reader(file).iter_messages(log_time_order=False)
            if not c.topic.startswith("/")
        ]
    assert [item[:4] for item in found] == flight.kept
    assert (pb.Event.FromString(found[-1][3]).code, found[-2][1]) == ("outcome", "tlm/mission")
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


def test_metadata_and_attachments_come_back(flight: Flight) -> None:
    """What identifies a run, its end and the files it was made from travel with it; hashes are theirs."""
    with flight.path.open("rb") as file:
        reader = make_reader(file)
        metadata = {record_kind(record.name): record.metadata for record in reader.iter_metadata()}
        attached = {a.name: a.data for a in reader.iter_attachments()}
    run, end = metadata["run"], metadata["end"]
    assert run == flight.run.info.record()
    assert (end["state"], end["outcome"]) == ("complete", str(flight.run.outcome.ending))
    for name, sha256 in (
        ("docking.yaml", run["mission_sha256"]),
        ("ts100.toml", run["vehicle_sha256"]),
        ("parameters.json", run["parameters_sha256"]),
    ):
        assert hashlib.sha256(attached[name]).hexdigest() == sha256
    assert json.loads(attached["metrics.json"]) == as_dict(flight.run.metrics)


def test_no_two_runs_share_a_metadata_name(tmp_path: Path) -> None:
    """Protects: the official merge tool refuses two logs with one metadata name and different content."""
    names = []
    for run in ("run-1", "run-2"):
        path = tmp_path / f"{run}.mcap"
        begin(path, run=run).finish("complete", "")
        with path.open("rb") as file:
            names += [record.name for record in make_reader(file).iter_metadata()]
    assert len(names) == len(set(names)) == 4


@pytest.mark.parametrize("run", ["../../x", "/tmp/x", "", "a" * 129, "x\0y", "x."])
def test_a_run_id_is_never_a_path(tmp_path: Path, run: str) -> None:
    """Protects: what a vehicle calls its run becomes a file's name; nothing is written for a bad one."""
    with pytest.raises(BadName, match="run id"):
        RunWriter(tmp_path / "run.mcap", pb.MissionStatus(run_id=run), run or None)
    assert not list(tmp_path.iterdir())


def test_logs_of_the_first_format_are_still_read(tmp_path: Path) -> None:
    """Protects: older recordings, whose records were named "run" and "end"."""
    path = tmp_path / "old.mcap"
    file = McapFile(path)
    file.metadata("run", {"run_id": "r", "mission": "docking", "started_ns": "7", "server_version": "0"})
    file.metadata("end", {"state": "complete", "reason": "done"})
    file.close()
    found = summarise(path)
    assert (found.run_id, found.mission, found.started_ns) == ("r", "docking", 7)
    assert (found.state, found.end_reason) == ("complete", "done")


def test_messages_of_an_unknown_kind_are_kept(tmp_path: Path) -> None:
    """A newer vehicle may say more than this server knows: the bytes and the name are kept."""
    path = tmp_path / "new.mcap"
    log = begin(path)
    log.write("tlm/sonar", "bumpless.Sonar", b"\x00\x01", 2)
    log.finish("complete", "")
    with path.open("rb") as file:
        ((schema, channel, message),) = list(make_reader(file).iter_messages())
    assert schema is None
    assert channel.metadata["encoding"] == "application/protobuf;bumpless.Sonar"
    assert message.data == b"\x00\x01"
