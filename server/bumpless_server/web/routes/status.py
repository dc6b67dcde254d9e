"""Is the server well, what does it see, what happened lately, and which vehicle is it."""

from typing import Annotated

from fastapi import APIRouter, Query

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import as_json
from bumpless_server.foresight.told import HeldStation
from bumpless_server.web.answers.reach import ReachAnswer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.status import Event, Health, Status, VehicleAnswer
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)


@router.get("/health")
async def health(console: Served) -> Health:
    """The server answers; says nothing of the vehicle."""
    return Health(status="ok", version=console.version)


@router.get("/status")
def status(console: Served) -> Status:
    """ServerStatus and, when a vehicle has described itself, who it is."""
    description = console.state.latest("description")
    vehicle = as_json(description) if isinstance(description, pb.VehicleDescription) else None
    mission = console.state.latest("mission")
    told = as_json(console.status()) | {"vehicle": vehicle, "mission": as_json(mission) if mission else None}
    return Status.model_validate(told)


@router.get("/events")
def events(console: Served, limit: int = 200) -> list[Event]:
    """The last events of vehicle and server, oldest first."""
    samples = console.state.events()[-max(1, min(limit, 500)) :]
    decoded = ((sample, sample.decode()) for sample in samples)
    return [
        Event.model_validate(as_json(event) | {"receive_time_ns": str(sample.receive_ns)})
        for sample, event in decoded
        if event is not None
    ]


@router.get("/vehicle")
def vehicle(console: Served) -> VehicleAnswer:
    """The vehicle as it describes itself: the commands of its actuators in the order of u."""
    described = console.vehicle()
    if described is None:
        raise Refusal(404, f"vehicle {console.state.vehicle_id} has not described itself yet")
    return VehicleAnswer.of(described)


@router.get("/vehicle/reach")
def vehicle_reach(
    console: Served, surge_mps: Annotated[float, Query(ge=-10.0, le=10.0, allow_inf_nan=False)] = 0.0
) -> ReachAnswer:
    """What its actuators can do at a speed through the water: the attainable force and moment sets."""
    from bumpless_server.foresight.reach import reach_at

    described = console.vehicle()
    if described is None:
        raise Refusal(404, f"vehicle {console.state.vehicle_id} has not described itself yet")
    return ReachAnswer.of(described.sha256, reach_at(described, surge_mps))


@router.get("/vehicle/station")
def vehicle_station(console: Served) -> HeldStation | None:
    """On which headings it would hold station before its target in the current that it estimates.

    With the parameters that it flies with, by the rule of a mission's check. Null where nothing flies now, or
    where that vehicle does not hover.
    """
    from bumpless_server.foresight.held import station_now

    return station_now(console.state, console.vehicle())
