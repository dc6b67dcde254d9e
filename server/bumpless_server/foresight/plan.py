"""From a planner's text to what is flown: mission, vehicle and parameters, or every problem."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from bumpless.campaign.parameter_path import changes_of
from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import ParameterError, Parameters, check, default_parameters, with_overrides
from bumpless.config.problems import Problem
from bumpless.config.vehicle import Vehicle, VehicleError, load_vehicle
from bumpless_server.foresight.wanted import ForesightRequest
from bumpless_server.plan.missions import parse_planned

SOURCE = "mission.yaml"


@dataclass(frozen=True)
class Plan:
    """What the request's text says, with its overrides."""

    mission: Mission
    vehicle: Vehicle
    parameters: Parameters


def plan_of(request: ForesightRequest, present: Vehicle | None = None) -> Plan:
    """The plan; `present` is the vehicle on the bus, which may be none of ours.

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
    parameters = with_overrides(default_parameters(vehicle), mission.parameters)
    if wanted.parameters:
        parameters = _overridden(parameters, wanted.parameters, vehicle)
    seed = mission.seed if request.seed is None else request.seed
    return Plan(replace(mission, seed=seed), vehicle, parameters)


def _vehicle(name: str, present: Vehicle | None) -> Vehicle:
    try:
        return load_vehicle(name)
    except (VehicleError, OSError) as error:
        if present is not None and present.id == name:
            return present
        if isinstance(error, VehicleError):
            raise
        raise VehicleError([Problem("", None, None, "vehicle", name, "no such vehicle")]) from error


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
