"""A vehicle that moves in a straight line, with nothing to compile: tests of the node are about the node."""

import sys
from pathlib import Path
from typing import Any

import numpy as np

from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.sim.condition import Condition, condition_of
from bumpless.sim.events import TwinEvent
from bumpless.sim.log import LOG


class LightTwin:
    """Flies north at 1 m/s while a mission runs, and stops at its duration. Fills a LOG row per cycle."""

    def __init__(self, vehicle: Vehicle) -> None:
        self.vehicle = vehicle
        self.parameters = default_parameters(vehicle)
        self.phase: int = pb.MISSION_PHASE_IDLE
        self.mission: Any = None
        self.steps = self.surfaced = 0
        self._log = np.zeros(1, LOG)
        self._events: list[TwinEvent] = []

    def start(self, mission: Any, seed: int | None = None, parameters: Any = None) -> None:
        self.mission, self.parameters = mission, parameters
        self._log[:] = np.zeros(1, LOG)
        self._to(pb.MISSION_PHASE_RUNNING, "mission_started", f"seed {seed}")

    def pause(self) -> None:
        self._to(pb.MISSION_PHASE_PAUSED, "mission_paused", "paused")

    def resume(self) -> None:
        self._to(pb.MISSION_PHASE_RUNNING, "mission_resumed", "resumed")

    def abort(self, reason: str) -> None:
        self._to(pb.MISSION_PHASE_ABORTED, "mission_aborted", f"Mission aborted: {reason}.")

    def surface(self) -> None:
        self.surfaced += 1
        self._to(pb.MISSION_PHASE_PAUSED, "surfacing", "up")

    def wave_off(self) -> bool:
        return False

    @property
    def condition(self) -> Condition:
        return condition_of(self.mission, float(self._log[0]["time"]))

    def set_parameters(self, parameters: Any) -> None:
        self.parameters = parameters
        self._events.append(TwinEvent(1, "parameters_applied", "applied", {}))

    def step(self) -> Any:
        row = self._log[0]
        self.steps += 1
        if self.phase in (pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED):
            row["cycle"] += 1
            row["time"] += self.vehicle.control_period_s
        if self.phase == pb.MISSION_PHASE_RUNNING:
            row["eta_hat"][0] += self.vehicle.control_period_s
            row["u"][:3] = 0.1, -0.2, 0.3
        if self.phase == pb.MISSION_PHASE_RUNNING and row["time"] >= self.mission.duration_s - 1e-9:
            self._to(pb.MISSION_PHASE_COMPLETED, "mission_completed", "Mission completed.")
        row["phase"] = self.phase
        row["status"] = pb.SOLVE_STATUS_SOLVED
        row["nu_hat"][0] = 1.0 if self.phase == pb.MISSION_PHASE_RUNNING else 0.0
        return row

    def drain_events(self) -> list[TwinEvent]:
        drained, self._events = self._events, []
        return drained

    def _to(self, phase: int, code: str, text: str) -> None:
        self.phase = phase
        self._events.append(TwinEvent(1, code, text, {}, float(self._log[0]["time"])))


def run(
    endpoint: str,
    realtime: str = "realtime",
    mission: str | None = None,
    vehicle: str | None = None,
    zenoh_config: str = "",
    memory: str = "",
) -> int:
    """A vehicle node of its own with this twin in it, connected to `endpoint`; all but it may be files."""
    from bumpless.node import main

    return main(
        "ts100",
        vehicle or None,
        connect=[endpoint] if endpoint else [],
        realtime=realtime == "realtime",
        mission=mission or None,
        make_twin=LightTwin,
        zenoh_config=Path(zenoh_config) if zenoh_config else None,
        memory=Path(memory) if memory else None,
    )


if __name__ == "__main__":
    sys.exit(run(*sys.argv[1:]))
