"""The one shape of every refusal."""

from typing import Any

from pydantic import ConfigDict

from bumpless_server.web.answers.contract import Answer, Problem


class Refused(Answer):
    """Why it was not done: one sentence, and each problem with its place."""

    model_config = ConfigDict(extra="allow")  # a vehicle's refusal brings its whole reply
    detail: str
    problems: list[Problem]


REFUSALS: dict[int | str, dict[str, Any]] = {
    "4XX": {"model": Refused, "description": "Refused, with the reason"},
    "5XX": {"model": Refused, "description": "Not possible now: no vehicle answers, too much waits, no room"},
}
