"""Rules between a mission's fields, and between the mission and its vehicle."""

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any, cast

from bumpless.config.declare import Broken
from bumpless.config.mission.contact_steps import MOST, contact_steps
from bumpless.config.mission.model import Mission
from bumpless.config.parameters import ParameterError, check, default_parameters, with_overrides
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import MyringHull, Vehicle, load_vehicle
from bumpless.contract.names import MISSION

SHORTEST_LEG_M = 0.5


def broken_rules(mission: Mission, vehicle: Vehicle | None, any_vehicle: bool = False) -> list[Broken]:
    """Every broken rule, by its path in the file."""
    found = [
        *_legs(mission),
        *_target(mission),
        *_times(mission),
        *_sea(mission),
        *_zones(mission),
        *_weights(mission),
    ]
    if vehicle is None:
        try:
            vehicle = load_vehicle(mission.vehicle)
        except (ProblemsError, OSError) as error:
            reason = error.problems[0].rule if isinstance(error, ProblemsError) else "no such vehicle"
            found.append(("vehicle", mission.vehicle, reason))
    elif mission.vehicle != vehicle.id and not any_vehicle:
        found.append(("vehicle", mission.vehicle, f"must be {vehicle.id}, the vehicle that is to fly it"))
    if vehicle is not None:
        found += [*_faults(mission, vehicle), *_parameters(mission.parameters, vehicle)]
        found += _dock(mission, vehicle)
        found += _depths(mission, vehicle)
    return [Broken(*one) for one in found]


def broken_overrides(tree: Mapping[str, Any], vehicle: Vehicle | None) -> list[Broken]:
    """What is wrong with the parameters of a mission whose other fields can't be read."""
    overrides, name = tree.get("parameters"), tree.get("vehicle")
    if not isinstance(overrides, dict):
        return []
    if vehicle is None:
        if not isinstance(name, str) or not MISSION.allows(name):
            return []
        try:
            vehicle = load_vehicle(name)
        except (ProblemsError, OSError):
            return []
    return [Broken(*one) for one in _parameters(cast("dict[str, Any]", overrides), vehicle)]


def _parameters(overrides: Mapping[str, Any], vehicle: Vehicle) -> list[tuple[str, object, str]]:
    try:
        problems = check(with_overrides(default_parameters(vehicle), overrides), vehicle)
    except ParameterError as error:
        problems = error.problems
    return [(f"parameters.{one.field}", one.value, one.rule) for one in problems]


def _depths(mission: Mission, vehicle: Vehicle) -> Iterator[tuple[str, object, str]]:
    """Nothing may lead deeper than the vehicle bears."""
    most = vehicle.depth_rating_m
    if most is None:
        return
    rule = f"must be no deeper than {most:g} m, which {vehicle.id} bears"
    places = {"start.position_ned_m": mission.start.position_ned_m}
    places |= {f"legs[{i}].to_ned_m": leg.to_ned_m for i, leg in enumerate(mission.legs)}
    places["target.position_ned_m"] = mission.target.true_position_ned_m
    for path, point in places.items():
        if point[2] > most:
            yield path, list(point), rule


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


def _dock(mission: Mission, vehicle: Vehicle) -> Iterator[tuple[str, object, str]]:
    """What a dock to enter asks of itself, of the target and of the hull."""
    dock, hull, target = mission.target.dock, vehicle.hull, mission.target
    if dock is None:
        return
    if not isinstance(hull, MyringHull):
        yield "target.dock", None, f"needs a hull of revolution; {vehicle.id} has none"
        return
    hull_m, end = hull.diameter_m / 2.0, dock.length_m
    if dock.tube_radius_m <= hull_m:
        yield "target.dock.tube_radius_m", dock.tube_radius_m, f"must be more than the hull's, {hull_m:g} m"
    if dock.entry_radius_m < dock.tube_radius_m:
        rule = f"must be at least tube_radius_m ({dock.tube_radius_m:g})"
        yield "target.dock.entry_radius_m", dock.entry_radius_m, rule
    if not dock.cone_length_m < dock.capture_depth_m < end:
        rule = f"must be in the tube, between {dock.cone_length_m:g} and {end:g} m"
        yield "target.dock.capture_depth_m", dock.capture_depth_m, rule
    if dock.entry_before_marker_m < end + dock.wall_m:
        rule = f"must be at least {end + dock.wall_m:g}: the marker hangs behind the stop"
        yield "target.dock.entry_before_marker_m", dock.entry_before_marker_m, rule
    nearest = dock.entry_before_marker_m + hull.nose_to_origin_m
    if target.standoff_m < nearest:
        rule = f"must be at least {nearest:g}: the nose stays outside of the dock until it is let in"
        yield "target.standoff_m", target.standoff_m, rule
    if (steps := contact_steps(dock, vehicle)) > MOST:
        rule = f"too stiff to be simulated, {steps} steps in a control period against {MOST}: soften contact"
        yield "target.dock", None, f"{rule} or let friction fade at a higher slip_speed_mps"
    if target.turn_deg > 0.0:
        yield "target.dock", None, "stands still: needs heading_tolerance_deg 0 and approach heading"


def _times(mission: Mission) -> Iterator[tuple[str, object, str]]:
    for name in ("outages", "dvl_outages"):
        for i, outage in enumerate(getattr(mission.sensors, name)):
            if not outage.from_s < outage.to_s:
                rule = f"must be after from_s ({outage.from_s:g})"
                yield f"sensors.{name}[{i}].to_s", outage.to_s, rule
    for i, fault in enumerate(mission.faults):
        if fault.at_s >= mission.duration_s:
            yield f"faults[{i}].at_s", fault.at_s, f"must be before the end at {mission.duration_s:g} s"
    hold = mission.end.hover_hold_s
    if hold is not None and hold >= mission.duration_s:
        yield "end.hover_hold_s", hold, f"must be shorter than duration_s ({mission.duration_s:g})"


def _faults(mission: Mission, vehicle: Vehicle) -> Iterator[tuple[str, object, str]]:
    names = [actuator.name for actuator in vehicle.actuators]
    seen: set[str] = set()
    for i, fault in enumerate(mission.faults):
        if fault.actuator not in names:
            yield f"faults[{i}].actuator", fault.actuator, f"unknown actuator; one of {', '.join(names)}"
        elif fault.actuator in seen:
            yield f"faults[{i}].actuator", fault.actuator, "has a fault already; one per actuator"
        seen.add(fault.actuator)


def _sea(mission: Mission) -> Iterator[tuple[str, object, str]]:
    for i, (above, below) in enumerate(pairwise(mission.environment.current_profile)):
        if not above.depth_m < below.depth_m:
            rule = f"must be deeper than the entry before ({above.depth_m:g} m)"
            yield f"environment.current_profile[{i + 1}].depth_m", below.depth_m, rule
    deepest = max(point[2] for point in (*mission.path_ned_m, mission.target.true_position_ned_m))
    bottom = mission.environment.water_depth_m
    if 0.0 < bottom <= deepest:
        rule = f"must be more than the mission's deepest point ({deepest:g} m), or 0"
        yield "environment.water_depth_m", bottom, rule


def _zones(mission: Mission) -> Iterator[tuple[str, object, str]]:
    for i, zone in enumerate(mission.keep_out):
        if not zone.from_depth_m < zone.to_depth_m:
            rule = f"must be deeper than from_depth_m ({zone.from_depth_m:g})"
            yield f"keep_out[{i}].to_depth_m", zone.to_depth_m, rule


def _weights(mission: Mission) -> Iterator[tuple[str, object, str]]:
    for i, weight in enumerate(mission.trim.weights if mission.trim else ()):
        if weight.from_m is None and weight.to_m is None:
            yield f"trim.weights[{i}]", None, "needs from_m, to_m or both"
