"""What stands in a log beside its messages: metadata, attachments, and how many messages there are."""

from dataclasses import dataclass, field
from pathlib import Path

from mcap.reader import make_reader
from mcap.records import Attachment, Metadata

from bumpless.runs import names
from bumpless.runs.chunks import CUT, damage_of, records_of

MAGIC = b"\x89MCAP0\r\n"


@dataclass
class Records:
    """Of one file; the first of each kind where several logs were merged."""

    run: dict[str, str] = field(default_factory=dict)  # the metadata that identifies the run
    end: dict[str, str] = field(default_factory=dict)  # how it ended; empty while nobody knows
    attachments: dict[str, bytes] = field(default_factory=dict)
    messages: int = 0  # views included; 0 where the file has no end
    first_ns: int = 0  # log times
    last_ns: int = 0
    fault: str = ""  # why the file could not be read to its end
    damage: str = ""  # what its check sums show to be changed, where they were asked

    def _note(self, record: object) -> None:
        if isinstance(record, Attachment):
            self.attachments.setdefault(record.name, record.data)
        elif isinstance(record, Metadata):
            kind = names.record_kind(record.name)
            if kind == names.RUN_RECORD and not self.run:
                self.run = record.metadata
            elif kind == names.END_RECORD and not self.end:
                self.end = record.metadata


def is_whole(path: Path) -> bool:
    """True when the file has its end: a cut one lacks the closing magic."""
    with path.open("rb") as file:
        if file.seek(0, 2) < 2 * len(MAGIC):
            return False
        file.seek(-len(MAGIC), 2)
        return file.read() == MAGIC


def read_records(path: Path, check: bool = False) -> Records:
    """Read them without the messages, where the file is whole; else as far as it goes.

    `check`: hold every check sum against the file, which reads it once from end to end.
    """
    found = Records()
    try:
        if is_whole(path):
            _by_index(path, found)
        else:
            _by_stream(path, found)
        if check:
            _check(path, found)
    except Exception as error:  # whatever a damaged file makes of its reader
        found.fault = f"the file cannot be read: {error or type(error).__name__}"
    return found


def _by_index(path: Path, found: Records) -> None:
    with path.open("rb") as file:
        reader = make_reader(file)
        summary = reader.get_summary()
        if summary is not None and summary.statistics is not None:
            statistics = summary.statistics
            found.messages = statistics.message_count
            found.first_ns, found.last_ns = statistics.message_start_time, statistics.message_end_time
        for record in (*reader.iter_metadata(), *reader.iter_attachments()):
            found._note(record)


def _by_stream(path: Path, found: Records) -> None:
    with path.open("rb") as file:
        records = records_of(file, path.stat().st_size)
        next(records)  # the header: what has none is no log
        try:
            for record in records:
                found._note(record)
        except CUT:
            return


def _check(path: Path, found: Records) -> None:
    if not is_whole(path):
        return
    with path.open("rb") as file:
        damage = damage_of(file, path.stat().st_size)
    more = f" and {len(damage) - 1} more" if len(damage) > 1 else ""
    found.damage = damage[0] + more if damage else ""
