"""The HTTP interface, one file per subject. Handlers are plain functions on worker threads."""

from typing import Annotated, cast

from fastapi import Depends, Request

from bumpless_server.console import Console


def _console(request: Request) -> Console:
    return cast(Console, request.app.state.console)


Served = Annotated[Console, Depends(_console)]
