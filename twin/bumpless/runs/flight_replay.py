"""A flight that was recorded in pieces, replayed as one: any moment and any range, over its gaps.

Mission time is the one axis. Each piece leads to it by itself, so that a server's clock that was set between
two pieces moves nothing; frames are told in the first piece's log times.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics.columns import GAP_S
from bumpless.runs.figures import OUTCOME
from bumpless.runs.names import CONTEXT
from bumpless.runs.replay import KEPT_CHUNKS, NoReplay, Replay

SLACK_S = 1.0  # that a piece may begin before the last one's end: two clocks
FEWEST_CHUNKS = 2  # kept of a piece of many


@dataclass(frozen=True)
class Piece:
    """What one file holds of the flight; times are mission times, s."""

    id: str
    first_s: float
    last_s: float
    cycles: int

    @property
    def pace_s(self) -> float:
        """From one cycle in it to the next, s."""
        return (self.last_s - self.first_s) / max(1, self.cycles - 1)


class FlightReplay:
    """Open logs of one flight. Usable from several threads."""

    def __init__(self, paths: Sequence[Path]) -> None:
        """Open the pieces; one that can't be replayed, or tells a time again, is left out.

        Raises bumpless.runs.replay.NoReplay when none can be.
        """
        kept = max(FEWEST_CHUNKS, KEPT_CHUNKS // len(paths))
        opened: list[tuple[Replay, Piece]] = []
        reason: NoReplay | None = None
        for path in paths:
            try:
                replay = Replay(path, kept)
            except NoReplay as error:
                reason = error
                continue
            if opened and replay.first_s < opened[-1][1].last_s - SLACK_S:
                replay.close()
                continue
            opened.append((replay, Piece(path.stem, replay.first_s, replay.last_s, replay.cycles)))
        if not opened:
            raise reason or NoReplay("there is no piece of it")
        self._replays = [replay for replay, _ in opened]
        self.pieces = [piece for _, piece in opened]
        self.first_s, self.last_s = self.pieces[0].first_s, self.pieces[-1].last_s
        self.cycles = sum(piece.cycles for piece in self.pieces)

    @property
    def gaps(self) -> list[tuple[float, float]]:
        """From the last cycle before to the first after, where more than a few are missing, s.

        Within a file and between two.
        """
        found = [gap for replay in self._replays for gap in replay.gaps]
        for before, after in pairwise(self.pieces):
            if after.first_s - before.last_s > GAP_S + 2.0 * max(before.pace_s, after.pace_s):
                found.append((before.last_s, after.first_s))
        return sorted(found)

    def close(self) -> None:
        """Close the files."""
        for replay in self._replays:
            replay.close()

    def events(self) -> list[pb.Event]:
        """All events, in order. An outcome of a piece that another one follows was not the flight's."""
        found: list[pb.Event] = []
        for replay in self._replays:
            found = [event for event in found if event.code != OUTCOME] + replay.events()
        return found

    def at(self, time_s: float) -> pb.StreamFrame:
        """What was known at that time: in a gap, what was said last before it."""
        index = self._index(time_s)
        frame = self._shifted(index, self._replays[index].at(time_s))
        for before in range(index - 1, -1, -1):
            lacking = set(CONTEXT) - {message.topic for message in frame.messages}
            if not lacking:
                break
            older = self._shifted(before, self._replays[before].at(time_s))
            frame.messages.extend(message for message in older.messages if message.topic in lacking)
        return frame

    def frames(self, from_s: float, to_s: float, most: int) -> Iterator[pb.StreamFrame]:
        """The cycles from `from_s` up to and with `to_s`, at most about `most`, evenly left out per piece."""
        within = [self._within(piece, from_s, to_s) for piece in self.pieces]
        whole = sum(within) or 1.0
        for index, (replay, cycles) in enumerate(zip(self._replays, within, strict=True)):
            if cycles > 0.0:
                for frame in replay.frames(from_s, to_s, max(1, round(most * cycles / whole))):
                    yield self._shifted(index, frame)

    def _index(self, time_s: float) -> int:
        begun = [k for k, piece in enumerate(self.pieces) if piece.first_s <= time_s]
        return begun[-1] if begun else 0

    def _within(self, piece: Piece, from_s: float, to_s: float) -> float:
        """About how many of a piece's cycles lie in a range."""
        if to_s < piece.first_s or from_s > piece.last_s:
            return 0.0
        length = max(piece.last_s - piece.first_s, 1e-9)
        share = (min(to_s, piece.last_s) - max(from_s, piece.first_s)) / length
        return max(1.0, share * piece.cycles)

    def _shifted(self, index: int, frame: pb.StreamFrame) -> pb.StreamFrame:
        """Told in the first piece's log times."""
        by = self._replays[0].start_ns - self._replays[index].start_ns
        if by:
            frame.server_time_ns = max(0, frame.server_time_ns + by)
            for message in frame.messages:
                message.receive_time_ns = max(0, message.receive_time_ns + by)
        return frame
