"""What a browser needs to replay a run."""

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.answers.contract import Answer, Number, model_of
from bumpless_server.web.answers.runs import FlightPiece, Stretch


class RunEvent(model_of(pb.Event)):
    """One event of a run."""


class ReplayAnswer(Answer):
    """How long the flight is that a run is of, and what happened in it. Times are mission times, s."""

    run: str
    first_s: Number
    last_s: Number
    cycles: int
    events: list[RunEvent]
    pieces: list[FlightPiece]
    gaps: list[Stretch]  # not recorded
