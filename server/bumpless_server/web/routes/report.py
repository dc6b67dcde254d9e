"""A run's report, made when it is asked for."""

from fastapi import APIRouter, Response

from bumpless.contract.extras import ExtraMissing
from bumpless_server.scene.hull_picture import hull_picture
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.flight import pieces_of

router = APIRouter(prefix="/api/runs", responses=REFUSALS)


@router.get("/{run}/report.html", response_class=Response, responses={200: {"content": {"text/html": {}}}})
def report(console: Served, run: str) -> Response:
    """The report of the flight that the run is of: one HTML file that fetches nothing and prints on A4."""
    pieces = pieces_of(console, run, flown=True)
    from bumpless.review.report import report_of

    try:
        text = report_of(pieces, hull_picture)
    except ExtraMissing as error:
        raise Refusal(501, str(error)) from error
    except ValueError as error:
        raise Refusal(422, f"run {run!r} {error}") from error
    return page_of(text, f"{run}.html")


def page_of(text: str, name: str) -> Response:
    """A report as an answer: it shows a log's own words, so no script runs in it but the one of ours."""
    from bumpless.review.report import policy

    headers = {
        "content-disposition": f'inline; filename="{name}"',
        "content-security-policy": f"{policy()}; sandbox allow-scripts",
        "cache-control": "no-store",
    }
    return Response(text, media_type="text/html; charset=utf-8", headers=headers)
