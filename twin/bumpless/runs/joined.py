"""A flight whose record was cut into pieces, as one run: its figures over all that was recorded of it."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from google.protobuf.message import Message

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.metrics import Columns, Figures
from bumpless.runs import names
from bumpless.runs.figures import OUTCOME, figures_of_log
from bumpless.runs.info import RunInfo
from bumpless.runs.pieces import joined
from bumpless.runs.recorded import Recorded


@dataclass(frozen=True)
class Joined:
    """Several logs as the source of one `Run`. It pickles as their paths."""

    paths: tuple[Path, ...]

    @cached_property
    def _parts(self) -> tuple[Recorded, ...]:
        return tuple(Recorded(path) for path in self.paths)

    @cached_property
    def _flown(self) -> tuple[Recorded, ...]:
        """Those that hold a cycle of the mission: a hold after it is not judged."""
        return tuple(part for part in self._parts if len(part.columns))

    @property
    def info(self) -> RunInfo:
        """As the first piece tells it."""
        return self._parts[0].info

    @cached_property
    def columns(self) -> Columns:
        """One row per recorded cycle of the mission, over all pieces."""
        return joined([part.columns for part in self._flown or self._parts[:1]])

    @property
    def vehicle(self) -> Vehicle | None:
        """As the first piece that describes it does."""
        return next((part.vehicle for part in self._parts if part.vehicle is not None), None)

    @property
    def mission(self) -> Mission | None:
        """As the first piece that tells it does."""
        return next((part.mission for part in self._parts if part.mission is not None), None)

    @property
    def parameters(self) -> Parameters | None:
        """What was flown with at the beginning, where the first piece tells it."""
        return self._parts[0].parameters

    @property
    def figures(self) -> Figures | None:
        """Over all that was recorded, with the end of the last piece that flew."""
        if not self._flown:
            return None
        end, status, run = self._flown[-1].end, self._flown[-1].status, self.info.run_id
        state, reason = end.get("state", names.INTERRUPTED), end.get("reason", names.CUT_OFF)
        return figures_of_log(self.columns, self.vehicle, self.mission, status, state, reason, run)

    def told(self) -> Iterator[tuple[str, Message]]:
        """All messages, in order; an outcome that one piece alone was given is none of the flight."""
        for part in self._parts:
            for topic, message in part.told():
                if topic != names.EVENT or getattr(message, "code", "") != OUTCOME:
                    yield topic, message

    def __getstate__(self) -> tuple[Path, ...]:
        return self.paths

    def __setstate__(self, paths: tuple[Path, ...]) -> None:
        object.__setattr__(self, "paths", paths)
