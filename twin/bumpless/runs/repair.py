"""Gives a log that was cut off (a killed process, a power cut) its index and end back."""

import os
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from mcap.records import Attachment, Channel, Header, Message, Metadata, Schema
from mcap.writer import CompressionType, Writer

from bumpless.runs.chunks import CUT, header_of, records_of


@dataclass(frozen=True)
class Repair:
    """What was saved from a file that was cut off."""

    messages: int
    attachments: int
    first_ns: int  # log times, UNIX; 0 when there is no message
    last_ns: int


def repair(path: Path) -> Repair:
    """Rewrite `path` with every whole record it still holds; the old file is replaced at the end.

    Bytes and times of messages stay as they are; a chunk whose check sum is wrong is left out.

    Raises ValueError when not even the beginning of an MCAP file is there; the file then stays as it is.
    """
    partial = path.with_name(path.name + ".repair")
    try:
        with path.open("rb") as source, partial.open("wb") as target:
            found = _copy(source, target)
            target.flush()
            os.fsync(target.fileno())
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)
    return found


class Copy:
    """The new file, with ids of schemas and channels kept apart from the old one's."""

    def __init__(self, target: BinaryIO, header: Header) -> None:
        self.writer = Writer(target, compression=CompressionType.ZSTD)
        self.writer.start(profile=header.profile, library=header.library)
        self.schemas: dict[int, int] = {0: 0}
        self.channels: dict[int, int] = {}
        self.messages = self.attachments = self.first_ns = self.last_ns = 0

    def add(self, record: object) -> None:
        """Write one record; what is no part of a log's content is passed over."""
        writer = self.writer
        match record:
            case Schema() if record.id not in self.schemas:
                self.schemas[record.id] = writer.register_schema(record.name, record.encoding, record.data)
            case Channel() if record.id not in self.channels:
                self.channels[record.id] = writer.register_channel(
                    record.topic, record.message_encoding, self.schemas[record.schema_id], record.metadata
                )
            case Message() if record.channel_id in self.channels:
                writer.add_message(
                    channel_id=self.channels[record.channel_id],
                    log_time=record.log_time,
                    data=record.data,
                    publish_time=record.publish_time,
                    sequence=record.sequence,
                )
                self.first_ns = min(self.first_ns or record.log_time, record.log_time)
                self.last_ns = max(self.last_ns, record.log_time)
                self.messages += 1
            case Attachment():
                writer.add_attachment(
                    create_time=record.create_time,
                    log_time=record.log_time,
                    name=record.name,
                    media_type=record.media_type,
                    data=record.data,
                )
                self.attachments += 1
            case Metadata():
                writer.add_metadata(record.name, record.metadata)


def _copy(source: BinaryIO, target: BinaryIO) -> Repair:
    size = os.fstat(source.fileno()).st_size
    records = records_of(source, size)
    header = header_of(records, size)
    copy = Copy(target, header)
    try:
        for record in records:
            copy.add(record)
    except CUT:
        pass  # here the file was cut: what came before is whole
    copy.writer.finish()
    return Repair(copy.messages, copy.attachments, copy.first_ns, copy.last_ns)
