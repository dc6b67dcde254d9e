"""A run for another program: whole or a range of it, as a log, a table or MOOS' own format."""

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

from fastapi import APIRouter, Query, Response
from fastapi.responses import StreamingResponse

from bumpless.runs.export import Kind
from bumpless_server.runs.errands import ErrandFailed, Errands, ErrandsBusy
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)

MEDIA = {
    "mcap": "application/x-mcap",
    "csv": "text/csv",
    "parquet": "application/vnd.apache.parquet",
    "alog": "text/plain; charset=utf-8",
}
BLOCK_BYTES = 256 * 1024
MOST_SIGNALS = 100
Seconds = Annotated[float | None, Query(ge=-1e9, le=1e9, allow_inf_nan=False)]
OBJECT = {"application/json": {"schema": {"type": "object"}}}
JSON: dict[int | str, dict[str, Any]] = {200: {"content": OBJECT}}
FILE: dict[int | str, dict[str, Any]] = {
    200: {"content": {kind.partition(";")[0]: {} for kind in MEDIA.values()}}
}


@router.get("/runs/{run}/export", response_class=Response, responses=FILE)
def export(
    console: Served,
    run: str,
    kind: Annotated[Kind, Query(alias="as")] = "mcap",
    from_s: Seconds = None,
    to_s: Seconds = None,
    signal: Annotated[list[str], Query(max_length=MOST_SIGNALS)] = [],  # noqa: B006 FastAPI copies it
) -> Response:
    """The run, or its mission times `from_s` to `to_s`, as a whole file: also of one being recorded.

    `signal`: of a table, a column or a pattern such as "navigation.*"; all columns without.
    """
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    ends = ["" if one is None else repr(one) for one in (from_s, to_s)]
    options = [f"--signal={one[:200]}" for one in signal]
    name = f"{run}{'' if from_s is to_s is None else '-part'}.{kind}"
    stream = _made(console.errands, [str(path), "--as", kind, f"--range={':'.join(ends)}", *options], name)
    try:
        next(stream)  # the file is made before its first byte goes out: a refusal is still possible
    except ErrandsBusy as error:
        raise Refusal(503, str(error)) from error
    except ErrandFailed as error:
        raise Refusal(422, f"run {run!r} cannot be exported: {error}") from error
    headers = {"content-disposition": f'attachment; filename="{name}"', "cache-control": "no-store"}
    return StreamingResponse(stream, media_type=MEDIA[kind], headers=headers)


@router.get("/foxglove_layout.json", response_class=Response, responses=JSON)
def layout() -> Response:
    """A layout for our logs in Foxglove and Lichtblick."""
    from bumpless_server.views.foxglove import layout as stored

    headers = {"content-disposition": 'attachment; filename="foxglove_layout.json"'}
    return Response(stored(), media_type="application/json", headers=headers)


def _made(errands: Errands, arguments: list[str], name: str) -> Iterator[bytes]:
    """First nothing, once the file is there; then its bytes. Its folder goes with the last of them."""
    with errands.folder() as folder:
        target: Path = folder / name
        errands.run(["export", *arguments, "--out", str(target)])
        with target.open("rb") as file:
            yield b""
            while block := file.read(BLOCK_BYTES):
                yield block
