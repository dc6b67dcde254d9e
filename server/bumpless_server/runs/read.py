"""Reads the messages of a log in the order they were written, also of one without its end."""

import struct
from collections.abc import Container, Iterator
from pathlib import Path

import zstandard
from mcap.exceptions import McapError
from mcap.records import Channel, Message
from mcap.stream_reader import CRCValidationError, StreamReader

# what reading past the place where a file was cut can raise
CUT = (McapError, CRCValidationError, struct.error, zstandard.ZstdError, UnicodeDecodeError, EOFError)


def log_messages(path: Path, topics: Container[str]) -> Iterator[tuple[str, Message]]:
    """Messages of these topics as (topic, record); stops without complaint where the file was cut.

    Raises ValueError when not even the beginning of an MCAP file is there.
    """
    wanted: dict[int, str] = {}
    with path.open("rb") as file:
        records = iter(StreamReader(file, record_size_limit=path.stat().st_size).records)
        try:
            next(records)  # the header
        except (StopIteration, *CUT) as error:
            raise ValueError(f"not an MCAP file: {error}") from error
        while True:
            try:
                record = next(records)
            except (StopIteration, *CUT):
                return
            if isinstance(record, Channel) and record.topic in topics:
                wanted[record.id] = record.topic
            elif isinstance(record, Message) and record.channel_id in wanted:
                yield wanted[record.channel_id], record
