"""A log that was cut off loses only what was not flushed."""

import shutil
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mcap.reader import make_reader

from bumpless.runs.names import record_kind
from bumpless.runs.read import log_messages
from bumpless.runs.repair import repair
from tests.runs.flights import FLUSH_EVERY, Flight, begin


def bus_of(path: Path) -> list[tuple[int, str, bytes]]:
    """Messages of the bus in a whole file, read by the indexed reader."""
    with path.open("rb") as file:
        return [
            (message.publish_time, channel.topic, message.data)
            for _, channel, message in make_reader(file, validate_crcs=True).iter_messages(
                log_time_order=False
            )
            if not channel.topic.startswith("/")
        ]


@settings(max_examples=12, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(share=st.floats(0.01, 0.999))
def test_what_was_flushed_survives_a_cut_anywhere(flight: Flight, tmp_path: Path, share: float) -> None:
    """Cut at any byte: the rebuilt file is clean and holds a beginning of the run, in order."""
    path = tmp_path / "cut.mcap"
    data = flight.path.read_bytes()
    path.write_bytes(data[: int(share * len(data))])
    saved = repair(path)
    found = bus_of(path)
    assert found == [(t, topic, payload) for t, topic, _, payload in flight.kept[: len(found)]]
    assert saved.messages >= len(found)
    assert not list(tmp_path.glob("*.repair"))


def test_a_killed_writer_loses_no_more_than_its_last_second(flight: Flight, tmp_path: Path) -> None:
    """The file as it lies on the disk between two flushes: everything up to the last one is there."""
    path = tmp_path / "killed.mcap"
    writer = begin(tmp_path / "live.mcap")
    for i, (time_ns, topic, schema, payload) in enumerate(flight.bus[:1000]):
        writer.write(topic, schema, payload, time_ns)
        if i % FLUSH_EVERY == 0:
            writer.flush()
            flushed = i + 1
    shutil.copy(tmp_path / "live.mcap", path)
    writer.abandon()
    repair(path)
    assert len(bus_of(path)) >= flushed > 900
    with path.open("rb") as file:
        assert [record.name for record in make_reader(file).iter_metadata()] == ["bumpless.run/live"]


def test_a_whole_file_stays_the_same_run(flight: Flight, tmp_path: Path) -> None:
    """Repairing what is not broken does no harm; attachments and metadata stay."""
    path = tmp_path / "whole.mcap"
    shutil.copy(flight.path, path)
    saved = repair(path)
    assert saved.attachments == 4
    assert bus_of(path) == [(t, topic, payload) for t, topic, _, payload in flight.kept]
    with path.open("rb") as file:
        assert {record_kind(r.name) for r in make_reader(file).iter_metadata()} == {"run", "end"}


@pytest.mark.parametrize("data", [b"", b"\x89MCAP0", b"no log at all" * 10])
def test_what_is_no_log_is_left_alone(tmp_path: Path, data: bytes) -> None:
    """A foreign file is refused and stays as it is."""
    path = tmp_path / "foreign.mcap"
    path.write_bytes(data)
    with pytest.raises(ValueError, match="not an MCAP file"):
        repair(path)
    with pytest.raises(ValueError, match="not an MCAP file"):
        list(log_messages(path, {"tlm/control"}))
    assert path.read_bytes() == data
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_still_being_written_can_be_read(flight: Flight, tmp_path: Path) -> None:
    """Metrics are taken before the end is written: the reader stops where the file does."""
    log = begin(tmp_path / "open.mcap")
    for time_ns, topic, schema, payload in flight.bus[:500]:
        log.write(topic, schema, payload, time_ns)
    log.flush()
    topics = {topic for _, topic, _, _ in flight.bus}
    found = [m.data for _, m in log_messages(tmp_path / "open.mcap", topics)]
    log.abandon()
    assert found == [payload for _, _, _, payload in flight.bus[:500]]
