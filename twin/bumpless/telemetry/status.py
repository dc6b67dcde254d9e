"""What a vehicle says more rarely than each cycle: mission, plan, parameters, description, events."""

import json
import secrets
import time
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from typing import TYPE_CHECKING, cast

from bumpless.contract import bumpless_pb2 as pb

if TYPE_CHECKING:
    from bumpless.config.mission import Mission
    from bumpless.config.parameters import Parameters
    from bumpless.config.problems import Problem
    from bumpless.config.vehicle import Vehicle
    from bumpless.sim.events import TwinEvent


@dataclass(frozen=True)
class FlightState:
    """What is flown, apart from the row: a new one replaces it whenever anything in it changes."""

    parameters: "Parameters"
    revision: int = 1  # of the parameters
    mission: "Mission | None" = None
    run_id: str = ""
    seed: int = 0

    @cached_property
    def parameters_text(self) -> str:
        """All parameters as JSON, see `parameters_text`."""
        return parameters_text(self.parameters)


def run_id(mission_name: str, time_ns: int, suffix: str | None = None) -> str:
    """Identity of a run: `YYYYMMDDTHHMMSSZ-<mission>-<4 hex>`, sorting by start time (UTC)."""
    at = time.strftime("%Y%m%dT%H%M%SZ", time.gmtime(time_ns // 1_000_000_000))
    return f"{at}-{mission_name}-{suffix or secrets.token_hex(2)}"


def mission_status(
    stamp: pb.Stamp, state: FlightState, phase: int, end_reason: str = "", held_s: float = 0.0
) -> pb.MissionStatus:
    """Topic "mission". `phase` is the row's MissionPhase, `end_reason` why the run is over.

    `held_s` is how long it has been paused, s: elapsed time goes on in a pause, and its limit with it.
    """
    message = pb.MissionStatus(
        stamp=stamp,
        phase=cast("pb.MissionPhase", phase),
        run_id=state.run_id,
        seed=state.seed,
        end_reason=end_reason,
    )
    if state.mission is not None:
        message.mission_name = state.mission.name
        message.mission_sha256 = state.mission.sha256
        message.duration_s = state.mission.duration_s + held_s
        message.elapsed_s, message.held_s = stamp.mission_time_s, held_s
    return message


def plan(stamp: pb.Stamp, mission: "Mission") -> pb.Plan:
    """Topic "plan": the mission text as received and its waypoints, NED, m."""
    return pb.Plan(
        stamp=stamp,
        file_name=mission.source,
        mission_yaml=mission.text,
        sha256=mission.sha256,
        path_ned_m=[pb.Vector3(x=n, y=e, z=d) for n, e, d in mission.path_ned_m],
    )


def parameters_status(stamp: pb.Stamp, state: FlightState, defaults: "Parameters") -> pb.ParametersStatus:
    """Topic "parameters": what is flown with, tunable or not, and the hash of all of it."""
    from bumpless.config.parameters import to_message

    text = state.parameters_text
    return pb.ParametersStatus(
        stamp=stamp,
        active=to_message(state.parameters),
        revision=state.revision,
        sha256=sha256(text.encode()).hexdigest(),
        defaults=to_message(defaults),
        parameters_json=text,
    )


def parameters_text(parameters: "Parameters") -> str:
    """All parameters as JSON with the vehicle file's keys: their identity, and a log's parameters.json."""
    from bumpless.config.parameters import as_dict

    return json.dumps(as_dict(parameters), indent=1, sort_keys=True)


def description(
    stamp: pb.Stamp, vehicle: "Vehicle", software_version: str, session_id: str
) -> pb.VehicleDescription:
    """Topic "description": who this is."""
    return pb.VehicleDescription(
        stamp=stamp,
        vehicle_id=vehicle.id,
        vehicle_name=vehicle.name,
        vehicle_toml=vehicle.text,
        sha256=vehicle.sha256,
        software_version=software_version,
        control_period_s=vehicle.control_period_s,
        actuator_names=[command.name for command in vehicle.commands],
        session_id=session_id,
    )


def event(stamp: pb.Stamp, happened: "TwinEvent") -> pb.Event:
    """An event of the twin (severity, code, text, details) as the contract's."""
    details = {key: str(value) for key, value in sorted(happened.details.items())}
    return pb.Event(
        stamp=stamp,
        severity=cast("pb.Severity", happened.severity),
        code=happened.code,
        text=happened.text,
        details=details,
    )


def problem_messages(problems: "Iterable[Problem]") -> list[pb.Problem]:
    """Problems of a refused file or request as the contract's."""
    return [pb.Problem(**problem.as_dict()) for problem in problems]
