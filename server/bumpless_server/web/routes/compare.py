"""Recorded runs beside each other."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query, Response

from bumpless.contract.extras import ExtraMissing
from bumpless.review.compare import MOST, compare
from bumpless.review.subject import Subject, subject_of
from bumpless_server.scene.hull_picture import hull_picture
from bumpless_server.web.answers.compare import ComparisonAnswer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.flight import pieces_of
from bumpless_server.web.routes.report import page_of

router = APIRouter(prefix="/api/compare", responses=REFUSALS)


@router.get("")
def compared(
    console: Served, run: Annotated[list[str], Query(min_length=2, max_length=MOST)]
) -> ComparisonAnswer:
    """Two to six runs; the first is what the others are compared with."""
    return ComparisonAnswer.of(run, compare([_subject(console, name) for name in run]))


@router.get("/report.html", response_class=Response, responses={200: {"content": {"text/html": {}}}})
def report(
    console: Served,
    run: Annotated[list[str], Query(min_length=2, max_length=MOST)],
    align: Literal["start", "reverse", "hover", "end"] = "start",
) -> Response:
    """Two to six runs compared, as one HTML file that fetches nothing."""
    from bumpless.review.compared_report import comparison_report

    paths = [pieces_of(console, name, flown=True) for name in run]
    try:
        text = comparison_report(paths, align, hull_picture)
    except ExtraMissing as error:
        raise Refusal(501, str(error)) from error
    except ValueError as error:
        raise Refusal(422, f"they cannot be compared: {error}") from error
    return page_of(text, "comparison.html")


def _subject(console: Served, run: str) -> Subject:
    pieces = pieces_of(console, run, flown=True)
    try:
        return subject_of(pieces)
    except ValueError as error:
        raise Refusal(422, f"run {run!r} {error}") from error
