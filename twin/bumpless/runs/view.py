"""Converters beside the writer: fed with the bus's messages, they give further messages for the log."""

import logging
from collections.abc import Iterable, Sequence
from typing import Protocol

from google.protobuf.message import Message

from bumpless.contract.messages import decoded

log = logging.getLogger(__name__)


class View(Protocol):
    """A converter, such as Foxglove's topics. It sees every message of a run in the order of the bus."""

    def wants(self, schema: str) -> bool:
        """Whether messages of this full name matter to it."""
        ...

    def see(self, message: Message) -> Iterable[tuple[str, Message]]:
        """What follows from one message, as (topic, message)."""
        ...


class Views:
    """Several views as one. What one can't show is left out, and told once of its kind."""

    def __init__(self, views: Sequence[View]) -> None:
        self._views = list(views)
        self._told: set[tuple[View, str]] = set()
        self._wanted: dict[str, list[View]] = {}  # by schema

    def see(self, schema: str, payload: bytes, message: Message | None) -> list[tuple[str, Message]]:
        """What all views make of one message, whose bytes are read at most once."""
        found: list[tuple[str, Message]] = []
        views = self._wanted.get(schema)
        if views is None:
            views = self._wanted[schema] = [view for view in self._views if view.wants(schema)]
        for view in views:
            message = message if message is not None else decoded(schema, payload)
            if message is None:
                break
            try:
                found += view.see(message)
            except Exception:
                if (view, schema) not in self._told:
                    self._told.add((view, schema))
                    log.exception("%s: a %s could not be shown", type(view).__name__, schema)
        return found
