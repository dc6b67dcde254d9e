"""Nothing silent: what was not taken as it came is counted by kind, with the last example of each."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

# kind -> what it means, one sentence for the operator
KINDS: dict[str, str] = {
    "unknown_key": "Messages on keys that the contract does not know are not taken.",
    "too_large": "Messages larger than their topic may be are not taken.",
    "wrong_type": "Messages that are not of their topic's type are not taken.",
    "undecodable": "Messages that cannot be decoded are not taken.",
    "no_stamp": "Messages that do not say when they were made are not taken.",
    "bad_name": "A name from the bus that breaks its rule names nothing here.",
    "non_finite": "Messages with numbers that are none are passed on and recorded as they are.",
    "out_of_order": "Messages that are older than one already heard are recorded, not shown.",
    "missed": "Messages that were lost on the way and that the vehicle no longer had when asked for them.",
    "second_speaker": "Somebody else than the vehicle says the vehicle's words; they are not taken.",
    "foreign_reply": "Somebody else than the vehicle answers its commands; the answer does not count.",
    "no_answer": "Commands that the vehicle did not answer in time.",
    "late_command": "Commands that reached the vehicle after their time and were not carried out.",
    "too_many_commands": "Commands refused here because too many wait for the vehicle already.",
    "clock_offset": "The vehicle's clock differs from the server's; its times are shown by the server's.",
    "bad_file": "Files in the data folder that are left out of a list; their reasons stand beside them.",
    "refused_login": "Wrong passwords and tokens.",
    "slow_request": "Connections that did not bring a whole request in time, or came in too great a number.",
    "dropped": "Messages lost because the server or its disk was too slow.",
}
EXAMPLE_CHARS = 200


@dataclass(frozen=True)
class Count:
    """One kind: how often, when last (UNIX, ns) and what it was then."""

    kind: str
    count: int
    last_ns: int
    example: str


class Tally:
    """Counters of KINDS; usable from any thread. `first` is called once of each kind and only enqueues."""

    def __init__(self, first: Callable[[str, str], None] = lambda kind, example: None) -> None:
        self._lock = threading.Lock()
        self._counts: dict[str, Count] = {}
        self._first = first

    def note(self, kind: str, example: str, times: int = 1) -> None:
        """Count one more (or `times`) of `kind`."""
        if kind not in KINDS:
            raise ValueError(f"{kind!r} is no kind of what is counted")
        example = printable(example)
        with self._lock:
            known = self._counts.get(kind)
            count = times + (known.count if known else 0)
            self._counts[kind] = Count(kind, count, time.time_ns(), example)
        if known is None:
            self._first(kind, example)

    def counts(self) -> list[Count]:
        """What was counted so far, in the order of KINDS."""
        with self._lock:
            return [self._counts[kind] for kind in KINDS if kind in self._counts]

    def of(self, kind: str) -> int:
        """How often."""
        with self._lock:
            known = self._counts.get(kind)
        return known.count if known else 0

    @property
    def total(self) -> int:
        """All kinds together."""
        return sum(count.count for count in self.counts())


def printable(text: str) -> str:
    """One short line that every log, terminal and JSON takes: foreign text must not write our lines."""
    text = text.encode("utf-8", "backslashreplace").decode()
    text = "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)
    return text if len(text) <= EXAMPLE_CHARS else text[: EXAMPLE_CHARS - 1] + "…"
