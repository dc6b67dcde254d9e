"""The mission library: names, versions, drafts, tags, the bin and templates."""

from dataclasses import asdict

from fastapi import APIRouter, Body, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import BaseModel, ConfigDict, Field

from bumpless_server.live.tuning import changes
from bumpless_server.plan.missions import MissionFile
from bumpless_server.plan.templates import templates
from bumpless_server.web.answers.library import (
    BinnedAnswer,
    Difference,
    DraftAnswer,
    TemplateAnswer,
    VersionAnswer,
    VersionText,
)
from bumpless_server.web.answers.missions import MissionDetail
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)
LARGEST_DRAFT = 200_000  # bytes
_RAW = {"requestBody": {"content": {"application/yaml": {"schema": {"type": "string"}}}, "required": True}}


class To(BaseModel):
    """Another file name."""

    model_config = ConfigDict(extra="forbid")
    to: str = Field(max_length=80)


class Marked(BaseModel):
    """What to note of a mission; null leaves as it is."""

    model_config = ConfigDict(extra="forbid")
    tags: list[str] | None = Field(None, max_length=20)
    archived: bool | None = None


def _told(console: Served, file: MissionFile) -> MissionDetail:
    return MissionDetail.of(file, console.library.marks.of(file.name))


@router.put("/missions/{name}", openapi_extra=_RAW)
async def save(
    console: Served, deed: Done, request: Request, name: str, base: str | None = None
) -> MissionDetail:
    """Check and keep a mission's bytes as they are, new or in place of its own; the version before stays in
    its history.

    base: hash of the file that was edited; when it is another by now, nothing is saved (409).
    """
    before = console.missions.get(name)
    file = await run_in_threadpool(console.library.save, name, await request.body(), True, base)
    deed.tell(name=file.name, sha256=[before.sha256 if before else None, file.sha256])
    return _told(console, file)


@router.delete("/missions/{name}")
def remove(console: Served, deed: Done, name: str) -> BinnedAnswer:
    """Put an uploaded mission into the bin; its id takes it out again."""
    before, binned = console.missions.get(name), console.library.delete(name)
    deed.tell(sha256=[before.sha256 if before else None, None], bin=binned.id)
    return BinnedAnswer.of(binned)


@router.post("/missions/{name}/rename")
def rename(console: Served, deed: Done, name: str, wanted: To = Body(...)) -> MissionDetail:
    """Give an uploaded mission another file name; history, draft and tags go with it."""
    deed.tell(name=[name, wanted.to])
    before = console.library.get(name).name
    file = console.library.rename(name, wanted.to)
    console.charts.mission_renamed(before, file.name)
    return _told(console, file)


@router.post("/missions/{name}/duplicate", status_code=201)
def duplicate(console: Served, deed: Done, name: str, wanted: To = Body(...)) -> MissionDetail:
    """A copy of a mission under another file name."""
    deed.tell(to=wanted.to)
    return _told(console, console.library.duplicate(name, wanted.to))


@router.put("/missions/{name}/marks")
def mark(console: Served, deed: Done, name: str, wanted: Marked = Body(...)) -> MissionDetail:
    """Tag a mission, or put it away (archived) and take it out again; its bytes stay as they are."""
    tags = None
    if wanted.tags is not None:
        tags = tuple(dict.fromkeys(tag.strip()[:40] for tag in wanted.tags if tag.strip()))
    before = console.library.marks.of(console.library.get(name).name)
    after = console.library.mark(name, tags, wanted.archived)
    deed.tell(changes=changes(asdict(before), asdict(after)))
    return _told(console, console.library.get(name))


@router.get("/missions/{name}/history")
def history(console: Served, name: str) -> list[VersionAnswer]:
    """Every saved version, newest first."""
    return [VersionAnswer.of(version) for version in console.library.history(name)]


@router.get("/missions/{name}/history/{version}")
def version(console: Served, name: str, version: str) -> VersionText:
    """One saved version with its text."""
    data = console.library.version(name, version)
    sha256 = next(one.sha256 for one in console.library.history(name) if one.id == version)
    return VersionText(id=version, sha256=sha256, yaml=data.decode("utf-8", errors="replace"))


@router.get("/missions/{name}/difference")
def difference(console: Served, name: str, before: str, after: str = "") -> Difference:
    """What changed from one saved version to another, or to the mission as it is; line by line."""
    unified = console.library.difference(name, before, after)
    return Difference(before=before, after=after, unified=unified)


@router.get("/missions/{name}/file", response_class=Response)
def file(console: Served, name: str) -> Response:
    """The mission's file, byte for byte."""
    found = console.library.get(name)
    return Response(
        found.data,
        media_type="application/yaml",
        headers={"content-disposition": f'attachment; filename="{found.path.name}"'},
    )


@router.get("/missions/{name}/draft")
def draft(console: Served, name: str) -> DraftAnswer:
    """Work in progress on a mission."""
    found = console.library.drafts.get(name)
    if found is None:
        raise Refusal(404, f"there is no draft of {name!r}")
    return DraftAnswer.of(found)


@router.put("/missions/{name}/draft", openapi_extra=_RAW)
async def keep_draft(console: Served, request: Request, name: str) -> DraftAnswer:
    """Keep work in progress, whatever it holds; saving the mission drops it."""
    data = await request.body()
    if len(data) > LARGEST_DRAFT:
        raise Refusal(413, f"a draft has at most {LARGEST_DRAFT} bytes")
    return DraftAnswer.of(await run_in_threadpool(console.library.drafts.put, name, data))


@router.delete("/missions/{name}/draft", status_code=204)
def drop_draft(console: Served, name: str) -> Response:
    """Forget work in progress."""
    if not console.library.drafts.drop(name):
        raise Refusal(404, f"there is no draft of {name!r}")
    return Response(status_code=204)


@router.get("/drafts")
def drafts(console: Served) -> list[DraftAnswer]:
    """All work in progress."""
    return [DraftAnswer.of(draft) for draft in console.library.drafts.all()]


@router.get("/mission-bin")
def binned(console: Served) -> list[BinnedAnswer]:
    """What was deleted, newest first."""
    return [BinnedAnswer.of(one) for one in console.library.bin.all()]


@router.post("/mission-bin/{binned}/restore")
def restore(console: Served, deed: Done, binned: str) -> MissionDetail:
    """Undo a deletion; where the name was given anew, the mission comes back under another."""
    file = console.library.restore(binned)
    deed.tell(name=file.name, sha256=[None, file.sha256])
    return _told(console, file)


@router.get("/mission-templates")
def mission_templates(console: Served, vehicle: str | None = None) -> list[TemplateAnswer]:
    """Whole missions to begin from, for a vehicle: by default the console's."""
    wanted, present = vehicle or console.state.vehicle_id, console.vehicle()
    known = present if present is not None and present.id == wanted else None
    return [TemplateAnswer.of(template) for template in templates(wanted, known)]
