"""Logs of other recorders: ours by their messages' names, whatever they call their topics."""

from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap.writer import Writer

from bumpless import open_run
from bumpless.runs.adopt import NotOurs, adopt
from bumpless.runs.replay import Replay
from tests.runs.flights import Flight


def foreign(flight: Flight, path: Path, schema: bool = True) -> Path:
    """The flight as a recorder of the bus might write it: whole keys for topics, no records or files."""
    from bumpless.contract.messages import MESSAGES, descriptor_set

    with path.open("wb") as file:
        writer = Writer(file)
        writer.start()
        channels: dict[str, int] = {}
        for time_ns, topic, name, payload in flight.bus:
            if topic not in channels:
                known = (
                    writer.register_schema(name, "protobuf", descriptor_set(MESSAGES[name])) if schema else 0
                )
                metadata = {} if schema else {"encoding": f"application/protobuf;{name}"}
                channels[topic] = writer.register_channel(
                    f"bumpless/ts100/{topic}", "protobuf", known, metadata
                )
            writer.add_message(channels[topic], time_ns, payload, time_ns)
        writer.finish()
    return path


@pytest.mark.parametrize("schema", [True, False])
def test_another_recorders_log_becomes_ours(flight: Flight, tmp_path: Path, schema: bool) -> None:
    """Protects flights that a vehicle recorded itself: figures and replay are those of our own log."""
    source = foreign(flight, tmp_path / "theirs.mcap", schema)
    assert adopt(source, tmp_path / "ours.mcap")
    assert not source.exists()
    run = open_run(tmp_path / "ours.mcap")
    assert run.metrics.d_u_rh == open_run(flight.path).metrics.d_u_rh
    replay = Replay(tmp_path / "ours.mcap")
    assert replay.cycles == open_run(flight.path).metrics.cycles
    replay.close()


def test_one_of_ours_is_only_moved(flight: Flight, tmp_path: Path) -> None:
    """Protects its bytes, and so its hash."""
    data = flight.path.read_bytes()
    (tmp_path / "in.mcap").write_bytes(data)
    assert not adopt(tmp_path / "in.mcap", tmp_path / "out.mcap")
    assert (tmp_path / "out.mcap").read_bytes() == data


def test_one_that_was_cut_off_gets_its_end(flight: Flight, tmp_path: Path) -> None:
    """Protects what is left of a flight whose recorder died."""
    data = flight.path.read_bytes()
    (tmp_path / "in.mcap").write_bytes(data[: len(data) * 2 // 3])
    adopt(tmp_path / "in.mcap", tmp_path / "out.mcap")
    with (tmp_path / "out.mcap").open("rb") as file:
        assert make_reader(file).get_summary() is not None


def other(path: Path) -> bytes:
    """A whole log without a message of ours."""
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start()
        schema = writer.register_schema("std_msgs/String", "ros1msg", b"string data")
        channel = writer.register_channel("/chatter", "ros1", schema)
        writer.add_message(channel, 1, b"hello", 1)
        writer.finish()
    return path.read_bytes()


def test_what_is_not_ours_is_refused(tmp_path: Path) -> None:
    """Protects the list from strange and hostile files; what was brought stays where it was."""
    for data in (b"", b"PK\x03\x04", b"\x89MCAP0\r\n" + b"\xff" * 999, other(tmp_path / "other.mcap")):
        source = tmp_path / "in.mcap"
        source.write_bytes(data)
        with pytest.raises(NotOurs):
            adopt(source, tmp_path / "out.mcap")
        assert source.read_bytes() == data
        assert not (tmp_path / "out.mcap").exists()
        assert not list(tmp_path.glob("*.part"))
