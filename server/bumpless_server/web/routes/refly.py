"""A counterfactual: a run's mission flown again with something changed, kept as a run of its own."""

import json
from typing import Any

from fastapi import APIRouter
from pydantic import BaseModel, ConfigDict, Field

from bumpless.runs.names import ENDING
from bumpless_server.runs.errands import ErrandFailed, ErrandsBusy
from bumpless_server.runs.recorder import free_id
from bumpless_server.runs.shelf import Words
from bumpless_server.web.answers.contract import Answer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/runs", responses=REFUSALS)

TAG = "counterfactual"


class Again(BaseModel):
    """What shall differ from the run; nothing: only to see whether it flies the same."""

    model_config = ConfigDict(extra="forbid")
    parameters: dict[str, Any] = Field(
        default_factory=dict, max_length=200, description='by path: {"hover.lambda": 0.01}'
    )
    vehicle: str | None = Field(
        None, max_length=80, pattern=r"^[A-Za-z0-9_-]+$", description="another vehicle's id"
    )
    seed: int | None = Field(None, ge=0, le=2**32 - 1)
    as_seen: bool | None = Field(
        None,
        description="with the current and target that the vehicle saw; null: where nobody knows the truth",
    )


class Reflown(Answer):
    """The new run."""

    id: str


@router.post("/{run}/refly", status_code=201)
def refly(console: Served, deed: Done, run: str, body: Again) -> Reflown:
    """Fly it again in a process of low priority; the answer comes when the new run is in the list."""
    recording = console.recorder.recording
    if recording is not None and recording.id == run:
        raise Refusal(409, f"run {run!r} is being recorded; it can be flown again when it is over")
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    if lack := console.budget.lack():
        raise Refusal(507, f"there is no room for another run: {lack}")
    options = [f"--set={name}={json.dumps(value)}" for name, value in body.parameters.items()]
    options += [f"--vehicle={body.vehicle}"] if body.vehicle else []
    options += [f"--seed={body.seed}"] if body.seed is not None else []
    options += [] if body.as_seen is None else ["--as-seen" if body.as_seen else "--as-planned"]
    try:
        with console.errands.folder() as folder:
            made = folder / f"again{ENDING}"
            console.errands.run(["refly", str(path), *options, "--json", "--out", str(made)])
            name = free_id(console.data.runs, f"{run[:110]}-again")
            target = console.data.runs / f"{name}{ENDING}"
            made.replace(target)
    except ErrandsBusy as error:
        raise Refusal(503, str(error)) from error
    except ErrandFailed as error:
        raise Refusal(422, f"run {run!r} cannot be flown again: {error}") from error
    console.catalogue.add(target)
    row = console.catalogue.row(run)
    title = console.shelf.words(run).title or (row.summary.mission if row else "") or run
    changes = [f"{path} {json.dumps(value)}" for path, value in body.parameters.items()]
    changes += [f"vehicle {body.vehicle}"] if body.vehicle else []
    changes += [f"seed {body.seed}"] if body.seed is not None else []
    what = ", ".join(changes) or "nothing changed"
    console.shelf.write(name, Words(f"{title}: {what}"[:120], (TAG,), f"{run} flown again: {what}"[:4000]))
    deed.tell(made=name, what=what)
    return Reflown(id=name)
