"""What the vehicle is tuned with: read as confirmed by it, changed only through it; saved presets."""

import json
from datetime import UTC, datetime
from typing import Any
from urllib.parse import unquote

from fastapi import APIRouter, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import ValidationError

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import as_json
from bumpless_server.live import tuning
from bumpless_server.live.tally import printable
from bumpless_server.web.answers.contract import CommandReply
from bumpless_server.web.answers.parameters import ParametersAnswer, Preset
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.commanding import Asked
from bumpless_server.web.routes.missions import text_of
from bumpless_server.what_if.revisions import Revision

router = APIRouter(prefix="/api", responses=REFUSALS)
_WHOLE = {"description": "A whole set of parameters, as GET /api/parameters tells the active ones"}
_JSON = {"requestBody": {"content": {"application/json": {"schema": _WHOLE}}, "required": True}}

MOST_REASON = 300  # characters


async def _body(request: Request) -> Any:
    text = await text_of(request)
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise Refusal(422, f"must be JSON: {error}") from error


@router.get("/parameters")
def parameters(console: Served) -> ParametersAnswer:
    """What the vehicle flies with now, its defaults, and what each number may be."""
    status = console.state.latest("parameters")
    if not isinstance(status, pb.ParametersStatus):
        raise Refusal(404, f"vehicle {console.state.vehicle_id} has not told its parameters yet")
    answer = {
        "active": as_json(status.active),
        "defaults": as_json(status.defaults),
        "revision": status.revision,
        "sha256": status.sha256,
        "ranges": tuning.ranges(),
    }
    return ParametersAnswer.model_validate(answer)


@router.put("/parameters", openapi_extra=_JSON)
async def change(console: Served, asked: Asked, request: Request) -> CommandReply:
    """Ask the vehicle to fly with these, all of them; `If-Match` refuses a change of an old revision.

    `X-Reason` says why, percent-encoded.
    """
    given = await _body(request)
    wanted = await run_in_threadpool(lambda: tuning.parse(given, console.vehicle()))
    status = console.state.latest("parameters")
    before = as_json(status.active) if isinstance(status, pb.ParametersStatus) else {}
    changes = tuning.changes(before, as_json(wanted))
    why = printable(unquote(request.headers.get("x-reason", "")))[:MOST_REASON]
    reply = await asked.carry_out("set_parameters", wanted, changes=changes, why=why)
    made = Revision(
        revision=reply.revision,
        session=console.speaker.session,
        at=datetime.now(UTC),
        author=asked.author,
        reason=why,
        changes=changes,
        parameters=as_json(wanted),
    )
    await run_in_threadpool(console.revisions.add, made)
    return reply


@router.get("/parameters/revisions")
def revisions(console: Served) -> list[Revision]:
    """What was changed on this vehicle from here, newest first: by whom, why, what, and all that was set."""
    return console.revisions.all()


def _preset(kept: dict[str, Any] | None) -> Preset | None:
    """A kept preset, None for one that is none: a person may have put anything into the folder."""
    try:
        return Preset.model_validate(kept)
    except ValidationError:
        return None


# What a hand-written preset leaves out stays left out: a zero would look like somebody's choice.
@router.get("/presets", response_model_exclude_unset=True)
def presets(console: Served) -> list[Preset]:
    """All saved presets."""
    kept = (_preset(preset) for preset in console.presets.all())
    return [preset for preset in kept if preset is not None]


@router.get("/presets/{name}", response_model_exclude_unset=True)
def preset(console: Served, name: str) -> Preset:
    """One preset."""
    found = _preset(console.presets.get(name))
    if found is None:
        raise Refusal(404, f"there is no preset {name!r}")
    return found


@router.put("/presets/{name}", openapi_extra=_JSON)
async def save(console: Served, deed: Done, request: Request, name: str) -> Preset:
    """Keep or replace a preset: a whole set of parameters within the present vehicle's ranges."""
    given = await _body(request)

    def keep() -> Preset:
        # What is kept is what was understood: {"parameters": {...}} as read, or the object itself.
        inner = given.get("parameters", given) if isinstance(given, dict) else given
        before, wanted = console.presets.get(name), as_json(tuning.parse(inner, console.vehicle()))
        console.presets.save(name, wanted)
        deed.tell(changes=tuning.changes(before["parameters"] if before else {}, wanted))
        return Preset.model_validate(console.presets.get(name))

    return await run_in_threadpool(keep)


@router.delete("/presets/{name}", status_code=204)
def remove(console: Served, name: str) -> Response:
    """Forget a preset."""
    if not console.presets.delete(name):
        raise Refusal(404, f"there is no preset {name!r}")
    return Response(status_code=204)
