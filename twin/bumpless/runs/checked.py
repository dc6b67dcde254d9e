"""Can a mission be flown, and which headings hold station? The public face of `bumpless.feasibility`."""

from pathlib import Path

from bumpless.config.mission import Mission
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.feasibility import (
    ACCEPT,
    REFUSE,
    WARN,
    Finding,
    Station,
    arcs,
    check_mission,
    station_keeping,
    station_of,
)
from bumpless.runs.flight import load_mission

__all__ = ["ACCEPT", "REFUSE", "WARN", "Station", "arcs", "check", "station_keeping", "station_of"]


def check(mission: Mission | str | Path, vehicle: Vehicle | str | None = None) -> tuple[Finding, ...]:
    """What of a mission can't work (errors, first) or is unlikely to (warnings), and what would.

    mission: or its file or name, see `load_mission`. vehicle: or its id or file; the mission's own when
    None.
    Nothing is flown: speeds, depths, times, what the camera sees on the way, and whether station can be
    held in the mission's current follow from the vehicle's model and the autopilot's rules.

    Raises MissionError, VehicleError or ParameterError with every problem.
    """
    who = load_vehicle(vehicle) if isinstance(vehicle, str) else vehicle
    read = mission if isinstance(mission, Mission) else load_mission(mission, who)
    return check_mission(read, who)
