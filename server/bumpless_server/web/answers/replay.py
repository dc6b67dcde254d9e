"""What a browser needs to replay a run."""

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.answers.contract import Answer, Number, model_of


class RunEvent(model_of(pb.Event)):
    """One event of a run."""


class ReplayAnswer(Answer):
    """How long it is, and what happened in it. Times are mission times, s."""

    run: str
    first_s: Number
    last_s: Number
    cycles: int
    events: list[RunEvent]
