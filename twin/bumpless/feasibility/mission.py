"""What of a mission can't work, or is unlikely to."""

from collections.abc import Iterator

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters, default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.feasibility.finding import ERROR, WARNING, Finding
from bumpless.feasibility.path import check_end, check_legs, check_time
from bumpless.feasibility.sight import check_first_sight, check_sight
from bumpless.feasibility.station import LASTS_S, Station, station_keeping

DOCKED_S = 10.0  # in place that count as docked
_THIN_MPS = 0.005  # of current across: a margin that a gust takes away


def check_mission(mission: Mission, vehicle: Vehicle | None = None) -> tuple[Finding, ...]:
    """Every finding, errors first. `vehicle`: default is the mission's own, with the mission's parameters."""
    vehicle = vehicle or load_vehicle(mission.vehicle)
    parameters = with_overrides(default_parameters(vehicle), mission.parameters)
    found = [
        *check_legs(mission, vehicle, parameters),
        *check_time(mission, parameters),
        *check_end(mission),
        *check_sight(mission, vehicle, parameters),
        *check_first_sight(mission, vehicle, parameters),
        *check_station(mission, vehicle, parameters),
    ]
    return tuple(sorted(found, key=lambda one: one.severity != ERROR))


def check_station(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Can station be held before the target in the mission's current?"""
    if (
        parameters.guidance.speed_min_mps > 0.0
    ):  # it passes through the observation point, which is its docking
        return
    current, target = mission.environment.current_ned_mps, mission.target
    station = station_keeping(vehicle, parameters, current, target)
    at = f"At {station.chosen_deg % 360.0:.0f}°"
    if not station.holds:
        text = f"{at} {vehicle.id} can't hold station in this current: {station.reason}."
        yield Finding(
            ERROR, "current_not_holdable", "target.heading_deg", text, _what_would(station, mission)
        )
        return
    wanted = mission.end.hover_hold_s or DOCKED_S
    if station.chosen_s < max(wanted, 2.0 * DOCKED_S):
        severity = ERROR if station.chosen_s < min(wanted, DOCKED_S) else WARNING
        text = f"{at} the current drifts {vehicle.id} out of place after about {station.chosen_s:.0f} s."
        yield Finding(severity, "drifts_off", "target.heading_deg", text, _what_would(station, mission))
    elif station.chosen_s < LASTS_S:
        text = (
            f"{at} station is held for about {station.chosen_s:.0f} s at a time in this current; "
            "then the vehicle waves off and tries again."
        )
        yield Finding(WARNING, "held_for_a_while", "target.heading_deg", text, _what_would(station, mission))
    elif _moves(mission) and station.chosen_margin_mps < _thin(mission):
        text = (
            f"{at} the margin is {station.chosen_margin_mps:.3f} m/s of current abeam, less than its changes."
        )
        yield Finding(WARNING, "thin_margin", "target.heading_deg", text, _what_would(station, mission))


def _moves(mission: Mission) -> bool:
    """Whether there is any current."""
    north, east, _ = mission.environment.current_ned_mps
    return north != 0.0 or east != 0.0 or mission.environment.current_variation is not None


def _thin(mission: Mission) -> float:
    variation = mission.environment.current_variation
    return max(_THIN_MPS, variation.std_mps if variation else 0.0)


def _what_would(station: Station, mission: Mission) -> str:
    nearest, given = station.nearest_deg, mission.target.heading_deg
    if nearest is None:
        return "No heading holds station in it: dock in less current."
    off = abs((nearest - given + 180.0) % 360.0 - 180.0)
    return (
        f"A heading of {nearest:.0f}° holds: give the target that heading, heading_tolerance_deg {off:.0f}, "
        "or approach into_current."
    )
