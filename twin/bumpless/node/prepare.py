"""Before a node is alive: everything that flying needs is compiled, imported and tried once."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from bumpless.config.text import decoded
from bumpless.contract import bumpless_pb2 as pb

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle
    from bumpless.node.flight import TwinLike

_TRIAL = """\
version: 1
name: trial
vehicle: {vehicle}
duration_s: 10
start: {{position_ned_m: [0, 0, 5], heading_deg: 0}}
legs: [{{to_ned_m: [5, 0, 5], speed_mps: 0.5}}]
target: {{position_ned_m: [5, 0, 5], heading_deg: 0, standoff_m: 1}}
"""
_TRIAL_CYCLES = 20


def start_request(path: Path) -> pb.StartMission:
    """The command that would start the mission of this file. Raises OSError, or NotText if it is none."""
    text = decoded(path.read_bytes(), path.name)
    return pb.StartMission(file_name=path.name, mission_yaml=text, operator="command line")


def ready_twin(
    vehicle: "Vehicle", make_twin: "Callable[[Vehicle], TwinLike] | None", say: Callable[[str], None]
) -> "TwinLike":
    """An idle twin whose every path has been flown once by another of its kind."""
    began = time.monotonic()
    if make_twin is None:
        say(f"preparing {vehicle.id}: loading the compiled control cycle (the first time compiles it)")
        from bumpless.sim.twin import Twin

        make_twin = Twin
    _try_out(make_twin(vehicle), vehicle)
    twin = make_twin(vehicle)
    twin.step()
    twin.drain_events()
    say(f"{vehicle.id} is ready after {time.monotonic() - began:.1f} s")
    return twin


def _try_out(twin: "TwinLike", vehicle: "Vehicle") -> None:
    """Fly a mission that nobody sees; the first real one shall find nothing left to compile or import."""
    from bumpless.config.mission import parse_mission
    from bumpless.config.parameters import check, default_parameters, from_message, to_message, with_overrides
    from bumpless.telemetry import FlightState, Teller

    mission = parse_mission(_TRIAL.format(vehicle=vehicle.id), "trial.yaml", vehicle)
    defaults = default_parameters(vehicle)
    parameters = from_message(to_message(with_overrides(defaults, mission.parameters)), defaults)
    check(parameters, vehicle)
    teller = Teller(vehicle, defaults)
    state = FlightState(parameters, 1, mission, "trial", 0)
    twin.step()
    twin.start(mission, None, parameters)
    for change in (None, twin.pause, twin.resume, lambda: twin.set_parameters(parameters)):
        if change is not None:
            change()
        for _ in range(_TRIAL_CYCLES):
            row = twin.step()
            list(teller.tell(row, state, twin.drain_events()))
    twin.abort("trial over")
    twin.step()
