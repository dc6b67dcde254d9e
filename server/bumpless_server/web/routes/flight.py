"""A flight over all the files that it was recorded in."""

from pathlib import Path
from typing import TypedDict

from fastapi import APIRouter
from pydantic import ValidationError

from bumpless.runs.flight_replay import FlightReplay
from bumpless.runs.replay import NoReplay
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.runs import FlightAnswer, FlightPiece, Stretch
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/runs", responses=REFUSALS)


class Stretches(TypedDict):
    """Of a flight: what each file holds, and what none does."""

    pieces: list[FlightPiece]
    gaps: list[Stretch]


def stretches(found: FlightReplay) -> Stretches:
    """As the API tells them."""
    return Stretches(
        pieces=[
            FlightPiece(id=p.id, first_s=p.first_s, last_s=p.last_s, pace_s=p.pace_s) for p in found.pieces
        ],
        gaps=[Stretch(first_s=first, last_s=last) for first, last in found.gaps],
    )


def pieces_of(console: Served, run: str, flown: bool = False) -> list[Path]:
    """The finished files of the flight that a run is of. Raises Refusal; see `Catalogue.pieces`."""
    recording = console.recorder.recording
    if recording is not None and recording.id == run:
        raise Refusal(409, f"run {run!r} is being recorded; this can be done when it is over")
    pieces = console.catalogue.pieces(run, flown)
    if not pieces:
        raise Refusal(404, f"there is no run {run!r}")
    return pieces


@router.get("/{run}/flight")
def flight(console: Served, run: str) -> FlightAnswer:
    """The flight that the run is of: its pieces, what is missing between them, and its figures.

    Files stay what they are: each has its own figures under its own id.
    """
    pieces = pieces_of(console, run)
    try:
        told = stretches(console.replays.of(pieces))
    except NoReplay:  # no cycle in it: no figures either
        unknown = [FlightPiece(id=p.stem, first_s=None, last_s=None, pace_s=None) for p in pieces]
        told = Stretches(pieces=unknown, gaps=[])
    figures = console.flights.of(pieces_of(console, run, flown=True))
    answer = FlightAnswer(
        id=pieces[0].stem, **told, outcome=figures.outcome, outcome_reason=figures.reason, metrics=None
    )
    try:
        return FlightAnswer.model_validate(answer.model_dump() | {"metrics": figures.metrics})
    except ValidationError:  # figures that somebody else attached to the file: the flight stands without them
        return answer
