"""Chunks of a log that nobody vouches for: unpacked within bounds, checked, and left out when damaged."""

import struct
import zlib
from collections.abc import Callable, Iterator
from typing import BinaryIO

import zstandard
from lz4.frame import LZ4FrameDecompressor
from mcap.exceptions import EndOfFile, McapError
from mcap.reader import make_reader
from mcap.records import Chunk, Header, McapRecord
from mcap.stream_reader import CRCValidationError, StreamReader, breakup_chunk

LARGEST_CHUNK = 64_000_000  # bytes unpacked; ours have about one million
Note = Callable[[str], None]

# what reading past the place where a file was cut or changed can raise
CUT = (McapError, CRCValidationError, struct.error, zstandard.ZstdError, UnicodeDecodeError, EOFError)
_DAMAGE = (*CUT, ValueError, RuntimeError, MemoryError, OverflowError)


class NotALog(ValueError):
    """Not even the beginning of an MCAP file."""


class DamagedChunk(ValueError):
    """A chunk whose content is not what was written."""


def records_of(file: BinaryIO, size: int, note: Note = lambda text: None) -> Iterator[McapRecord]:
    """Every record of an open log of `size` bytes, in order; the header first.

    A damaged chunk is left out and noted: its check sum tells, and the others are as good as before.
    Raises one of CUT where the file itself can't be followed further.
    """
    for record in StreamReader(file, emit_chunks=True, record_size_limit=size).records:
        if not isinstance(record, Chunk):
            yield record
            continue
        try:
            inner = breakup_chunk(unpacked(record))
        except _DAMAGE as error:
            note(f"a chunk is damaged and left out: {error or type(error).__name__}")
            yield from _told_again(file)
            continue
        yield from inner


def header_of(records: Iterator[McapRecord], size: int) -> Header:
    """The first of a log's records. Raises NotALog, which says why, where not even that is there.

    size: of the file, bytes.
    """
    try:
        header = next(records)
    except (*CUT, StopIteration) as error:
        raise NotALog(f"not an MCAP file: {_why_none(error, size)}") from error
    if not isinstance(header, Header):
        raise NotALog("not an MCAP file: it does not begin with a header")
    return header


def _why_none(error: Exception, size: int) -> str:
    """In words: what the reader raises is empty, or about its buffers."""
    if size == 0:
        return "it is empty"
    if isinstance(error, struct.error | EndOfFile | StopIteration | EOFError):
        return f"it ends after {size} byte{'s' if size > 1 else ''}, within its header"
    return str(error) or "its beginning is not that of one"


def _told_again(file: BinaryIO) -> Iterator[McapRecord]:
    """Schemas and channels from the end of a whole file: the damaged chunk may have held them."""
    place = file.tell()
    file.seek(0)
    try:
        summary = make_reader(file).get_summary()
    except _DAMAGE:
        summary = None
    file.seek(place)
    if summary is not None:
        yield from summary.schemas.values()
        yield from summary.channels.values()


def unpacked(chunk: Chunk) -> Chunk:
    """The chunk without compression, its check sum tested. Raises DamagedChunk or a codec's error."""
    if chunk.uncompressed_size > LARGEST_CHUNK:
        raise DamagedChunk(f"it says to have {chunk.uncompressed_size} bytes, more than {LARGEST_CHUNK}")
    data = _data(chunk)
    if len(data) != chunk.uncompressed_size:
        raise DamagedChunk("its size is not what it says")
    if chunk.uncompressed_crc and zlib.crc32(data) != chunk.uncompressed_crc:
        raise DamagedChunk("its check sum is not that of its bytes")
    return Chunk(
        compression="",
        data=data,
        message_start_time=chunk.message_start_time,
        message_end_time=chunk.message_end_time,
        uncompressed_crc=chunk.uncompressed_crc,
        uncompressed_size=chunk.uncompressed_size,
    )


def _data(chunk: Chunk) -> bytes:
    most = chunk.uncompressed_size + 1  # one more shows that there is more
    if chunk.compression == "zstd":
        with zstandard.ZstdDecompressor(max_window_size=LARGEST_CHUNK).stream_reader(chunk.data) as reader:
            return reader.read(most)
    if chunk.compression == "lz4":
        return LZ4FrameDecompressor().decompress(chunk.data, max_length=most)
    if chunk.compression:
        raise DamagedChunk(f"nobody knows the compression {chunk.compression!r}")
    return chunk.data


def damage_of(file: BinaryIO, size: int) -> list[str]:
    """What of a log is not as it was written, by its check sums; empty when all is well."""
    found: list[str] = []
    try:
        for record in StreamReader(
            file, emit_chunks=True, validate_crcs=True, record_size_limit=size
        ).records:
            if isinstance(record, Chunk):
                try:
                    unpacked(record)
                except _DAMAGE as error:
                    found.append(f"a chunk is damaged: {error or type(error).__name__}")
    except CUT as error:
        found.append(str(error) or type(error).__name__)
    return found
