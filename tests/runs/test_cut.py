"""A range of a log as a log of its own, also of one being written or that nobody vouches for."""

from pathlib import Path

import pytest
from mcap.reader import make_reader

from bumpless import open_run
from bumpless.runs.cut import Range, cut
from bumpless.runs.records import is_whole, read_records
from tests.runs.flights import FLUSH_EVERY, START_NS, Flight, begin


def times(path: Path, topic: str) -> list[float]:
    """Log times of a topic after the flight's start, s, by the official reader and its index."""
    with path.open("rb") as file:
        reader = make_reader(file)
        assert reader.get_summary() is not None
        return [(m.log_time - START_NS) * 1e-9 for _, _, m in reader.iter_messages(topics=[topic])]


def test_a_range_holds_its_cycles_and_what_they_need(flight: Flight, tmp_path: Path) -> None:
    """Protects excerpts that are sent: both ends in, nothing else, and vehicle, plan and parameters."""
    target = tmp_path / "part.mcap"
    cut(flight.path, target, Range(10.0, 20.0))
    at = times(target, "tlm/navigation")
    assert at[0] == pytest.approx(10.0, abs=1e-3) and at[-1] == pytest.approx(20.0, abs=1e-3)
    assert len(at) == 201
    part, whole = open_run(target), open_run(flight.path)
    assert part.vehicle == whole.vehicle and part.mission == whole.mission
    assert part.info.run_id == whole.info.run_id
    assert part.parameters == whole.parameters


def test_figures_of_the_whole_run_are_not_those_of_a_part(flight: Flight, tmp_path: Path) -> None:
    """Protects from an excerpt that claims to have docked."""
    target = tmp_path / "part.mcap"
    cut(flight.path, target, Range(10.0, 20.0))
    found = read_records(target)
    assert "metrics.json" not in found.attachments
    assert found.end["reason"] == "an excerpt, 10 s to 20 s"
    assert open_run(target).outcome.ending.value == "interrupted"


def test_one_being_written_becomes_whole(flight: Flight, tmp_path: Path) -> None:
    """Protects the export of a running flight: footer and summary, so that official readers open it."""
    writer = begin(tmp_path / "running.mcap")
    for i, (time_ns, topic, schema, payload) in enumerate(flight.bus[: 20 * FLUSH_EVERY]):
        writer.write(topic, schema, payload, time_ns)
        if i % FLUSH_EVERY == FLUSH_EVERY - 1:
            writer.flush()
    assert not is_whole(writer.path)
    target = tmp_path / "so_far.mcap"
    count = cut(writer.path, target, Range())
    writer.abandon()
    assert is_whole(target) and count == 20 * FLUSH_EVERY
    assert len(times(target, "tlm/navigation")) > 100


@pytest.mark.parametrize("data", [b"", b"not a log at all", b"\x89MCAP0\r\n" + b"\xff" * 4000])
def test_what_is_no_log_is_refused(data: bytes, tmp_path: Path) -> None:
    """Protects from hostile files: one sentence, and nothing left behind."""
    source = tmp_path / "bad.mcap"
    source.write_bytes(data)
    with pytest.raises(ValueError):
        cut(source, tmp_path / "out.mcap", Range())
    assert [path.name for path in tmp_path.iterdir()] == ["bad.mcap"]


def test_a_range_without_anything_is_refused(flight: Flight, tmp_path: Path) -> None:
    """Protects from an empty file that looks like a flight."""
    with pytest.raises(ValueError, match="nothing in the range"):
        cut(flight.path, tmp_path / "out.mcap", Range(1e6))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("text", ["", "10", "a:b", "20:10", "nan:1"])
def test_ranges_that_are_none(text: str) -> None:
    """Protects the command line from half-understood ranges."""
    with pytest.raises(ValueError, match="FROM:TO"):
        Range.read(text)
    assert Range.read("10:") == Range(10.0) and Range.read(":20") == Range(to_s=20.0)
