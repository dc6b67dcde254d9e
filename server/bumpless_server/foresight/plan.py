"""From a planner's text to what is flown: mission, vehicle and parameters, or every problem."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from bumpless.campaign.parameter_path import changes_of
from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import (
    ParameterError,
    Parameters,
    check,
    default_parameters,
    from_message,
    with_overrides,
)
from bumpless.config.problems import Problem
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.foresight.wanted import ForesightRequest
from bumpless_server.plan.missions import parse_planned

SOURCE = "mission.yaml"


@dataclass(frozen=True)
class Plan:
    """What the request's text says, with its overrides."""

    mission: Mission
    vehicle: Vehicle
    parameters: Parameters
    tuned: bool = False  # by an operator: not with the vehicle's defaults


def plan_of(request: ForesightRequest, present: Vehicle | None = None, tuned: bytes = b"") -> Plan:
    """The plan; `present` is the vehicle on the bus, which may be none of ours.

    tuned: the bumpless.Parameters that it is tuned with, under the mission's own; b"": its defaults.

    Raises MissionError, VehicleError or ParameterError with every problem.
    """
    wanted = request.overrides
    if wanted.vehicle is not None:
        vehicle = _vehicle(wanted.vehicle, present)
        mission = parse_mission(request.text, SOURCE, vehicle, any_vehicle=True)
    else:
        mission = parse_planned(request.text, SOURCE, present)
        vehicle = _vehicle(mission.vehicle, present)
    if wanted.current is not None:
        sea = replace(mission.environment, current_ned_mps=wanted.current)
        mission = replace(mission, environment=sea)
    base = default_parameters(vehicle)
    is_tuned = bool(tuned) and present is not None and present.id == vehicle.id
    if is_tuned:
        base = from_message(pb.Parameters.FromString(tuned), base)
    parameters = with_overrides(base, mission.parameters)
    if wanted.parameters:
        parameters = _overridden(parameters, wanted.parameters, vehicle)
    seed = mission.seed if request.seed is None else request.seed
    return Plan(replace(mission, seed=seed), vehicle, parameters, is_tuned)


def _vehicle(name: str, present: Vehicle | None) -> Vehicle:
    """The vehicle on the bus where it is the one: it may differ from our file of its name."""
    return present if present is not None and present.id == name else _shipped(name)


@lru_cache(maxsize=16)
def _shipped(name: str) -> Vehicle:
    return load_vehicle(name)


def _overridden(parameters: Parameters, values: Mapping[str, Any], vehicle: Vehicle) -> Parameters:
    try:
        changed = with_overrides(parameters, changes_of(parameters, values))
    except ValueError as error:
        if isinstance(error, ParameterError):
            raise
        path, _, rule = str(error).partition(": ")
        raise ParameterError([Problem("", None, None, path, None, rule)]) from error
    problems = check(changed, vehicle)
    if problems:
        raise ParameterError(problems)
    return changed
