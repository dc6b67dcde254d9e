"""A run's vehicle as one small mesh, for the 3-D view of replays and comparisons."""

from fastapi import APIRouter

from bumpless.config.vehicle import VehicleError, parse_vehicle
from bumpless.runs.records import read_records
from bumpless_server.scene.hull_picture import hull_picture
from bumpless_server.web.answers.contract import Answer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/runs", responses=REFUSALS)


class HullAnswer(Answer):
    """In body axes, m; faces by three vertices."""

    vertices: list[list[float]]
    faces: list[list[int]]


@router.get("/{run}/hull")
def hull(console: Served, run: str) -> HullAnswer:
    """The hull of the vehicle that flew the run, as its log describes it."""
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    for name, data in read_records(path).attachments.items():
        if name.endswith(".toml"):
            try:
                vehicle = parse_vehicle(data.decode(errors="replace"), name)
            except VehicleError as error:
                raise Refusal(422, f"run {run!r} describes no vehicle that can be drawn: {error}") from error
            return HullAnswer.model_validate(hull_picture(vehicle))
    raise Refusal(422, f"run {run!r} describes no vehicle")
