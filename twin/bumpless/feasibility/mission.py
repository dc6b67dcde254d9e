"""What of a mission can't work, or is unlikely to."""

from bumpless.config.mission import Mission
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.feasibility.dock import check_dock
from bumpless.feasibility.finding import Finding
from bumpless.feasibility.floor import check_floor
from bumpless.feasibility.holding import check_station
from bumpless.feasibility.path import check_end, check_hold, check_legs, check_time
from bumpless.feasibility.sight import check_first_sight, check_sight
from bumpless.feasibility.start import check_start
from bumpless.feasibility.station import Station, station_keeping
from bumpless.feasibility.zones import check_zones


def check_mission(mission: Mission, vehicle: Vehicle | None = None) -> tuple[Finding, ...]:
    """Every finding, hard ones first. vehicle: the mission's own when None, with the mission's parameters."""
    vehicle = vehicle or load_vehicle(mission.vehicle)
    parameters = with_overrides(default_parameters(vehicle), mission.parameters)
    found = [
        *check_legs(mission, vehicle, parameters),
        *check_time(mission, vehicle, parameters),
        *check_end(mission),
        *check_hold(mission, parameters),
        *check_zones(mission),
        *check_floor(mission, vehicle),
        *check_start(mission, vehicle, parameters),
        *check_dock(mission, vehicle, parameters),
        *check_sight(mission, vehicle, parameters),
        *check_first_sight(mission, vehicle, parameters),
        *check_station(mission, vehicle, parameters),
    ]
    return tuple(sorted(found, key=lambda one: not one.blocks))


def station_of(mission: Mission, vehicle: Vehicle | None = None) -> Station | None:
    """What the check judges station keeping by; None where the vehicle only passes its target by."""
    vehicle = vehicle or load_vehicle(mission.vehicle)
    parameters = with_overrides(default_parameters(vehicle), mission.parameters)
    if parameters.guidance.speed_min_mps > 0.0:
        return None
    return station_keeping(vehicle, parameters, mission.environment.current_ned_mps, mission.target)
