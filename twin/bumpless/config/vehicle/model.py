"""A vehicle: body, actuators, sensors and how it is flown, as its file says."""

import hashlib
from dataclasses import field
from typing import Annotated, Any

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.declare import Entries, Number, Overrides, Part, Text, Words, model
from bumpless.config.names import WRENCH
from bumpless.config.parameters import Parameters
from bumpless.config.problems import Problem
from bumpless.config.vehicle.body import Appendage, Environment, Hull, Mass
from bumpless.config.vehicle.failsafe import Failsafe
from bumpless.config.vehicle.parts import Actuator, Command
from bumpless.config.vehicle.places import Places
from bumpless.config.vehicle.sensors import Sensors


def some_text(label: str) -> Text:
    """A text that is not empty."""
    return Text(label, pattern=".+", form="must not be empty")


@model
class Document:
    """What a vehicle file says, once the fields that actuators share are laid under each."""

    id: Annotated[str, some_text("Short name, also the file's")]
    name: Annotated[str, some_text("Name for people")]
    control_period_s: Annotated[float, Number("Period of the control cycle", "s", max=1.0, above=0.0)]
    controllable: Annotated[
        tuple[str, ...], Words("Wrench components that the actuators shall serve", options=WRENCH)
    ]
    environment: Annotated[Environment, Part("Water")]
    mass: Annotated[Mass, Part("Mass and buoyancy")]
    hull: Annotated[Hull, Part("Hull")]
    actuators: Annotated[tuple[Actuator, ...], Entries("Actuators", fewest=1, most=MAX_ACTUATORS)]
    sensors: Annotated[Sensors, Part("Sensors")]
    appendages: Annotated[tuple[Appendage, ...], Entries("What sticks out and drags", most=64)] = ()
    control: Annotated[
        dict[str, Any], Overrides("Control parameters, in a file beside or here", of=Parameters)
    ] = field(default_factory=dict[str, Any])
    depth_rating_m: Annotated[
        float | None,
        Number("Depth that it bears", "m", 0.0, 11000.0, help="A mission that leads deeper is refused."),
    ] = None
    failsafe: Annotated[Failsafe, Part("What it does by itself when something fails")] = field(
        default_factory=Failsafe
    )


@model
class Vehicle(Document):
    """A vehicle, checked, with the text that it was read from.

    Actuators stand in the file's order, and their commands one after the other: the order of u everywhere.
    `control` holds the raw tables of the control parameters; `parameters.default_parameters` reads them.
    """

    text: str = field(default="", repr=False)  # both files, so that one text carries the whole vehicle
    source: str = ""  # name of the file
    control_line: int = field(default=0, compare=False)  # of `text`, from which on it is the file beside

    @property
    def sha256(self) -> str:
        """Hash of the text: the vehicle's identity."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @property
    def commands(self) -> tuple[Command, ...]:
        """Every command of every actuator, in the order of u."""
        return tuple(command for actuator in self.actuators for command in actuator.commands)

    @property
    def ends_m(self) -> tuple[float, float]:
        """x of nose and tail in body axes, m; a box has its origin in the middle."""
        length = self.hull.length_m
        fore = getattr(self.hull, "nose_to_origin_m", 0.5 * length)
        return fore, fore - length

    def slots(self, kind: str) -> list[int]:
        """Places in u of the commands of all actuators of a kind ("fin", "thruster")."""
        kinds = [actuator.kind for actuator in self.actuators for _ in actuator.commands]
        return [i for i, name in enumerate(kinds) if name == kind]

    def problem(self, path: str, value: Any, rule: str) -> Problem:
        """A broken rule at the place of `path` in the vehicle's files."""
        return Places(self.text, self.source, self.control_line).problem(path, value, rule)
