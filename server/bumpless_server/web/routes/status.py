"""Is the server well, what does it see, what happened lately, and which vehicle is it."""

from typing import Any

from fastapi import APIRouter
from google.protobuf import json_format
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api")


def told(message: Message) -> dict[str, Any]:
    """A contract message as JSON with its own field names, zeros included."""
    return json_format.MessageToDict(
        message, preserving_proto_field_name=True, always_print_fields_with_no_presence=True
    )


@router.get("/health")
def health(console: Served) -> dict[str, Any]:
    """The server answers; says nothing of the vehicle."""
    return {"status": "ok", "version": console.version}


@router.get("/status")
def status(console: Served) -> dict[str, Any]:
    """ServerStatus and, when a vehicle has described itself, who it is."""
    description = console.state.latest("description")
    vehicle = None
    if isinstance(description, pb.VehicleDescription):
        vehicle = told(description)
        del vehicle["vehicle_toml"], vehicle["stamp"]
    mission = console.state.latest("mission")
    return told(console.status()) | {"vehicle": vehicle, "mission": told(mission) if mission else None}


@router.get("/events")
def events(console: Served, limit: int = 200) -> list[dict[str, Any]]:
    """The last events of vehicle and server, oldest first."""
    samples = console.state.events()[-max(1, min(limit, 500)) :]
    decoded = ((sample, sample.decode()) for sample in samples)
    return [
        told(event) | {"receive_time_ns": str(sample.receive_ns)}
        for sample, event in decoded
        if event is not None
    ]


@router.get("/vehicle")
def vehicle(console: Served) -> dict[str, Any]:
    """The vehicle as it describes itself: the commands of its actuators in the order of u."""
    described = console.vehicle()
    if described is None:
        raise Refusal(404, f"vehicle {console.state.vehicle_id} has not described itself yet")
    return {
        "id": described.id,
        "name": described.name,
        "sha256": described.sha256,
        "control_period_s": described.control_period_s,
        "controllable": list(described.controllable),
        "length_m": described.hull.length_m,
        "diameter_m": described.hull.diameter_m,
        "actuators": [
            {
                "name": command.name,
                "kind": actuator.kind,
                "unit": command.unit,
                "min": command.lower,
                "max": command.upper,
            }
            for actuator in described.actuators
            for command in actuator.commands
        ],
    }
