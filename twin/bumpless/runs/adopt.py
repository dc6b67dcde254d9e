"""A log that somebody else recorded, made one of ours: whoever wrote it, it must hold our messages.

A recorder on the bus may name topics by their whole key, "bumpless/ts100/tlm/navigation", or as it likes. The
message's full name says which of our topics that is. Bytes and times stay as they are.
"""

import os
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

from mcap.records import Channel, Schema

from bumpless.config.whole import whole
from bumpless.contract.keys import ENCODING_PREFIX, SAID
from bumpless.runs.chunks import CUT, NotALog, header_of, records_of
from bumpless.runs.records import is_whole, read_records
from bumpless.runs.repair import Copy

TOPIC_OF = {kind.DESCRIPTOR.full_name: topic for topic, kind in SAID.items()}


class NotOurs(ValueError):
    """No log, or one without any message of our contract; the text says so for people."""


def adopt(source: Path, target: Path) -> bool:
    """Make `target` of `source`, which is taken away unless it is the same; True when topics were renamed.

    One that is whole and ours already is only moved. Raises NotOurs; `source` then stays.
    """
    if is_whole(source) and read_records(source).run:
        os.replace(source, target)
        return False
    with source.open("rb") as file, whole(target) as partial, partial.open("wb") as out:
        renamed = _copy(file, out, source.stat().st_size)
        out.flush()
    if source != target:
        source.unlink()
    return renamed


def _copy(file: BinaryIO, out: BinaryIO, size: int) -> bool:
    records = records_of(file, size)
    try:
        header = header_of(records, size)
    except NotALog as error:
        raise NotOurs(str(error)) from error
    copy, schemas, ours, renamed = Copy(out, header), dict[int, str](), False, False
    try:
        for record in records:
            if isinstance(record, Schema):
                schemas.setdefault(record.id, record.name)
            elif isinstance(record, Channel):
                topic = TOPIC_OF.get(_name(record, schemas))
                if topic is not None and record.message_encoding == "protobuf":
                    ours = True
                    renamed |= topic != record.topic
                    record = replace(record, topic=topic)
            copy.add(record)
    except CUT:
        pass  # here the file was cut: what came before is whole
    if not ours:
        raise NotOurs("it holds no message of bumpless.proto, such as bumpless.Navigation")
    copy.writer.finish()
    return renamed


def _name(channel: Channel, schemas: dict[int, str]) -> str:
    """Full name of a channel's messages; a recorder of the bus may only have kept Zenoh's encoding."""
    told = channel.metadata.get("encoding", "")
    return schemas.get(channel.schema_id) or told.removeprefix(ENCODING_PREFIX)
