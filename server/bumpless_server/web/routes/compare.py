"""Recorded runs beside each other."""

from typing import Annotated

from fastapi import APIRouter, Query

from bumpless.review.compare import MOST, compare
from bumpless.review.subject import Subject, subject_of
from bumpless_server.web.answers.compare import ComparisonAnswer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/compare", responses=REFUSALS)


@router.get("")
def compared(
    console: Served, run: Annotated[list[str], Query(min_length=2, max_length=MOST)]
) -> ComparisonAnswer:
    """Two to six runs; the first is what the others are compared with."""
    return ComparisonAnswer.of(run, compare([_subject(console, name) for name in run]))


def _subject(console: Served, run: str) -> Subject:
    recording = console.recorder.recording
    if recording is not None and recording.id == run:
        raise Refusal(409, f"run {run!r} is being recorded; it can be compared when it is over")
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    try:
        return subject_of(path)
    except ValueError as error:
        raise Refusal(422, f"run {run!r} {error}") from error
