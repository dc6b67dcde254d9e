"""Recorded runs as the API tells them."""

from datetime import datetime
from typing import Literal

from bumpless.metrics import Ending
from bumpless_server.web.answers.contract import Answer, Metrics, Number


class RunAnswer(Answer):
    """A run in the list; of one being recorded, how far it is."""

    id: str
    run_id: str
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
    title: str = ""
    tags: list[str] = []
    note: str = ""
