"""The quick way of packing messages gives mcap's own bytes."""

import io

from hypothesis import given
from hypothesis import strategies as st
from mcap._chunk_builder import ChunkBuilder
from mcap.data_stream import RecordBuilder
from mcap.records import Message
from mcap.writer import Writer

from bumpless.runs.chunk import QuickChunk

TIMES = st.integers(0, 2**63)
MESSAGES = st.builds(
    Message,
    channel_id=st.integers(1, 5),
    log_time=TIMES,
    data=st.binary(max_size=50),
    publish_time=TIMES,
    sequence=st.integers(0, 2**32 - 1),
)


def written(chunk: ChunkBuilder) -> bytes:
    """The index records of a chunk."""
    stream = RecordBuilder()
    for index in chunk.message_indices.values():
        index.write(stream)
    return stream.end()


@given(st.lists(MESSAGES, max_size=20))
def test_a_quick_chunk_is_mcaps_chunk(messages: list[Message]) -> None:
    """Protects: bytes, index and times of a chunk, whatever is in it."""
    quick, plain = QuickChunk(), ChunkBuilder()
    for message in messages:
        quick.add_message(message)
        plain.add_message(message)
    assert written(quick) == written(plain)
    assert quick.num_messages == plain.num_messages and quick.count == plain.count
    assert (quick.message_start_time, quick.message_end_time) == (
        plain.message_start_time,
        plain.message_end_time,
    )
    assert quick.end() == plain.end()


def test_a_writer_takes_it() -> None:
    """Protects: the name inside mcap's Writer; under another name logs would be right but slow."""
    assert isinstance(Writer(io.BytesIO())._Writer__chunk_builder, ChunkBuilder)  # type: ignore[attr-defined]
