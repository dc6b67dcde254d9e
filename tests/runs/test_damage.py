"""A log's check sums are held against it: what has changed is left out and said."""

import logging
import shutil
import struct
from pathlib import Path

import pytest
import zstandard
from mcap.records import Chunk, ChunkIndex
from mcap.stream_reader import StreamReader

from bumpless.runs.chunks import LARGEST_CHUNK, DamagedChunk, unpacked
from bumpless.runs.columns import read_columns
from bumpless.runs.read import log_messages
from bumpless.runs.records import read_records
from bumpless.runs.repair import repair
from bumpless.runs.summary import summarise
from tests.runs.flights import Flight


def chunks_of(path: Path) -> list[ChunkIndex]:
    with path.open("rb") as file:
        return [record for record in StreamReader(file).records if isinstance(record, ChunkIndex)]


@pytest.fixture
def flipped(flight: Flight, tmp_path: Path) -> Path:
    """The flight's log with one bit changed in the middle of its second chunk."""
    path = tmp_path / flight.path.name
    shutil.copy(flight.path, path)
    _, second, *_ = chunks_of(path)
    content = bytearray(path.read_bytes())
    content[second.chunk_start_offset + second.chunk_length // 2] ^= 0x10
    path.write_bytes(content)
    return path


def test_a_flipped_bit_changes_no_figure_in_silence(
    flight: Flight, flipped: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """Protects: 49 of 150 flipped bits changed figures and nobody was told."""
    whole = [record.data for _, record in log_messages(flight.path, {"tlm/control"})]
    with caplog.at_level(logging.WARNING):
        left = [record.data for _, record in log_messages(flipped, {"tlm/control"})]
    assert 0 < len(left) < len(whole) and set(left) <= set(whole)
    assert "a chunk is damaged and left out" in caplog.text
    assert "the file has changed since" in summarise(flipped).end_reason
    assert read_records(flight.path, check=True).damage == ""
    assert len(read_columns(flipped).columns) < len(read_columns(flight.path).columns)


def test_a_changed_attachment_is_noticed_too(flight: Flight, tmp_path: Path) -> None:
    """Protects: mission and parameters stand between the chunks and are what a run is judged by."""
    path = tmp_path / "changed.mcap"
    content = flight.path.read_bytes()
    at = content.index(b"version: 1")
    path.write_bytes(content[:at] + b"version: 2" + content[at + 10 :])
    assert "crc validation failed" in read_records(path, check=True).damage


def test_a_repair_leaves_out_what_is_damaged_and_keeps_what_follows(flight: Flight, flipped: Path) -> None:
    """Protects: one bad chunk must not cost all that was recorded after it."""
    last = [record.data for _, record in log_messages(flight.path, {"tlm/control"})][-1]
    repair(flipped)
    assert [record.data for _, record in log_messages(flipped, {"tlm/control"})][-1] == last
    assert read_records(flipped, check=True).damage == ""


def chunk(data: bytes, size: int, crc: int = 0, compression: str = "zstd") -> Chunk:
    return Chunk(
        compression=compression,
        data=data,
        message_start_time=0,
        message_end_time=0,
        uncompressed_crc=crc,
        uncompressed_size=size,
    )


def test_what_unpacks_to_more_than_it_says_is_refused() -> None:
    """Protects: 65 kB grew to 4.3 GB; nothing is unpacked beyond what a chunk says."""
    bomb = zstandard.compress(bytes(200_000_000))
    assert len(bomb) < 65_000
    for size in (10, LARGEST_CHUNK + 1, 4_300_000_000):
        with pytest.raises(DamagedChunk):
            unpacked(chunk(bomb, size))
    with pytest.raises(DamagedChunk, match="compression"):
        unpacked(chunk(b"x", 1, compression="rot13"))
    with pytest.raises(DamagedChunk, match="check sum"):
        unpacked(chunk(b"x", 1, crc=1, compression=""))
    assert unpacked(chunk(zstandard.compress(b"abc"), 3)).data == b"abc"


def test_a_whole_file_of_bombs_is_read_within_bounds(flight: Flight, tmp_path: Path) -> None:
    """Protects: the same in a file: the bomb is one damaged chunk, the rest is read."""
    content = flight.path.read_bytes()
    first = chunks_of(flight.path)[0]
    size_at = first.chunk_start_offset + 9 + 16  # after opcode, length, first and last time
    (told,) = struct.unpack_from("<Q", content, size_at)
    assert told < 10_000_000
    path = tmp_path / "bomb.mcap"
    path.write_bytes(content[:size_at] + struct.pack("<Q", 4_300_000_000) + content[size_at + 8 :])
    assert sum(1 for _ in log_messages(path, {"tlm/control"})) > 0
