"""Writes into the audit what somebody did with what the server keeps: who, from where, to what."""

from typing import Annotated

from fastapi import Depends, Request

from bumpless_server.live.tally import printable
from bumpless_server.web.guard import address_of
from bumpless_server.web.known import who_asks
from bumpless_server.web.routes import Served

MOST_AUTHOR = 80


class Note:
    """For one request."""

    def __init__(self, request: Request, console: Served) -> None:
        self._console = console
        self._address = address_of(request.scope)
        who = who_asks(request)
        said = printable(request.headers.get("x-operator", ""))[:MOST_AUTHOR]
        self.author = who.shown if not who.open else said or who.shown

    def note(self, verb: str, **details: object) -> None:
        """Write down what was done just now."""
        self._console.audit.note(verb, self.author, self._address, details)


async def _note(request: Request, console: Served) -> Note:
    return Note(request, console)


Noting = Annotated[Note, Depends(_note)]
