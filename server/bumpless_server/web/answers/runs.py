"""Recorded runs as the API tells them."""

from datetime import datetime
from typing import Literal

from bumpless.metrics import Ending
from bumpless_server.web.answers.contract import Answer, Metrics, Number


class RunAnswer(Answer):
    """A run in the list; of one being recorded, how far it is."""

    id: str
    run_id: str
    piece: int  # of the flight `run_id`, from 1; 0: a run, or a copy of one, of its own
    mission: str
    mission_sha256: str
    vehicle: str
    started: datetime
    duration_s: Number
    bytes: int
    messages: int
    dropped: int
    state: Literal["recording", "complete", "interrupted"]
    end_reason: str
    outcome: Ending | None  # None: not judged, or not yet
    outcome_reason: str
    metrics: Metrics | None
    recorded: datetime  # when the file was last written, by the server's clock
    seed: int = 0
    parameters_sha256: str = ""  # "": the vehicle did not say
    software_version: str = ""  # of the vehicle
    title: str = ""
    tags: list[str] = []
    note: str = ""


class Stretch(Answer):
    """From one mission time to another, s."""

    first_s: Number
    last_s: Number


class FlightPiece(Stretch):
    """What one file holds of a flight; the second and later are called `<flight>.2`, `.3` ..."""

    id: str
    pace_s: Number  # from one cycle in it to the next


class FlightAnswer(Answer):
    """A flight over all its finished pieces; figures are of what was recorded of it."""

    id: str
    pieces: list[FlightPiece]
    gaps: list[Stretch]  # not recorded
    outcome: Ending | None
    outcome_reason: str
    metrics: Metrics | None
