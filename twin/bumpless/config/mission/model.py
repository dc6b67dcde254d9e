"""A mission: where to start, which path to follow, where to dock, and what the sea does meanwhile.

People write missions by hand in YAML; `parse_mission` reads one, or refuses it with every fault and its
place. Positions are NED with the origin of the mission's own choice, so
depth is positive down. The same dataclasses give the published JSON Schema (`mission_json_schema`).
"""

import hashlib
import math
from dataclasses import dataclass, field
from typing import Annotated, Any

from bumpless.config.capacity import MAX_FAULTS, MAX_OUTAGES, MAX_WAYPOINTS
from bumpless.config.mission.fields import (
    NAME,
    Entries,
    Internal,
    Number,
    Part,
    Text,
    Vector3,
    Vector6,
    offset,
    position,
    velocity,
    wrench,
)
from bumpless.config.problems import ProblemsError

VERSION = 1

Seconds = Annotated[float, Number("Mission time", 0.0, 1e5, "s")]
Heading = Annotated[float, Number("Heading, from north over east", -360.0, 360.0, "deg")]


class MissionError(ProblemsError):
    """A mission file that is refused; `problems` says where and why."""


@dataclass(frozen=True)
class Start:
    """State of the vehicle at mission time 0; simulated vehicles are put there."""

    position_ned_m: Annotated[Vector3, position("Position")]
    heading_deg: Heading
    speed_mps: Annotated[float, Number("Surge speed through the water", 0.0, 5.0, "m/s")] = 0.0


@dataclass(frozen=True)
class Leg:
    """A straight line from the end of the leg before (the first: from the start)."""

    to_ned_m: Annotated[Vector3, position("End of the leg")]
    speed_mps: Annotated[
        float,
        Number(
            "Surge speed, through the water with guidance.crab_gain 1, over ground with 0", 0.01, 5.0, "m/s"
        ),
    ]


@dataclass(frozen=True)
class Target:
    """The docking target with its QR code; the heading is the one to approach with."""

    position_ned_m: Annotated[Vector3, position("Position")]
    heading_deg: Heading
    standoff_m: Annotated[
        float, Number("Distance of the observation point before the target", 0.0, 100.0, "m")
    ]
    true_offset_ned_m: Annotated[
        Vector3, offset("Where a simulated target truly is, from position_ned_m; the vehicle must find out")
    ] = (0.0, 0.0, 0.0)

    @property
    def true_position_ned_m(self) -> Vector3:
        """Where the simulator puts the target; `position_ned_m` is where the plan believes it to be."""
        (n, e, d), (dn, de, dd) = self.position_ned_m, self.true_offset_ned_m
        return (n + dn, e + de, d + dd)

    @property
    def observation_point_ned_m(self) -> Vector3:
        """Where the vehicle hovers: `standoff_m` before the target against the approach heading."""
        n, e, d = self.position_ned_m
        heading = math.radians(self.heading_deg)
        return (n - self.standoff_m * math.cos(heading), e - self.standoff_m * math.sin(heading), d)


@dataclass(frozen=True)
class CurrentVariation:
    """First-order Gauss-Markov variation added to each horizontal component of the current."""

    std_mps: Annotated[float, Number("Standard deviation", 0.0, 2.0, "m/s")]
    time_constant_s: Annotated[float, Number("Correlation time", 0.1, 1e5, "s")]


@dataclass(frozen=True)
class Wave:
    """A regular deep-water wave whose orbital motion decays with depth."""

    height_m: Annotated[float, Number("Height from trough to crest", 0.0, 20.0, "m")]
    period_s: Annotated[float, Number("Period", 1.0, 60.0, "s")]
    direction_deg: Annotated[float, Number("Heading towards which it travels", -360.0, 360.0, "deg")] = 0.0


@dataclass(frozen=True)
class Environment:
    """What acts on the vehicle besides itself."""

    current_ned_mps: Annotated[Vector3, velocity("Current, the way it flows")] = (0.0, 0.0, 0.0)
    current_variation: Annotated[CurrentVariation | None, Part("Slow change of the current")] = None
    wave: Annotated[Wave | None, Part("Wave")] = None
    disturbance_body_n_nm: Annotated[Vector6, wrench("Constant disturbance tau_e")] = (
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )


@dataclass(frozen=True)
class Detection:
    """What this mission changes of the vehicle's target camera; what is left out stays."""

    range_max_m: Annotated[float | None, Number("Farthest detection", 0.1, 200.0, "m")] = None
    field_of_view_half_deg: Annotated[float | None, Number("Half angle of view", 1.0, 90.0, "deg")] = None
    dropout_probability: Annotated[float | None, Number("Share of frames missed", 0.0, 1.0)] = None


@dataclass(frozen=True)
class Outage:
    """A time in which the target isn't seen, whatever the geometry."""

    from_s: Seconds
    to_s: Seconds


@dataclass(frozen=True)
class Sensors:
    """What this mission changes of the vehicle's sensors."""

    noise_scale: Annotated[
        float, Number("Factor on every noise of the vehicle file; 0 is none", 0.0, 20.0)
    ] = 1.0
    detection: Annotated[Detection | None, Part("Target camera")] = None
    outages: Annotated[tuple[Outage, ...], Entries("Times without the target", 0, MAX_OUTAGES)] = ()


@dataclass(frozen=True)
class Fault:
    """An actuator loses effect: its force falls to `effectiveness` of the healthy one."""

    actuator: Annotated[str, Text("Name of the actuator in the vehicle file")]
    at_s: Seconds
    effectiveness: Annotated[float, Number("Share of the force that is left", 0.0, 1.0)]
    blend_s: Annotated[float, Number("Time over which the change is blended in", 0.0, 1000.0, "s")] = 0.0


@dataclass(frozen=True)
class End:
    """When the mission is complete before its duration is over."""

    hover_hold_s: Annotated[
        float | None,
        Number(
            "Complete after so long in hover within range_rh_upper_m on end; never if left out", 0.1, 1e5, "s"
        ),
    ] = None


@dataclass(frozen=True)
class Mission:
    """A whole mission, checked."""

    version: Annotated[int, Number("Version of this format", VERSION, VERSION)]
    name: Annotated[str, Text("Short name", NAME)]
    vehicle: Annotated[str, Text("Vehicle that flies it, such as ts100", NAME)]
    duration_s: Annotated[float, Number("Longest duration", 1.0, 1e5, "s")]
    start: Annotated[Start, Part("Where the vehicle starts")]
    legs: Annotated[tuple[Leg, ...], Entries("Path", 1, MAX_WAYPOINTS - 1)]
    target: Annotated[Target, Part("Docking target")]
    title: Annotated[str, Text("Title for people")] = ""
    summary: Annotated[str, Text("What it is for, in a sentence or two")] = ""
    seed: Annotated[int, Number("Seed of every random number", 0, 2**32 - 1)] = 0
    environment: Annotated[Environment, Part("Sea")] = Environment()
    sensors: Annotated[Sensors, Part("Sensors")] = Sensors()
    faults: Annotated[tuple[Fault, ...], Entries("Faults of actuators", 0, MAX_FAULTS)] = ()
    parameters: Annotated[dict[str, Any], Part("Overrides of the vehicle's control parameters")] = field(
        default_factory=dict
    )
    end: Annotated[End, Part("Early end")] = End()
    source: Annotated[str, Internal()] = ""  # name of the file
    text: Annotated[str, Internal()] = field(default="", repr=False)  # the file, whole

    @property
    def sha256(self) -> str:
        """Hash of the file's text: the mission's identity."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @property
    def path_ned_m(self) -> tuple[Vector3, ...]:
        """Waypoints, the start first."""
        return (self.start.position_ned_m, *(leg.to_ned_m for leg in self.legs))
