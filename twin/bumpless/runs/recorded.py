"""A run out of its file: read when asked for, whole or cut, our own or another recorder's."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from google.protobuf.message import Message

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters, as_dict, default_parameters, with_overrides
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import SAID
from bumpless.contract.messages import decoded
from bumpless.metrics import Columns, Figures
from bumpless.runs import names
from bumpless.runs.columns import RecordedColumns, over_floor, read_columns
from bumpless.runs.figures import figures_of_log
from bumpless.runs.info import RunInfo, run_info
from bumpless.runs.read import log_messages
from bumpless.runs.records import Records, read_records


@dataclass(frozen=True)
class Recorded:
    """A log as the source of a `Run`. It pickles as its path: whoever unpickles it needs the file."""

    path: Path

    @cached_property
    def _records(self) -> Records:
        return read_records(self.path)

    @cached_property
    def _columns(self) -> RecordedColumns:
        return read_columns(self.path)

    @property
    def info(self) -> RunInfo:
        """What identifies the run; from the vehicle's own words where the file has no record of it."""
        found = self._records.run
        return (
            RunInfo.read(found, self.path.stem) if found else run_info(self.path.stem, self._columns.status)
        )

    @property
    def end(self) -> Mapping[str, str]:
        """The record of how it ended; empty while nobody knows."""
        return self._records.end

    @property
    def status(self) -> pb.MissionStatus:
        """The last that the vehicle said of its mission."""
        return self._columns.status

    @property
    def columns(self) -> Columns:
        """One row per cycle of the mission."""
        return self._columns.columns

    @property
    def vehicle(self) -> Vehicle | None:
        """The vehicle as it described itself; None when it did not, or not in our terms."""
        return self._columns.vehicle

    @property
    def figures(self) -> Figures | None:
        """Metrics and outcome; None without a cycle of a mission or a usable vehicle."""
        end = self._records.end
        state, reason = end.get("state", names.INTERRUPTED), end.get("reason", names.CUT_OFF)
        run = self.info.run_id
        return figures_of_log(self.columns, self.vehicle, self.mission, self.status, state, reason, run)

    @cached_property
    def mission(self) -> Mission | None:
        """The mission as the vehicle flew it; None when the file has none that can be read."""
        mission, grid = self._columns.mission, self._records.attachments.get(names.SEA_FLOOR)
        return over_floor(mission, grid)

    @cached_property
    def parameters(self) -> Parameters | None:
        """What was flown with at the beginning; None when the vehicle did not tell all of it."""
        vehicle, text = self.vehicle, self._records.attachments.get(names.PARAMETERS)
        if vehicle is None or text is None:
            return None
        try:
            told, defaults = json.loads(text), default_parameters(vehicle)
            return with_overrides(defaults, told) if told.keys() == as_dict(defaults).keys() else None
        except (ProblemsError, ValueError, AttributeError):
            return None

    def told(self) -> Iterator[tuple[str, Message]]:
        """The bus's messages of the contract, as (topic, message) in the order of the file."""
        for topic, record in log_messages(self.path, SAID):
            message = decoded(SAID[topic].DESCRIPTOR.full_name, record.data)
            if message is not None:
                yield topic, message

    def __getstate__(self) -> Path:
        return self.path

    def __setstate__(self, path: Path) -> None:
        object.__setattr__(self, "path", path)
