"""What people say of runs, and the bin."""

from dataclasses import asdict

from fastapi import APIRouter, Response

from bumpless_server.live.tuning import changes
from bumpless_server.runs.shelf import Words
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.shelf import BinnedRun, RunWords
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)


@router.put("/runs/{run}/words", status_code=204)
def write(console: Served, deed: Done, run: str, body: RunWords) -> Response:
    """Give a run a title, tags and a note; the log itself stays as it is."""
    if console.catalogue.path(run) is None:
        raise Refusal(404, f"there is no run {run!r}")
    tags = tuple(dict.fromkeys(tag.strip() for tag in body.tags if tag.strip()))
    before, after = console.shelf.words(run), Words(body.title.strip(), tags, body.note.strip())
    console.shelf.write(run, after)
    deed.tell(changes=changes(asdict(before), asdict(after)))
    return Response(status_code=204)


@router.get("/bin")
def binned(console: Served) -> list[BinnedRun]:
    """The runs in the bin, the newest first."""
    return [
        BinnedRun(id=path.stem, title=console.shelf.words(path.stem).title, bytes=path.stat().st_size)
        for path in console.shelf.thrown()
    ]


@router.post("/bin/{run}/restore", status_code=204)
def restore(console: Served, run: str) -> Response:
    """Take a run out of the bin again."""
    try:
        path = console.shelf.take_back(run, console.data.runs)
    except FileExistsError as error:
        raise Refusal(409, str(error)) from error
    if path is None:
        raise Refusal(404, f"there is no run {run!r} in the bin")
    console.catalogue.add(path)
    return Response(status_code=204)


@router.delete("/bin/{run}", status_code=204)
def empty(console: Served, run: str) -> Response:
    """Delete a run in the bin for good."""
    found = [path for path in console.shelf.thrown() if path.stem == run]
    if not found:
        raise Refusal(404, f"there is no run {run!r} in the bin")
    found[0].unlink(missing_ok=True)
    console.shelf.write(run, Words())
    return Response(status_code=204)
