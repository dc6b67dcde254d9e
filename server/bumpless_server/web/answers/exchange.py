"""What the API tells of missions that come from, or go to, other programs."""

from bumpless_server.plan.exchange.route import Item
from bumpless_server.web.answers.contract import Answer, Problem


class ExchangeItem(Answer):
    """One thing and what became of it."""

    what: str  # "item 3: DO_CHANGE_SPEED"
    carried: bool
    note: str

    @classmethod
    def of(cls, item: Item) -> "ExchangeItem":
        """As it was noted."""
        return cls(what=item.what, carried=item.carried, note=item.note)


class ImportAnswer(Answer):
    """A mission made of a foreign file; nothing is saved yet."""

    kind: str  # "a QGroundControl plan"
    name: str  # proposed, for the file
    yaml: str
    parts: list[str]  # ways of the file that could be imported instead, this one among them
    items: list[ExchangeItem]
    problems: list[Problem]  # of the mission as it stands


class ExportAnswer(Answer):
    """A mission as another program's file."""

    file_name: str
    media_type: str
    text: str
    items: list[ExchangeItem]  # what the file has no place for
