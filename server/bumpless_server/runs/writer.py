"""Writes one run to an MCAP file that any reader can open: the bus's bytes as they are, and views of them.

Messages keep their bytes; schemas are complete protobuf descriptor sets; chunks are compressed with
zstd. Beside the bus's own topics stand Foxglove's (`bumpless_server.runs.views`), so that Foxglove and
Lichtblick show the flight as it is. What was flushed survives a killed process; `repair` gives such
a file its end back.
"""

import logging
import os
import time
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from google.protobuf import descriptor_pb2
from google.protobuf.message import Message
from mcap.writer import CompressionType, Writer

from bumpless.contract import keys
from bumpless_server.live.sample import MESSAGES
from bumpless_server.runs.repair import repair
from bumpless_server.runs.views import Views

__all__ = ["LIBRARY", "LogWriter", "repair", "schema_bytes"]

log = logging.getLogger(__name__)

LIBRARY = "bumpless"
RUN_RECORD = "run"  # metadata: what identifies the run
_CHUNK_BYTES = 1 << 20


@cache
def schema_bytes(kind: type[Message]) -> bytes:
    """FileDescriptorSet of a message's file and all that it imports, dependencies first."""
    files = descriptor_pb2.FileDescriptorSet()
    seen: set[str] = set()

    def add(file: Any) -> None:
        if file.name in seen:
            return
        seen.add(file.name)
        for dependency in file.dependencies:
            add(dependency)
        file.CopyToProto(files.file.add())

    add(kind.DESCRIPTOR.file)
    return files.SerializeToString(deterministic=True)


class LogWriter:
    """An MCAP file being written. Not thread-safe.

    `info` identifies the run (hashes of mission, vehicle, parameters, software) and is on the disk
    before the first message. With `views` the Foxglove topics are written too; `ready` says when the
    attainable sets among them may be computed, whose first computation takes seconds.
    """

    def __init__(
        self,
        path: Path,
        info: Mapping[str, str],
        views: bool = True,
        ready: Callable[[], bool] = lambda: True,
    ) -> None:
        self._file = path.open("wb")
        self._writer = Writer(self._file, chunk_size=_CHUNK_BYTES, compression=CompressionType.ZSTD)
        self._schemas: dict[str, int] = {}
        self._channels: dict[tuple[str, str], int] = {}
        self._sequence: dict[int, int] = {}
        self._views = Views(ready) if views else None
        self._closed = False
        self._writer.start(profile="", library=LIBRARY)
        self.metadata(RUN_RECORD, info)
        self.flush()

    def write(self, topic: str, schema: str, payload: bytes, log_ns: int, publish_ns: int) -> None:
        """Add a message of the bus, byte by byte, and what follows from it for the Foxglove topics.

        `schema` is the full message name. One the contract does not know is kept without its schema.
        Times are UNIX times: when it was received, and when the vehicle made it.
        """
        self._add(topic, schema, MESSAGES.get(schema), payload, log_ns, publish_ns)
        if self._views is None:
            return
        try:
            for name, message in self._views.see(topic, schema, payload):
                kind = type(message)
                data = message.SerializeToString()
                self._add(name, kind.DESCRIPTOR.full_name, kind, data, log_ns, publish_ns)
        except OSError:
            raise
        except Exception:  # a view is a convenience: it must never cost the record
            log.exception("the Foxglove topics end here: %s could not be shown", schema)
            self._views = None

    def attach(self, name: str, media_type: str, data: bytes) -> None:
        """Put a whole file into the log: the mission, the vehicle, the metrics."""
        now = time.time_ns()
        self._writer.add_attachment(
            create_time=now, log_time=now, name=name, media_type=media_type, data=data
        )

    def metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Add a metadata record; readers find it by its name."""
        self._writer.add_metadata(name, {key: str(value) for key, value in values.items()})

    def flush(self) -> None:
        """Bring everything to the disk: a killed process or a power cut loses nothing older."""
        self._writer.flush()
        self._file.flush()
        os.fsync(self._file.fileno())

    def close(self) -> None:
        """Write the index and the end of the file."""
        if self._closed:
            return
        self._closed = True
        try:
            self._writer.finish()
            self._file.flush()
            os.fsync(self._file.fileno())
        finally:
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _add(
        self,
        topic: str,
        schema: str,
        kind: type[Message] | None,
        payload: bytes,
        log_ns: int,
        publish_ns: int,
    ) -> None:
        channel = self._channels.get((topic, schema))
        if channel is None:
            channel = self._register(topic, schema, kind)
        sequence = self._sequence[channel]
        self._sequence[channel] = sequence + 1
        self._writer.add_message(
            channel_id=channel, log_time=log_ns, publish_time=publish_ns, sequence=sequence, data=payload
        )

    def _register(self, topic: str, schema: str, kind: type[Message] | None) -> int:
        if schema not in self._schemas:
            self._schemas[schema] = (
                0 if kind is None else self._writer.register_schema(schema, "protobuf", schema_bytes(kind))
            )
        description = {} if kind is not None else {"encoding": keys.ENCODING_PREFIX + schema}
        channel = self._writer.register_channel(topic, "protobuf", self._schemas[schema], description)
        self._channels[topic, schema] = channel
        self._sequence[channel] = 0
        return channel
