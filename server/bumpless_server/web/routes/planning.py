"""What a planner draws about each vehicle that a mission may be for."""

from fastapi import APIRouter

from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import load_vehicle, vehicle_names
from bumpless_server.web.answers.planning import Planning
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)


@router.get("/planning")
def vehicles() -> list[str]:
    """Ids of the vehicles whose files are here."""
    return list(vehicle_names())


@router.get("/planning/{vehicle}")
def planning(console: Served, vehicle: str) -> Planning:
    """One vehicle as a plan shows it: the one on the bus when it has this id, else the one of our files."""
    present = console.vehicle()
    if present is not None and present.id == vehicle:
        return Planning.of(present)
    if vehicle not in vehicle_names():
        raise Refusal(404, f"there is no vehicle {vehicle!r}")
    try:
        return Planning.of(load_vehicle(vehicle))
    except ProblemsError as error:
        raise Refusal(422, str(error), [one.as_dict() for one in error.problems]) from error
