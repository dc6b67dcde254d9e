"""Reads the messages of a log in the order they were written, also of one without its end."""

import struct
from collections.abc import Container, Iterator
from pathlib import Path
from typing import BinaryIO

import zstandard
from mcap.exceptions import McapError
from mcap.records import Channel, McapRecord, Message
from mcap.stream_reader import CRCValidationError, StreamReader

# what reading past the place where a file was cut can raise
CUT = (McapError, CRCValidationError, struct.error, zstandard.ZstdError, UnicodeDecodeError, EOFError)


def log_messages(path: Path, topics: Container[str]) -> Iterator[tuple[str, Message]]:
    """Messages of these topics as (topic, record); stops without complaint where the file was cut.

    Raises ValueError when not even the beginning of an MCAP file is there.
    """
    wanted: dict[int, str] = {}
    with path.open("rb") as file:
        records = _after_header(file, path.stat().st_size)
        while True:
            try:
                record = next(records)
            except (StopIteration, *CUT):
                return
            if isinstance(record, Channel) and record.topic in topics:
                wanted[record.id] = record.topic
            elif isinstance(record, Message) and record.channel_id in wanted:
                yield wanted[record.channel_id], record


def check_log(path: Path) -> None:
    """Raise ValueError when not even the beginning of an MCAP file is there."""
    with path.open("rb") as file:
        _after_header(file, path.stat().st_size)


def _after_header(file: BinaryIO, size: int) -> Iterator[McapRecord]:
    records = iter(StreamReader(file, record_size_limit=size).records)
    try:
        next(records)
    except (StopIteration, *CUT) as error:
        raise ValueError(f"not an MCAP file: {error}") from error
    return records
