"""What people say of runs."""

from typing import Annotated

from pydantic import BaseModel, Field, StringConstraints

from bumpless_server.web.answers.contract import Answer

Tag = Annotated[str, StringConstraints(max_length=40)]


class RunWords(BaseModel):
    """Title, tags and note of a run."""

    title: Annotated[str, StringConstraints(max_length=120)] = ""
    tags: Annotated[list[Tag], Field(max_length=20)] = []
    note: Annotated[str, StringConstraints(max_length=4000)] = ""


class BinnedRun(Answer):
    """A run in the bin."""

    id: str
    title: str
    bytes: int
