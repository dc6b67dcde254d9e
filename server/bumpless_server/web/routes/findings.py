"""What stands against a mission: asked for, and in the way of a start."""

from fastapi import APIRouter, Request
from fastapi.concurrency import run_in_threadpool

from bumpless.config.problems import Problem as Broken
from bumpless.config.text import BOM
from bumpless.config.yaml_text import YamlText
from bumpless_server.foresight.checked import checked
from bumpless_server.plan.missions import MissionFile
from bumpless_server.web.answers.findings import CheckAnswer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)
_TEXT = {"requestBody": {"content": {"application/yaml": {"schema": {"type": "string"}}}, "required": True}}


@router.post("/missions/check", openapi_extra=_TEXT)
async def check(console: Served, request: Request, file_name: str = "mission.yaml") -> CheckAnswer:
    """Check a mission's bytes without keeping them, as `bumpless validate --json` does."""
    data = await request.body()
    told = await run_in_threadpool(checked, data, file_name[:200], console.vehicle(), console.charts.laid)
    return CheckAnswer.model_validate(told)


@router.get("/missions/{name}/findings")
def findings(console: Served, name: str) -> CheckAnswer:
    """Check a stored mission."""
    file = console.library.get(name)
    return CheckAnswer.model_validate(
        checked(file.data, file.path.name, console.vehicle(), console.charts.laid)
    )


def refuse_hopeless(console: Served, file: MissionFile, despite: bool) -> None:
    """Refuse to start what can't work, with the findings; `despite`: the operator has read them."""
    if file.mission is None or despite:
        return
    found = console.findings.of(file.mission, console.vehicle())
    hard = [one for one in found if one.severity == "hard"]
    if not hard:
        return
    text, name = YamlText(file.mission.text.removeprefix(BOM), file.path.name), file.path.name
    problems = [
        Broken(
            name, one.line, one.column, one.path, text.said(one.path), f"{one.reason} {one.change}".strip()
        ).as_dict()
        for one in hard
    ]
    sentence = f"{file.path.name} can't work as it stands: {hard[0].reason}"
    raise Refusal(422, sentence, problems, findings=[one.model_dump() for one in found])
