"""The server's own state, the vehicle it sees, and events."""

from typing import Literal

from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.failsafe import WORDS, Reaction
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.answers.contract import Answer, MissionStatus, model_of


class Health(Answer):
    """The server answers."""

    status: Literal["ok"]
    version: str


class SeenVehicle(Answer):
    """Who speaks on the bus, without its file."""

    vehicle_id: str
    vehicle_name: str
    software_version: str
    sha256: str
    control_period_s: float
    actuator_names: list[str]
    session_id: str


class Status(model_of(pb.ServerStatus)):
    """ServerStatus, and what the server sees."""

    vehicle: SeenVehicle | None
    mission: MissionStatus | None


class Event(model_of(pb.Event)):
    """One event, and when the server received it."""

    receive_time_ns: str


class ActuatorAnswer(Answer):
    """One command of an actuator of this kind, with its amplitude bounds in its unit."""

    name: str
    kind: str
    unit: str
    min: float
    max: float


class FailsafeAnswer(Answer):
    """What the vehicle does by itself: shown before a start as "what happens when"."""

    cause: str  # stable identifier, as the event's details name it
    when: str  # one sentence
    reaction: Reaction
    does: str  # the reaction in words
    limit: float | None  # beyond which it acts; None where there is no number to it
    unit: str


class VehicleAnswer(Answer):
    """The vehicle's build as its own file says."""

    id: str
    name: str
    sha256: str
    control_period_s: float
    controllable: list[str]
    length_m: float
    diameter_m: float
    actuators: list[ActuatorAnswer]  # one for each command, in the order of u
    failsafe: list[FailsafeAnswer]
    depth_rating_m: float | None  # None: the file does not say

    @classmethod
    def of(cls, vehicle: Vehicle) -> "VehicleAnswer":
        """What a vehicle file says."""
        return cls(
            id=vehicle.id,
            name=vehicle.name,
            sha256=vehicle.sha256,
            control_period_s=vehicle.control_period_s,
            controllable=list(vehicle.controllable),
            length_m=vehicle.hull.length_m,
            diameter_m=vehicle.hull.diameter_m,
            failsafe=[
                FailsafeAnswer(
                    cause=one.cause,
                    when=one.when,
                    reaction=one.reaction,
                    does=WORDS[one.reaction],
                    limit=one.limit,
                    unit=one.unit,
                )
                for one in vehicle.failsafe.declared()
            ],
            depth_rating_m=vehicle.depth_rating_m,
            actuators=[
                ActuatorAnswer(
                    name=command.name,
                    kind=str(actuator.kind),
                    unit=command.unit,
                    min=command.lower,
                    max=command.upper,
                )
                for actuator in vehicle.actuators
                for command in actuator.commands
            ],
        )
