"""Who asks and from where, as the guard wrote it down for the routes."""

from typing import Annotated, cast

from fastapi import Depends
from starlette.datastructures import Headers
from starlette.requests import HTTPConnection
from starlette.types import Scope

from bumpless_server.access.who import Who
from bumpless_server.live.tally import printable

KEY = "bumpless.who"  # in the ASGI scope
MOST_AUTHOR = 80


def address_of(scope: Scope) -> str:
    """Where a request comes from; behind a proxy that we trust, where the proxy says."""
    return (scope.get("client") or ("somebody", 0))[0]


def author_of(who: Who, headers: Headers) -> str:
    """Who asks, for the audit: the account; where nobody logs in as they say, else which browser."""
    said = printable(headers.get("x-operator", ""))[:MOST_AUTHOR] if who.open else ""
    return said or who.shown


def who_asks(connection: HTTPConnection) -> Who:
    """Who this request or WebSocket is from; the guard lets none through without."""
    return cast(Who, connection.scope[KEY])


async def _asking(connection: HTTPConnection) -> Who:
    return who_asks(connection)


Asking = Annotated[Who, Depends(_asking)]
