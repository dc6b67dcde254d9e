"""Reads the messages of a log in the order they were written, also of one without its end."""

import logging
from collections.abc import Container, Iterator
from pathlib import Path
from typing import BinaryIO

from mcap.records import Channel, McapRecord, Message

from bumpless.runs.chunks import CUT, header_of, records_of

log = logging.getLogger(__name__)

__all__ = ["CUT", "check_log", "log_messages"]


def log_messages(path: Path, topics: Container[str]) -> Iterator[tuple[str, Message]]:
    """Messages of these topics as (topic, record); stops without complaint where the file was cut.

    What its check sums show to be damaged is left out, with a warning. Raises ValueError when not even the
    beginning of an MCAP file is there.
    """
    wanted: dict[int, str] = {}
    with path.open("rb") as file:
        records = _after_header(file, path)
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
        _after_header(file, path)


def _after_header(file: BinaryIO, path: Path) -> Iterator[McapRecord]:
    size = path.stat().st_size
    records = records_of(file, size, lambda text: log.warning("%s: %s", path.name, text))
    header_of(records, size)
    return records
