"""An MCAP file being written: messages as they come, schemas and channels by themselves, no clock."""

import os
from collections.abc import Mapping
from pathlib import Path

from google.protobuf.message import Message
from mcap.writer import CompressionType, Writer

from bumpless.contract.keys import ENCODING_PREFIX
from bumpless.contract.messages import descriptor_set
from bumpless.runs.chunk import QuickChunk
from bumpless.runs.names import LIBRARY

_CHUNK_BYTES = 1 << 20


class McapFile:
    """Not thread-safe. What was flushed survives a killed process; `repair` gives such a file its end.

    With `durable` it survives a power cut too: each flush waits for the disk; without, only `close` does.
    """

    def __init__(self, path: Path, durable: bool = True) -> None:
        self._durable = durable
        self._file = path.open("wb")
        self._writer = Writer(
            self._file,
            chunk_size=_CHUNK_BYTES,
            compression=CompressionType.ZSTD,
            enable_data_crcs=True,  # chunks have their own; this vouches for what stands between them
        )
        self._writer._Writer__chunk_builder = QuickChunk()  # type: ignore[attr-defined]
        self._schemas: dict[str, int] = {}
        self._channels: dict[tuple[str, str], int] = {}
        self._sequence: dict[int, int] = {}
        self._closed = False
        self._writer.start(profile="", library=LIBRARY)

    def message(
        self,
        topic: str,
        schema: str,
        kind: type[Message] | None,
        payload: bytes,
        log_ns: int,
        publish_ns: int,
    ) -> None:
        """Add a message; `kind` is the class of `schema`, None when the contract does not know it."""
        channel = self._channels.get((topic, schema))
        if channel is None:
            channel = self._register(topic, schema, kind)
        sequence = self._sequence[channel]
        self._sequence[channel] = sequence + 1
        self._writer.add_message(
            channel_id=channel, log_time=log_ns, publish_time=publish_ns, sequence=sequence, data=payload
        )

    def attach(self, name: str, media_type: str, data: bytes, log_ns: int) -> None:
        """Put a whole file into the log."""
        self._writer.add_attachment(
            create_time=log_ns, log_time=log_ns, name=name, media_type=media_type, data=data
        )

    def metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Add a metadata record; readers find it by its name."""
        self._writer.add_metadata(name, dict(values))

    def flush(self) -> None:
        """Bring everything to the disk: what is killed later loses nothing older."""
        self._writer.flush()
        self._file.flush()
        if self._durable:
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

    def _register(self, topic: str, schema: str, kind: type[Message] | None) -> int:
        if schema not in self._schemas:
            self._schemas[schema] = (
                0 if kind is None else self._writer.register_schema(schema, "protobuf", descriptor_set(kind))
            )
        description = {} if kind is not None else {"encoding": ENCODING_PREFIX + schema}
        channel = self._writer.register_channel(topic, "protobuf", self._schemas[schema], description)
        self._channels[topic, schema] = channel
        self._sequence[channel] = 0
        return channel
