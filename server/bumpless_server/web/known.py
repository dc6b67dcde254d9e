"""Who asks, as the guard wrote it down for the routes."""

from typing import Annotated, cast

from fastapi import Depends
from starlette.requests import HTTPConnection

from bumpless_server.access.who import Who

KEY = "bumpless.who"  # in the ASGI scope


def who_asks(connection: HTTPConnection) -> Who:
    """Who this request or WebSocket is from; the guard lets none through without."""
    return cast(Who, connection.scope[KEY])


async def _asking(connection: HTTPConnection) -> Who:
    return who_asks(connection)


Asking = Annotated[Who, Depends(_asking)]
