"""A run, flown here or opened from a file: its identity, figures, outcome and table. The public face."""

import shutil
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bumpless.runs.flown import Flown
from bumpless.runs.info import RunInfo

if TYPE_CHECKING:
    import pandas
    import pyarrow
    from google.protobuf.message import Message

    from bumpless.config.mission import Mission
    from bumpless.config.parameters import Parameters
    from bumpless.config.vehicle import Vehicle
    from bumpless.contract.bumpless_pb2 import Metrics
    from bumpless.metrics import Columns, Outcome
    from bumpless.runs.joined import Joined
    from bumpless.runs.recorded import Recorded
    from bumpless.runs.table import Table
    from bumpless.runs.view import View

Progress = Callable[[float], None]  # called with the share done, 0 to 1


class NoFigures(ValueError):
    """The log holds no cycle of a mission, or no description of its vehicle that can be read."""


class Run:
    """One flown mission. Made by `bumpless.fly` and `bumpless.open_run`; pickles small.

    An opened run pickles as its path.
    """

    def __init__(self, source: "Flown | Recorded | Joined") -> None:
        self._source = source

    def __repr__(self) -> str:
        return f"<Run {self.info.id}>"

    @property
    def info(self) -> RunInfo:
        """What identifies the run: ids, hashes, seed, software, start."""
        return self._source.info

    @property
    def mission(self) -> "Mission | None":
        """The mission as it was flown; None when the log tells none that can be read."""
        return self._source.mission

    @property
    def vehicle(self) -> "Vehicle | None":
        """The vehicle that flew it; None when the log describes none that can be read."""
        return self._source.vehicle

    @property
    def parameters(self) -> "Parameters | None":
        """What the autopilot flew with at the beginning; None when the log does not tell all of it."""
        return self._source.parameters

    @property
    def metrics(self) -> "Metrics":
        """Figures of merit, as `bumpless.contract.bumpless_pb2.Metrics`; what did not happen is NaN.

        Raises NoFigures. A run and the log that it was saved as give the same to the bit.
        """
        return self._figures[0]

    @property
    def outcome(self) -> "Outcome":
        """How the run ended, and why. Raises NoFigures."""
        return self._figures[1]

    @property
    def columns(self) -> "Columns":
        """What the figures are made of, in SI and radians: one row per cycle of the mission."""
        return self._source.columns

    def messages(self) -> "Iterator[tuple[str, Message]]":
        """All that the vehicle said, as (topic, message) in order."""
        return self._source.told()

    def table(self) -> "Table":
        """One row per control cycle: column names, with units, to NumPy arrays of one length."""
        from bumpless.runs.table import table_of

        return table_of(self.messages())

    def to_arrow(self) -> "pyarrow.Table":
        """`table` for Arrow and Parquet. Needs the extra `data`."""
        arrow = _extra("pyarrow", "data")
        return arrow.table({name: arrow.array(column) for name, column in self.table().items()})

    def to_pandas(self) -> "pandas.DataFrame":
        """`table` as a frame, indexed by mission time in s. Needs the extra `data`."""
        return _extra("pandas", "data").DataFrame(self.table()).set_index("time_s")

    def save(self, path: str | Path, views: "Sequence[View]" = (), progress: Progress | None = None) -> Path:
        """Write the run as a log (MCAP) and return its path. Needs the extra `log`.

        `views` are converters whose messages the log shall hold too. Half a file is never left behind; an
        opened run's file is copied as it is.
        """
        _extra("mcap", "log")
        from bumpless.config.whole import whole
        from bumpless.runs.recorded import Recorded

        target = Path(path)
        with whole(target) as partial:
            if isinstance(self._source, Flown):
                from bumpless.runs.save import write_flown

                write_flown(self._source, self._figures, partial, views, progress)
            elif isinstance(self._source, Recorded):
                shutil.copyfile(self._source.path, partial)
            else:
                raise ValueError("a flight that was recorded in pieces has no file of its own")
        return target

    @cached_property
    def _figures(self) -> "tuple[Metrics, Outcome]":
        found = self._source.figures
        if found is None:
            raise NoFigures("holds no cycle of a mission, or no description of its vehicle")
        return found

    def __getstate__(self) -> "Flown | Recorded | Joined":
        return self._source

    def __setstate__(self, source: "Flown | Recorded | Joined") -> None:
        self._source = source


def _extra(module: str, extra: str) -> Any:
    from bumpless.contract.extras import imported

    return imported(module, extra)
