"""A mission: where to start, which path to follow, where to dock, and what the sea does meanwhile.

People write missions by hand in YAML; `parse_mission` reads one, or refuses it with every fault and its
place. Positions are NED with the origin of the mission's own choice, so
depth is positive down. The same declarations give the published JSON Schema (`mission_json_schema`).
"""

import hashlib
import math
from dataclasses import field
from functools import cached_property
from typing import Annotated, Any, Literal

from bumpless.config.capacity import MAX_FAULTS, MAX_WAYPOINTS
from bumpless.config.declare import Choice, Entries, Number, Overrides, Part, Row, Switch, Text, model
from bumpless.config.mission.dock import Dock, Motion
from bumpless.config.mission.mishaps import MOST_MISHAPS, Mishap
from bumpless.config.mission.notes import Vector3, direction, moment, position
from bumpless.config.mission.origin import Origin
from bumpless.config.mission.sea import Environment
from bumpless.config.mission.sea_floor import SeaFloor
from bumpless.config.mission.sensing import Sensors
from bumpless.config.mission.trim import Trim
from bumpless.config.mission.zones import MOST_ZONES, KeepIn, KeepOut
from bumpless.config.names import NED
from bumpless.config.parameters import Parameters
from bumpless.config.problems import ProblemsError
from bumpless.contract.names import MISSION

VERSION = 1


def short_name(label: str) -> Text:
    """A short name that is fit for file names and keys."""
    return Text(label, pattern=MISSION.pattern, form=f"must be {MISSION.words}")


class MissionError(ProblemsError):
    """A mission file that is refused; `problems` says where and why."""


@model
class Start:
    """State of the vehicle at mission time 0; simulated vehicles are put there."""

    position_ned_m: Annotated[Vector3, position("Position")]
    heading_deg: Annotated[float, direction("Heading, from north over east")]
    speed_mps: Annotated[float, Number("Surge speed through the water", "m/s", 0.0, 5.0)] = 0.0


@model
class Leg:
    """A straight line from the end of the leg before (the first: from the start)."""

    to_ned_m: Annotated[Vector3, position("End of the leg")]
    speed_mps: Annotated[
        float,
        Number("Surge speed", "m/s", 0.01, 5.0,
               help="Through the water with guidance.crab_gain 1, over ground with 0."),
    ]  # fmt: skip


@model
class Target:
    """The docking target with its QR code; the heading is the one to approach with."""

    position_ned_m: Annotated[Vector3, position("Position")]
    heading_deg: Annotated[float, direction("Heading to approach with, from north over east")]
    standoff_m: Annotated[
        float, Number("Distance of the observation point before the target", "m", 0.0, 100.0)
    ]
    true_offset_ned_m: Annotated[
        Vector3,
        Row("Where a simulated target truly is, from position_ned_m", "m", -100.0, 100.0, names=NED,
            help="The vehicle must find out."),
    ] = (0.0, 0.0, 0.0)  # fmt: skip

    heading_tolerance_deg: Annotated[
        float,
        Number("How far from heading_deg the approach may be", "deg", 0.0, 180.0,
               help="The vehicle turns its bow into the current within it."),
    ] = 0.0  # fmt: skip
    approach: Annotated[
        Literal["heading", "into_current"],
        Choice("How the approach heading is chosen",
               help="heading: heading_deg within its tolerance; into_current: from any side."),
    ] = "heading"  # fmt: skip
    dock_width_m: Annotated[
        float, Number("Width and height of the dock about its axis", "m", 0.0, 100.0,
                      help="The axis leads through the target along heading_deg."),
    ] = 2.0  # fmt: skip
    dock_length_m: Annotated[float, Number("Length of the dock behind the target", "m", 0.0, 100.0)] = 1.5

    @property
    def turns(self) -> bool:
        """Whether the dock turns with the approach, or is open all round, so that any side will do."""
        return self.turn_deg >= 90.0

    @property
    def dock_radius_m(self) -> float:
        """Of the circle about the target that holds the dock, its funnel too."""
        body = math.hypot(0.5 * self.dock_width_m, self.dock_length_m)
        funnel = math.hypot(self.dock.entry_before_marker_m, self.dock.entry_radius_m) if self.dock else 0.0
        return max(body, funnel)

    dock: Annotated[Dock | None, Part("Dock to enter, behind the observation point")] = None
    motion: Annotated[Motion | None, Part("Motion of a hung dock")] = None

    @property
    def turn_deg(self) -> float:
        """By how much the approach heading may differ from heading_deg, 0 to 180."""
        return 180.0 if self.approach == "into_current" else self.heading_tolerance_deg

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


@model
class Fault:
    """An actuator loses effect: its force falls to `effectiveness` of the healthy one."""

    actuator: Annotated[str, Text("Name of the actuator in the vehicle file")]
    at_s: Annotated[float, moment("When it comes")]
    effectiveness: Annotated[float, Number("Share of the force that is left", "", 0.0, 1.0)]
    blend_s: Annotated[float, Number("Time over which the change is blended in", "s", 0.0, 1000.0)] = 0.0


@model
class End:
    """When the mission is complete before its duration is over."""

    hover_hold_s: Annotated[
        float | None,
        Number("Complete after so long in hover", "s", 0.1, 1e5,
               help="Within range_rh_upper_m, on end; never if left out."),
    ] = None  # fmt: skip


@model
class Document:
    """What a mission file says."""

    version: Annotated[int, Number("Version of this format", "", VERSION, VERSION)]
    name: Annotated[str, short_name("Short name")]
    vehicle: Annotated[str, short_name("Vehicle that flies it, such as ts100")]
    duration_s: Annotated[float, Number("Longest duration", "s", 1.0, 1e5)]
    start: Annotated[Start, Part("Where the vehicle starts")]
    legs: Annotated[tuple[Leg, ...], Entries("Path", fewest=1, most=MAX_WAYPOINTS - 1)]
    target: Annotated[Target, Part("Docking target")]
    title: Annotated[str, Text("Title for people")] = ""
    summary: Annotated[str, Text("What it is for, in a sentence or two")] = ""
    seed: Annotated[int, Number("Seed of every random number", "", 0, 2**32 - 1)] = 0
    environment: Annotated[Environment, Part("Sea")] = Environment()
    sensors: Annotated[Sensors, Part("Sensors")] = Sensors()
    faults: Annotated[tuple[Fault, ...], Entries("Faults of actuators", most=MAX_FAULTS)] = ()
    mishaps: Annotated[
        tuple[Mishap, ...], Entries("Mishaps of the simulated vehicle", most=MOST_MISHAPS)
    ] = ()
    parameters: Annotated[
        dict[str, Any], Overrides("Overrides of the vehicle's control parameters", of=Parameters)
    ] = field(default_factory=dict[str, Any])
    end: Annotated[End, Part("Early end")] = End()
    actuator_flow: Annotated[
        bool,
        Switch("Flow at the actuators of the simulated vehicle",
               help="Screws in four quadrants, wash over fins and what else the vehicle file says of flow."),
    ] = False  # fmt: skip
    trim: Annotated[Trim | None, Part("Ballast and buoyancy of the simulated vehicle")] = None
    keep_out: Annotated[
        tuple[KeepOut, ...], Entries("Keep-out zones", most=MOST_ZONES, help="No leg may lead through them.")
    ] = ()
    keep_in: Annotated[KeepIn | None, Part("Keep-in boundary", help="No leg may leave it.")] = None
    origin: Annotated[
        Origin | None, Part("Where the local frame lies on the earth", help="For charts and other programs.")
    ] = None
    sea_floor: Annotated[
        SeaFloor | None, Part("Sea floor to keep clear of", help="The autopilot knows nothing of it.")
    ] = None


@model
class Mission(Document):
    """A mission, checked, with the file that it was read from."""

    source: str = ""  # name of the file
    text: str = field(default="", repr=False)  # the file, whole: its bytes as UTF-8, line ends and all
    depth_grid: Any = field(default=None, repr=False, compare=False)  # a chart.DepthGrid, once it was found

    @property
    def sha256(self) -> str:
        """Hash of the file's bytes: the mission's identity."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @cached_property
    def path_ned_m(self) -> tuple[Vector3, ...]:
        """Waypoints, the start first."""
        return (self.start.position_ned_m, *(leg.to_ned_m for leg in self.legs))
