"""Saved views of the list of runs."""

from typing import Annotated, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field

from bumpless.metrics import Ending
from bumpless_server.runs.run_views import RunView
from bumpless_server.web.answers.contract import Answer

Column = Literal[
    "recorded",
    "duration",
    "closest",
    "error",
    "steps",
    "seed",
    "revision",
    "vehicle",
    "note",
    "size",
]
COLUMNS: tuple[str, ...] = get_args(Column)


class RunViewBody(BaseModel):
    """What a view shows: runs with these words and this outcome, and these columns beside the title."""

    model_config = ConfigDict(extra="forbid")
    words: Annotated[str, Field(max_length=200)] = ""
    outcome: Ending | Literal["recording", ""] = ""
    columns: Annotated[list[Column], Field(max_length=len(COLUMNS))] = []


class RunViewAnswer(Answer):
    """A view by its name, and who kept it last."""

    name: str
    words: str
    outcome: Ending | Literal["recording", ""]
    columns: list[Column]
    author: str

    @classmethod
    def of(cls, name: str, view: RunView) -> "RunViewAnswer":
        """What a newer or older server kept and this one does not know is left out."""
        known = view.outcome in {*Ending, "recording"}
        return cls.model_validate(
            {
                "name": name,
                "words": view.words,
                "outcome": view.outcome if known else "",
                "columns": [column for column in view.columns if column in COLUMNS],
                "author": view.author,
            }
        )
