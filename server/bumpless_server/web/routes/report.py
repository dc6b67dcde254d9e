"""A run's report, made when it is asked for."""

from fastapi import APIRouter, Response

from bumpless.contract.extras import ExtraMissing
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/runs", responses=REFUSALS)

# it shows a log's own words: no script runs in it, whatever they are
POLICY = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; sandbox"


@router.get("/{run}/report.html", response_class=Response, responses={200: {"content": {"text/html": {}}}})
def report(console: Served, run: str) -> Response:
    """The run's report: one HTML file that fetches nothing and prints on A4."""
    recording = console.recorder.recording
    if recording is not None and recording.id == run:
        raise Refusal(409, f"run {run!r} is being recorded; its report can be made when it is over")
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    from bumpless.review.report import report_of

    try:
        text = report_of(path)
    except ExtraMissing as error:
        raise Refusal(501, str(error)) from error
    except ValueError as error:
        raise Refusal(422, f"run {run!r} {error}") from error
    headers = {
        "content-disposition": f'inline; filename="{run}.html"',
        "content-security-policy": POLICY,
        "cache-control": "no-store",
    }
    return Response(text, media_type="text/html; charset=utf-8", headers=headers)
