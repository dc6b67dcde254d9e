"""Rules between a mission's fields, and between the mission and its vehicle."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bumpless.config.mission.document import Document
from bumpless.config.mission.model import Mission
from bumpless.config.parameters import ParameterError, check, default_parameters, with_overrides
from bumpless.config.problems import Problem, ProblemsError

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

SHORTEST_LEG_M = 0.5


def check_rules(
    document: Document, mission: Mission, vehicle: "Vehicle | None", any_vehicle: bool = False
) -> None:
    """Add a problem to the document for each broken rule."""
    for path, value, rule in (*_legs(mission), *_target(mission), *_times(mission)):
        document.refuse(path, value, rule)
    if vehicle is None:
        vehicle = _vehicle_by_name(document, mission)
    elif mission.vehicle != vehicle.id and not any_vehicle:
        document.refuse("vehicle", mission.vehicle, f"must be {vehicle.id}, the vehicle that is to fly it")
    if vehicle is not None:
        for path, value, rule in _faults(mission, vehicle):
            document.refuse(path, value, rule)
        for problem in parameter_problems(mission, vehicle):
            document.refuse(f"parameters.{problem.field}", problem.value, problem.rule)


def parameter_problems(mission: Mission, vehicle: "Vehicle") -> list[Problem]:
    """What is wrong with the mission's parameters on this vehicle; fields without `parameters.`."""
    try:
        parameters = with_overrides(default_parameters(vehicle), mission.parameters)
    except ParameterError as error:
        return list(error.problems)
    return check(parameters, vehicle)


def _vehicle_by_name(document: Document, mission: Mission) -> "Vehicle | None":
    from bumpless.config.vehicle import load_vehicle

    try:
        return load_vehicle(mission.vehicle)
    except (ProblemsError, OSError) as error:
        reason = error.problems[0].rule if isinstance(error, ProblemsError) else "no such vehicle"
        document.refuse("vehicle", mission.vehicle, reason)
        return None


def _legs(mission: Mission) -> Iterator[tuple[str, object, str]]:
    points = mission.path_ned_m
    for i, (start, end) in enumerate(pairwise(points)):
        if math.dist(start, end) < SHORTEST_LEG_M:
            rule = f"must end at least {SHORTEST_LEG_M:g} m from where the leg begins"
            yield f"legs[{i}].to_ned_m", list(end), rule


def _target(mission: Mission) -> Iterator[tuple[str, object, str]]:
    offset, depth = mission.target.true_offset_ned_m, mission.target.true_position_ned_m[2]
    if depth < 0.0:
        yield (
            "target.true_offset_ned_m",
            list(offset),
            f"must keep the target under water (depth {depth:g} m)",
        )


def _times(mission: Mission) -> Iterator[tuple[str, object, str]]:
    for i, outage in enumerate(mission.sensors.outages):
        if not outage.from_s < outage.to_s:
            rule = f"must be after from_s ({outage.from_s:g})"
            yield f"sensors.outages[{i}].to_s", outage.to_s, rule
    for i, fault in enumerate(mission.faults):
        if fault.at_s >= mission.duration_s:
            yield f"faults[{i}].at_s", fault.at_s, f"must be before the end at {mission.duration_s:g} s"
    hold = mission.end.hover_hold_s
    if hold is not None and hold >= mission.duration_s:
        yield "end.hover_hold_s", hold, f"must be shorter than duration_s ({mission.duration_s:g})"


def _faults(mission: Mission, vehicle: "Vehicle") -> Iterator[tuple[str, object, str]]:
    names = [actuator.name for actuator in vehicle.actuators]
    seen: set[str] = set()
    for i, fault in enumerate(mission.faults):
        if fault.actuator not in names:
            yield f"faults[{i}].actuator", fault.actuator, f"unknown actuator; one of {', '.join(names)}"
        elif fault.actuator in seen:
            yield f"faults[{i}].actuator", fault.actuator, "has a fault already; one per actuator"
        seen.add(fault.actuator)
