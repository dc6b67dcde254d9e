"""A range of a log as a log of its own: whole, with footer and summary, so that any MCAP reader opens it.

Works on one that is still being written as well: what has reached the disk so far becomes a whole file.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path
from typing import Any

from mcap.records import Attachment, Channel, McapRecord, Message, Metadata, Schema

from bumpless.config.whole import whole
from bumpless.contract.messages import stamp_of
from bumpless.runs import names
from bumpless.runs.chunks import CUT, header_of, records_of
from bumpless.runs.read import log_messages
from bumpless.runs.repair import Copy
from bumpless.runs.replay import PACE

ROUNDING_S = 1e-3  # times of cycles are sums of periods, and miss by rounding


@dataclass(frozen=True)
class Range:
    """A part of a run in mission time, s; both ends belong to it."""

    from_s: float = -inf
    to_s: float = inf

    @classmethod
    def read(cls, text: str) -> "Range":
        """From "10:20", "10:" or ":20". Raises ValueError."""
        first, colon, last = text.partition(":")
        try:
            found = cls(float(first) if first.strip() else -inf, float(last) if last.strip() else inf)
        except ValueError as error:
            raise ValueError(f"range {text!r}: must be FROM:TO in seconds, such as 10:20") from error
        if not colon or not found.from_s <= found.to_s:
            raise ValueError(f"range {text!r}: must be FROM:TO in seconds, such as 10:20")
        return found

    def holds(self, time_s: Any) -> Any:
        """Whether a time, or each of an array, belongs to it."""
        return (time_s >= self.from_s - ROUNDING_S) & (time_s <= self.to_s + ROUNDING_S)

    @property
    def all(self) -> bool:
        """Whether nothing is left out."""
        return (self.from_s, self.to_s) == (-inf, inf)

    def __str__(self) -> str:
        first = "the start" if self.from_s == -inf else f"{self.from_s:g} s"
        last = "the end" if self.to_s == inf else f"{self.to_s:g} s"
        return f"{first} to {last}"


def start_ns_of(path: Path) -> int:
    """Log time of mission time 0. Raises ValueError when the log holds no cycle of a mission."""
    for _, record in log_messages(path, {PACE}):
        stamp = stamp_of(record.data)
        if stamp is not None:
            return record.log_time - round(stamp.mission_time_s * 1e9)
    raise ValueError("the log holds no cycle of a mission")


def cut(source: Path, target: Path, part: Range) -> int:
    """Write `part` of a log to `target`; returns how many messages that are.

    What identifies the run, its files and what the vehicle said of itself before go with it; figures of the
    whole run don't. Raises ValueError when `source` is no log or has nothing in that range.
    """
    start = 0 if part.all else start_ns_of(source)
    first = -inf if part.from_s == -inf else start + (part.from_s - ROUNDING_S) * 1e9
    last = inf if part.to_s == inf else start + (part.to_s + ROUNDING_S) * 1e9
    with source.open("rb") as file, whole(target) as partial:
        with partial.open("wb") as out:
            size = source.stat().st_size
            records = records_of(file, size)
            header = header_of(records, size)
            copy = Copy(out, header)
            _fill(copy, _readable(records), first, last, part)
            copy.writer.finish()
        if not copy.messages:
            raise ValueError(f"the log has nothing in the range {part}")
    return copy.messages


def _readable(records: Iterator[McapRecord]) -> Iterator[McapRecord]:
    """Up to where the file was cut, or is being written."""
    try:
        yield from records
    except CUT:
        return


def _fill(copy: Copy, records: Iterator[McapRecord], first: float, last: float, part: Range) -> None:
    context: dict[int, Message] = {}  # newest before the range, by channel
    topics: dict[int, str] = {}
    run = ""
    for record in records:
        if isinstance(record, Schema | Channel):
            copy.add(record)
            if isinstance(record, Channel):
                topics[record.id] = record.topic
        elif isinstance(record, Message):
            if record.log_time < first:
                if topics.get(record.channel_id) in names.CONTEXT:
                    context[record.channel_id] = record
            elif record.log_time <= last:
                for told in context.values():
                    copy.add(replace(told, log_time=record.log_time))
                context = {}
                copy.add(record)
        elif isinstance(record, Metadata) and not part.all:
            kind = names.record_kind(record.name)
            if kind == names.RUN_RECORD:
                run = run or record.metadata.get("id", "")
            if kind != names.END_RECORD:
                copy.add(record)
        elif part.all or not (isinstance(record, Attachment) and record.name == names.METRICS):
            copy.add(record)
    if not part.all and names.RUN.allows(run):
        end = {"state": names.INTERRUPTED, "reason": f"an excerpt, {part}"}
        copy.writer.add_metadata(names.record_name(names.END_RECORD, run), end)
