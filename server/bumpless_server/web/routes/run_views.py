"""Saved views of the list of runs, shared by all."""

from dataclasses import asdict

from fastapi import APIRouter, Response

from bumpless.contract.names import NameRule
from bumpless_server.live.tuning import changes
from bumpless_server.runs.run_views import RunView, TooMany
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.run_views import RunViewAnswer, RunViewBody
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/run-views", responses=REFUSALS)

VIEW = NameRule(r"[^\x00-\x20\x7f/\\](?:[^\x00-\x1f\x7f/\\]{0,58}[^\x00-\x20\x7f/\\])?",
                "1 to 60 characters without '/', '\\' and blanks at its ends")  # fmt: skip


@router.get("")
def views(console: Served) -> list[RunViewAnswer]:
    """All saved views, by name."""
    return [RunViewAnswer.of(name, view) for name, view in console.run_views.all().items()]


@router.put("/{name}")
def keep(console: Served, deed: Done, name: str, body: RunViewBody) -> RunViewAnswer:
    """Keep a view for all, new or in the place of the one of that name."""
    view = RunView(body.words.strip(), body.outcome, tuple(dict.fromkeys(body.columns)), deed.author)
    try:
        before = console.run_views.keep(VIEW.check(name, "view"), view)
    except TooMany as error:
        raise Refusal(409, str(error)) from error
    changed = {} if before is None else changes(asdict(before), asdict(view))
    deed.tell(replaced=before is not None, changes=changed)
    return RunViewAnswer.of(name, view)


@router.delete("/{name}", status_code=204)
def forget(console: Served, name: str) -> Response:
    """Forget a view; the runs in it stay."""
    if console.run_views.forget(name) is None:
        raise Refusal(404, f"there is no view {name!r}")
    return Response(status_code=204)
