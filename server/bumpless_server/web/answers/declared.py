"""What may stand in files, as the API tells it."""

from pydantic import ConfigDict

from bumpless_server.web.answers.contract import Answer


class FieldEntry(Answer):
    """One field of a file format: where it stands, what it means and what it may hold.

    What only some types have (bounds, names, choices, pattern, default) comes beside these.
    """

    model_config = ConfigDict(extra="allow")
    path: str
    kind: str
    type: str
    label: str
    help: str
    unit: str
    required: bool
    nullable: bool
    live: bool


class Schema(Answer):
    """A JSON Schema (2020-12) with whatever it says beside these."""

    model_config = ConfigDict(extra="allow")
    title: str
    type: str
