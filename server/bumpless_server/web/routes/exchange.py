"""Missions from and for other programs."""

from typing import Literal

from fastapi import APIRouter, Request
from fastapi.concurrency import run_in_threadpool

from bumpless.config.mission import MissionError
from bumpless.config.problems import Problem as Broken
from bumpless_server.plan.exchange.read import Imported, imported
from bumpless_server.plan.exchange.route import NotImportable
from bumpless_server.plan.exchange.write import NotExportable, exported
from bumpless_server.plan.missions import parse_planned
from bumpless_server.web.answers.contract import Problem
from bumpless_server.web.answers.exchange import ExchangeItem, ExportAnswer, ImportAnswer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)
Format = Literal["plan", "wpl", "geojson", "kml", "csv"]
_BYTES = {
    "requestBody": {
        "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}},
        "required": True,
    }
}
_TEXT = {"requestBody": {"content": {"application/yaml": {"schema": {"type": "string"}}}, "required": True}}


@router.post("/missions/import", openapi_extra=_BYTES)
async def take_in(
    console: Served, request: Request, file_name: str, vehicle: str | None = None, part: str | None = None
) -> ImportAnswer:
    """Make a mission of a foreign file's bytes, with a word on each thing that did not carry over.

    part: which of several ways, where the file holds several with names. Nothing is saved.
    QGroundControl's .plan, WPL, GeoJSON, KML (KMZ), CSV, MOOS-IvP's .bhv, Neptus' .nmis (.nmisz).
    """
    data = await request.body()
    return await run_in_threadpool(_imported, console, data, file_name[:200], vehicle, part)


@router.post("/missions/export", openapi_extra=_TEXT)
async def give_out(console: Served, request: Request, to: Format) -> ExportAnswer:
    """The mission in the body, saved or not, as another program's file."""
    data = await request.body()
    return await run_in_threadpool(_exported, console, data, to)


@router.get("/missions/{name}/export")
def export(console: Served, name: str, to: Format) -> ExportAnswer:
    """A stored mission as another program's file."""
    return _exported(console, console.library.get(name).data, to)


def _imported(
    console: Served, data: bytes, file_name: str, vehicle: str | None, part: str | None
) -> ImportAnswer:
    try:
        found = imported(data, file_name, vehicle or console.state.vehicle_id, part)
    except NotImportable as error:
        sentence = f"{file_name} {error}"
        problem = Broken(file_name, None, None, "", None, str(error))
        raise Refusal(422, sentence, [problem.as_dict()]) from error
    problems = _problems(console, found)
    name = next(line[6:] for line in found.yaml.splitlines() if line.startswith("name: "))
    items = [ExchangeItem.of(item) for item in found.items]
    return ImportAnswer(
        kind=found.kind,
        name=name,
        yaml=found.yaml,
        parts=list(found.parts),
        items=items,
        problems=problems,
    )


def _problems(console: Served, found: Imported) -> list[Problem]:
    try:
        parse_planned(found.yaml, "mission.yaml", console.vehicle())
    except MissionError as error:
        return [Problem(**problem.as_dict()) for problem in error.problems]
    return []


def _exported(console: Served, data: bytes, to: Format) -> ExportAnswer:
    mission = parse_planned(data, "mission.yaml", console.vehicle())
    try:
        found = exported(mission, to)
    except NotExportable as error:
        raise Refusal(422, f"{mission.name} {error}") from error
    return ExportAnswer(
        file_name=mission.name + found.ending,
        media_type=found.media_type,
        text=found.data.decode(),
        items=[ExchangeItem.of(item) for item in found.items],
    )
