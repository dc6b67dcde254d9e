"""Logs brought in from elsewhere, and what runs take of the disk."""

import shutil
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Query, Request
from fastapi.concurrency import run_in_threadpool

from bumpless.contract.names import RUN
from bumpless.runs.adopt import NotOurs, adopt
from bumpless.runs.names import ENDING
from bumpless.runs.pieces import LONGEST_NAME
from bumpless_server.runs.errands import ErrandsBusy
from bumpless_server.web.answers.contract import Answer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.runs import RunAnswer
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.runs import one

router = APIRouter(prefix="/api", responses=REFUSALS)


class DiskUse(Answer):
    """Bytes that runs take, and those that are free; `max_bytes` 0: no limit."""

    runs: int
    runs_bytes: int
    bin: int
    bin_bytes: int
    free_bytes: int
    max_bytes: int


@router.get("/runs-disk")
def disk(console: Served) -> DiskUse:
    """What runs take of the disk."""
    runs, binned = (_sizes(folder) for folder in (console.data.runs, console.data.run_bin))
    return DiskUse(
        runs=len(runs),
        runs_bytes=sum(runs),
        bin=len(binned),
        bin_bytes=sum(binned),
        free_bytes=shutil.disk_usage(console.data.runs).free,
        max_bytes=console.settings.runs_max_bytes,
    )


@router.post(
    "/runs-import",
    status_code=201,
    openapi_extra={"requestBody": {"content": {"application/octet-stream": {}}, "required": True}},
)
async def bring_in(
    console: Served, deed: Done, request: Request, name: Annotated[str, Query(max_length=200)]
) -> RunAnswer:
    """Take an MCAP file with our messages into the list, also another recorder's, or one that was cut off."""
    stem = name.removesuffix(ENDING)
    if not RUN.allows(stem):
        raise Refusal(422, f"the file's name {name!r} must be {RUN.words}, and end with {ENDING}")
    if lack := await run_in_threadpool(console.budget.lack):
        raise Refusal(507, f"there is no room for another run: {lack}")
    try:
        with console.errands.folder() as folder:
            arrived = folder / f"arrived{ENDING}"
            with arrived.open("wb") as file:
                async for part in request.stream():
                    await run_in_threadpool(file.write, part)
            run = await run_in_threadpool(lambda: _taken(console, arrived, stem))
    except ErrandsBusy as error:
        raise Refusal(503, str(error)) from error
    except NotOurs as error:
        raise Refusal(422, f"{name} cannot be taken in: {error}") from error
    deed.tell(file=name, run=run)
    return await run_in_threadpool(lambda: one(console, run))


def _taken(console: Served, arrived: Path, stem: str) -> str:
    ready = arrived.with_name(f"ready{ENDING}")
    adopt(arrived, ready)
    run = _free_name(console.data.runs, stem)
    target = console.data.runs / f"{run}{ENDING}"
    ready.replace(target)
    console.catalogue.add(target)
    return run


def _free_name(folder: Path, stem: str) -> str:
    """A second file of one name is a copy, and must not be called like a piece of its flight."""
    name, number = stem, 1
    while (folder / f"{name}{ENDING}").exists():
        number += 1
        name = f"{stem[:LONGEST_NAME]}-copy{number}"
    return name


def _sizes(folder: Path) -> list[int]:
    found = []
    for path in folder.glob(f"*{ENDING}"):
        try:
            found.append(path.stat().st_size)
        except OSError:
            continue
    return found
