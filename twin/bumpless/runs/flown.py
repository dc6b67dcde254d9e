"""A run that was flown in this process: its LOG rows, and the messages the bus would have carried."""

import hashlib
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from google.protobuf.message import Message

from bumpless.config.parameters import Parameters
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.version import software_version
from bumpless.metrics import Columns, Figures, figures_of
from bumpless.runs.figures import outcome_event
from bumpless.runs.info import RunInfo
from bumpless.runs.names import EVENT
from bumpless.sim.twin import Result
from bumpless.telemetry import parameters_text, run_id, run_messages


@dataclass(frozen=True)
class Flown:
    """A flown mission as the source of a `Run`; mission time 0 is the UNIX time `started_ns`."""

    result: Result
    started_ns: int

    @cached_property
    def info(self) -> RunInfo:
        """What identifies the run. The same flight at the same time has the same id."""
        result, parameters = self.result, parameters_text(self.result.parameters)
        made_by = "\n".join((result.mission.sha256, result.vehicle.sha256, parameters, str(result.seed)))
        suffix = hashlib.sha256(made_by.encode()).hexdigest()[:4]
        name = run_id(result.mission.name, self.started_ns, suffix)
        return RunInfo(
            id=name,
            run_id=name,
            mission=result.mission.name,
            mission_sha256=result.mission.sha256,
            vehicle=result.vehicle.id,
            vehicle_sha256=result.vehicle.sha256,
            parameters_sha256=hashlib.sha256(parameters.encode()).hexdigest(),
            seed=result.seed,
            started_ns=self.started_ns,
            software_version=software_version(),
            recorder_version=software_version(),
        )

    @property
    def columns(self) -> Columns:
        """One row per cycle, after the way over the bus: what a log of it holds, to the bit."""
        commands = self.result.vehicle.commands
        columns = Columns.from_log(self.result.log, len(commands))
        return columns.as_told([command.unit for command in commands])

    @property
    def figures(self) -> Figures:
        """Metrics and outcome; a mission that `simulate` flew always comes to its end."""
        result = self.result
        name = self.info.run_id
        return figures_of(self.columns, result.vehicle, result.mission, "completed", run_id=name)

    @property
    def mission(self) -> Any:
        """The mission as it was flown."""
        return self.result.mission

    @property
    def vehicle(self) -> Any:
        """The vehicle that flew it."""
        return self.result.vehicle

    @property
    def parameters(self) -> Parameters:
        """What was flown with."""
        return self.result.parameters

    def timed(self) -> Iterator[tuple[int, str, Message]]:
        """All that the bus would have carried, as (time_ns, topic, message) in order."""
        info = self.info
        return run_messages(self.result, info.run_id, info.started_ns, info.software_version, info.session)

    def told(self) -> Iterator[tuple[str, Message]]:
        """The same as (topic, message), and the outcome as the last event."""
        status = pb.MissionStatus()
        for _, topic, message in self.timed():
            if isinstance(message, pb.MissionStatus):
                status = message
            yield topic, message
        yield EVENT, outcome_event(self.figures[1], status)

    def __getstate__(self) -> dict[str, Any]:
        """Small: the log's fields one by one, compressed, for most of their numbers repeat."""
        log = self.result.log
        fields = b"".join(np.ascontiguousarray(log[name]).tobytes() for name in log.dtype.names or ())
        bare = replace(self.result, log=np.empty(0, log.dtype))
        return {"bare": bare, "rows": len(log), "fields": zlib.compress(fields, 1), "ns": self.started_ns}

    def __setstate__(self, state: dict[str, Any]) -> None:
        bare: Result = state["bare"]
        log, fields, at = np.zeros(state["rows"], bare.log.dtype), zlib.decompress(state["fields"]), 0
        for name in log.dtype.names or ():
            size = log[name].nbytes
            log[name] = np.frombuffer(fields[at : at + size], log.dtype[name].base).reshape(log[name].shape)
            at += size
        object.__setattr__(self, "result", replace(bare, log=log))
        object.__setattr__(self, "started_ns", state["ns"])
