"""Mission files, and what can be done with the mission being flown."""

from fastapi import APIRouter, Body, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import BaseModel, ConfigDict, Field

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.plan.marks import Mark
from bumpless_server.web.answers.contract import CommandReply
from bumpless_server.web.answers.missions import MissionDetail, MissionSummary
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.known import Asking
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.commanding import Asked
from bumpless_server.web.routes.findings import refuse_hopeless

router = APIRouter(prefix="/api", responses=REFUSALS)


RAW = {"requestBody": {"content": {"application/yaml": {"schema": {"type": "string"}}}, "required": True}}


class Start(BaseModel):
    """Request to fly a mission."""

    model_config = ConfigDict(extra="forbid")
    name: str
    sha256: str | None = Field(None, pattern="^[0-9a-f]{64}$", description="Refuse when the file is another")
    seed: int | None = Field(None, ge=0, le=2**32 - 1)
    operator: str = Field("", max_length=80)
    despite_findings: bool = Field(
        False, description="start though a finding says that it can't work: the operator has read it"
    )


async def text_of(request: Request) -> str:
    """The request's body as text; its length is bounded for all requests alike."""
    body = await request.body()
    try:
        return body.decode("utf-8")
    except UnicodeDecodeError as error:
        raise Refusal(422, f"must be UTF-8 text; byte {error.start} is not") from error


@router.get("/missions")
def missions(console: Served) -> list[MissionSummary]:
    """All missions, built-in ones first."""
    marks = console.library.marks.all()
    return [MissionSummary.of(file, marks.get(file.name, Mark())) for file in console.missions.all()]


@router.get("/missions/{name}")
def mission(console: Served, name: str) -> MissionDetail:
    """One mission with its text."""
    file = console.missions.get(name)
    if file is None:
        raise Refusal(404, f"there is no mission {name!r}")
    return MissionDetail.of(file, console.library.marks.of(file.name))


@router.post("/missions", status_code=201, openapi_extra=RAW)
async def upload(
    console: Served, deed: Done, request: Request, response: Response, name: str, replace: bool = False
) -> MissionDetail:
    """Check and keep a mission file, sent as the body's bytes; they are kept as they are."""
    deed.tell(name=name)
    before = console.missions.get(name)
    file = await run_in_threadpool(console.library.save, name, await request.body(), replace)
    deed.tell(name=file.name, sha256=[before.sha256 if before else None, file.sha256])
    response.headers["location"] = f"/api/missions/{file.name}"
    return MissionDetail.of(file, console.library.marks.of(file.name))


def _start_request(console: Served, wanted: Start) -> pb.StartMission:
    file = console.missions.get(wanted.name)
    if file is None:
        raise Refusal(404, f"there is no mission {wanted.name!r}")
    if file.mission is None:
        raise Refusal(422, f"{file.path.name} is not valid", [one.as_dict() for one in file.problems])
    if wanted.sha256 is not None and wanted.sha256 != file.mission.sha256:
        raise Refusal(409, f"{file.name} was changed since it was shown: look at it again, then start")
    refuse_hopeless(console, file, wanted.despite_findings)
    return pb.StartMission(
        file_name=file.path.name, mission_yaml=file.text, seed=wanted.seed, operator=wanted.operator
    )


@router.post("/mission/start")
async def start(console: Served, asked: Asked, asking: Asking, wanted: Start = Body(...)) -> CommandReply:
    """Fly a stored mission. Where people log in, the operator is who asks."""
    if not asking.open:
        wanted = wanted.model_copy(update={"operator": asking.shown})
    request = await run_in_threadpool(_start_request, console, wanted)
    details = {"mission": request.file_name, "seed": wanted.seed, "despite": wanted.despite_findings}
    return await asked.carry_out("start", request, author=wanted.operator, **details)


@router.post("/mission/{verb}")
async def change(asked: Asked, verb: str) -> CommandReply:
    """Pause, resume, surface or abort."""
    if verb not in ("pause", "resume", "surface", "abort"):
        raise Refusal(404, f"there is no command {verb!r}")
    return await asked.carry_out(verb, pb.Empty())
