"""Any moment and any range of a log, without reading the rest: by the index at its end.

Only chunks that are asked for are unpacked, so that a two-hour log opens and seeks as a short one does.
Times are mission times, s; the log's own times lead to them.
"""

import struct
import threading
from collections import OrderedDict
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import zstandard
from mcap.reader import make_reader
from mcap.records import ChunkIndex

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import SAID
from bumpless.contract.messages import stamp_of
from bumpless.metrics.columns import GAP_S
from bumpless.runs.names import CONTEXT, EVENT, TRUTH

PACE = "tlm/navigation"  # begins each control cycle
LARGEST_CHUNK = 64_000_000  # bytes unpacked; ours have about one million
KEPT_CHUNKS = 16
AROUND = 5  # cycles to either side that say how often one is recorded
_MESSAGE = struct.Struct("<BQHIQQ")  # opcode, length of what follows, channel, sequence, log and publish time
_END = 1 << 62  # beyond any place in a chunk
_LEAD = struct.Struct("<BQH")  # opcode, length, channel of a message index


class NoReplay(ValueError):
    """The log has no index, or no cycle of a mission."""


@dataclass(frozen=True)
class Told:
    """One message of the log."""

    topic: str
    log_ns: int
    payload: bytes


class Replay:
    """An open log. Usable from several threads, one at a time."""

    def __init__(self, path: Path, kept_chunks: int = KEPT_CHUNKS) -> None:
        self._kept_chunks = kept_chunks
        self._lock = threading.RLock()
        self._file = path.open("rb")
        try:
            summary = make_reader(self._file).get_summary()
        except Exception as error:
            self._file.close()
            raise NoReplay(f"the log cannot be opened: {error or type(error).__name__}") from error
        if summary is None or not summary.chunk_indexes:
            self._file.close()
            raise NoReplay("the log has no index")
        self._chunks = sorted(summary.chunk_indexes, key=lambda chunk: chunk.message_start_time)
        self._topics = {
            number: channel.topic
            for number, channel in summary.channels.items()
            if channel.topic in SAID and channel.topic != TRUTH
        }
        self._numbers = {topic: number for number, topic in self._topics.items()}
        starts = [chunk.chunk_start_offset for chunk in self._chunks]
        self._after = dict(zip(starts, self._chunks[1:], strict=False))
        self._unpacked: OrderedDict[int, bytes] = OrderedDict()
        self._indexes: OrderedDict[int, dict[int, np.ndarray]] = OrderedDict()
        counts = summary.statistics.channel_message_counts if summary.statistics else {}
        self.cycles = counts.get(self._numbers.get(PACE, -1), 0)
        self.start_ns, self.first_s, self.last_s = self._span()

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._file.close()

    def events(self) -> list[pb.Event]:
        """All events, in order."""
        number = self._numbers.get(EVENT)
        if number is None:
            return []
        with self._lock:
            found = []
            for chunk in self._chunks:
                if number in chunk.message_index_offsets:
                    found += [pb.Event.FromString(t.payload) for t in self._of(chunk, {number})]
            return found

    @cached_property
    def gaps(self) -> list[tuple[float, float]]:
        """Last cycle before and first after each stretch in which more than a few are missing, mission s.

        By the index alone. What a few is goes by the cycles around it: a hold is recorded more rarely.
        """
        pace = self._numbers[PACE]
        with self._lock:
            marks = [self._index(chunk, pace)[:, 0] for chunk in self._chunks]
        times = (np.sort(np.concatenate(marks)).astype(np.int64) - self.start_ns) * 1e-9
        steps = np.diff(times)
        found = []
        for k in np.flatnonzero(steps > GAP_S):
            before, after = steps[max(0, k - AROUND) : k], steps[k + 1 : k + 1 + AROUND]
            near = [float(np.median(part)) for part in (before, after) if len(part)]
            if steps[k] > GAP_S + 2.0 * max(near, default=0.0):
                found.append((float(times[k]), float(times[k + 1])))
        return found

    def at(self, time_s: float) -> pb.StreamFrame:
        """What was known at that time: the last message of each topic, and no event."""
        until = self._log_ns(time_s)
        wanted = {number for number, topic in self._topics.items() if topic != EVENT}
        newest: dict[str, Told] = {}
        with self._lock:
            for chunk in reversed(self._chunks):
                if chunk.message_start_time > until:
                    continue
                here = wanted & chunk.message_index_offsets.keys()
                for number in here:
                    if (told := self._last_before(chunk, number, until)) is not None:
                        newest[told.topic] = told
                        wanted.discard(number)
                if not wanted:
                    break
        return _frame(sorted(newest.values(), key=lambda told: told.log_ns), until)

    def frames(self, from_s: float, to_s: float, most: int) -> Iterator[pb.StreamFrame]:
        """The cycles from `from_s` up to and with `to_s`, at most about `most` of them, evenly left out."""
        first, last = self._log_ns(from_s), self._log_ns(to_s)
        pace = self._numbers[PACE]
        with self._lock:
            chunks = [
                chunk
                for chunk in self._chunks
                if chunk.message_end_time >= first and chunk.message_start_time <= last
            ]
            times = [(chunk, self._index(chunk, pace)) for chunk in chunks]
        within = [(c, t[(t[:, 0] >= first) & (t[:, 0] <= last)]) for c, t in times]
        every = max(1, -(-sum(len(t) for _, t in within) // max(1, most)))
        seen = 0
        for chunk, marks in within:
            chosen = marks[(-seen) % every :: every]
            seen += len(marks)
            for mark in chosen:
                with self._lock:
                    yield self._cycle(chunk, int(mark[0]), int(mark[1]), every > 1)

    def _span(self) -> tuple[int, float, float]:
        pace = self._numbers.get(PACE)
        if pace is None:
            raise NoReplay("the log holds no cycle of a mission")
        holding = [chunk for chunk in self._chunks if pace in chunk.message_index_offsets]
        if not holding:
            raise NoReplay("the log holds no cycle of a mission")
        ends = []
        for chunk, which in ((holding[0], 0), (holding[-1], -1)):
            mark = self._index(chunk, pace)[which]
            told = self._message(chunk, int(mark[1]))
            stamp = stamp_of(told.payload)
            ends.append((told.log_ns, stamp.mission_time_s if stamp is not None else 0.0))
        start_ns = ends[0][0] - round(ends[0][1] * 1e9)
        return start_ns, ends[0][1], max(ends[0][1], (ends[1][0] - start_ns) * 1e-9)

    def _log_ns(self, time_s: float) -> int:
        return self.start_ns + round(time_s * 1e9)

    def _cycle(self, chunk: ChunkIndex, log_ns: int, begins: int, thinned: bool) -> pb.StreamFrame:
        """The cycle whose first message stands at `begins`: all up to the next one's.

        thinned: without what is large and said more rarely.
        """
        pace = self._numbers[PACE]
        marks = self._index(chunk, pace)[:, 1]
        later = marks[marks > begins]
        told = self._between(chunk, begins, int(later.min()) if len(later) else _END)
        after = self._after.get(chunk.chunk_start_offset)
        if not len(later) and after is not None:  # a chunk may end within a cycle
            first = self._index(after, pace)[:, 1]
            rest = self._between(after, 0, int(first.min()) if len(first) else 0)
            told = {**{one.topic: one for one in rest}, **{one.topic: one for one in told}}.values()
        kept = [one for one in told if not thinned or one.topic not in CONTEXT]
        return _frame(sorted(kept, key=lambda one: one.log_ns), log_ns)

    def _between(self, chunk: ChunkIndex, begins: int, ends: int) -> Collection[Told]:
        """The first message of each topic between two places of a chunk."""
        told = []
        for number, topic in self._topics.items():
            if topic != EVENT and number in chunk.message_index_offsets:
                places = self._index(chunk, number)[:, 1]
                here = places[(places >= begins) & (places < ends)]
                if len(here):
                    told.append(self._message(chunk, int(here.min())))
        return told

    def _last_before(self, chunk: ChunkIndex, number: int, until: int) -> Told | None:
        index = self._index(chunk, number)
        before = index[index[:, 0] <= until]
        return self._message(chunk, int(before[-1, 1])) if len(before) else None

    def _of(self, chunk: ChunkIndex, numbers: set[int]) -> list[Told]:
        marks = np.concatenate([self._index(chunk, number) for number in numbers])
        return [self._message(chunk, int(place)) for place in marks[np.argsort(marks[:, 1]), 1]]

    def _index(self, chunk: ChunkIndex, number: int) -> np.ndarray:
        """(n, 2): log time and place in the chunk of each message of a channel, in the order of the file."""
        key = chunk.chunk_start_offset
        known = self._indexes.setdefault(key, {})
        self._indexes.move_to_end(key)
        while len(self._indexes) > 40 * KEPT_CHUNKS:
            self._indexes.popitem(last=False)
        if number not in known:
            at = chunk.message_index_offsets.get(number)
            if at is None:
                return np.empty((0, 2), np.uint64)
            self._file.seek(at)
            size = _LEAD.unpack(self._file.read(_LEAD.size))[1]
            body = self._file.read(size - 2)
            known[number] = np.frombuffer(body[4:], "<u8").reshape(-1, 2)
        return known[number]

    def _message(self, chunk: ChunkIndex, place: int) -> Told:
        data = self._data(chunk)
        _, size, number, _, log_ns, _ = _MESSAGE.unpack_from(data, place)
        begins = place + _MESSAGE.size
        return Told(self._topics[number], log_ns, data[begins : place + 9 + size])

    def _data(self, chunk: ChunkIndex) -> bytes:
        key = chunk.chunk_start_offset
        if key not in self._unpacked:
            self._unpacked[key] = self._unpack(chunk)
            while len(self._unpacked) > self._kept_chunks:
                self._unpacked.popitem(last=False)
        self._unpacked.move_to_end(key)
        return self._unpacked[key]

    def _unpack(self, chunk: ChunkIndex) -> bytes:
        if chunk.uncompressed_size > LARGEST_CHUNK:
            raise NoReplay(f"a chunk of the log says to have {chunk.uncompressed_size} bytes")
        self._file.seek(chunk.chunk_start_offset + 9 + 8 + 8 + 8 + 4)
        name = self._file.read(struct.unpack("<I", self._file.read(4))[0])
        packed = self._file.read(struct.unpack("<Q", self._file.read(8))[0])
        if name == b"zstd":
            return zstandard.ZstdDecompressor().decompress(packed, max_output_size=chunk.uncompressed_size)
        if name:
            raise NoReplay(f"chunks of the log are packed with {name.decode(errors='replace')!r}")
        return packed


def _frame(told: list[Told], now_ns: int) -> pb.StreamFrame:
    frame = pb.StreamFrame(server_time_ns=max(now_ns, max((one.log_ns for one in told), default=0)))
    for one in told:
        frame.messages.add(
            topic=one.topic,
            schema=SAID[one.topic].DESCRIPTOR.full_name,
            payload=one.payload,
            receive_time_ns=one.log_ns,
        )
    return frame
