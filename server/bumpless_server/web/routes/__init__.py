"""The HTTP interface, one file per subject. Handlers are plain functions on worker threads.

What must answer at all times (health, commands) is a coroutine: it waits for no free worker thread.
"""

from typing import Annotated, cast

from fastapi import Depends, Request

from bumpless_server.console import Console


async def _console(request: Request) -> Console:
    return cast(Console, request.app.state.console)


Served = Annotated[Console, Depends(_console)]
