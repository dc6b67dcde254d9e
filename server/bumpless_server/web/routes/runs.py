"""Recorded runs: the list, one run, its log as a download, its metrics."""

from collections.abc import Iterator
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from fastapi import APIRouter, Response
from fastapi.responses import FileResponse, StreamingResponse
from pydantic import ValidationError

from bumpless.runs.info import elapsed_ns
from bumpless.runs.names import RECORDING
from bumpless.runs.pieces import piece_of
from bumpless.runs.writer import RunWriter
from bumpless_server.runs.catalogue import Row
from bumpless_server.runs.shelf import Words
from bumpless_server.web.answers.contract import Metrics
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.runs import RunAnswer
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/runs", responses=REFUSALS)

MEDIA_TYPE = "application/x-mcap"
LAST_NS = 2**63
BLOCK_BYTES = 256 * 1024


def _started(started_ns: int) -> datetime:
    """A forged or broken time is told as the beginning of all times, rather than not at all."""
    within = started_ns if 0 <= started_ns < LAST_NS else 0
    return datetime.fromtimestamp(within // 1_000_000 * 1e-3, UTC)


def _finished(row: Row, words: Words) -> RunAnswer:
    told = row.as_dict() | asdict(words)
    made: dict[str, Any] = {"started": _started(told.pop("started_ns")), "outcome": told["outcome"] or None}
    made["recorded"] = _started(row.modified_ns)
    try:
        return RunAnswer.model_validate(told | made)
    except ValidationError:  # figures that somebody else attached to the file: the run stands without them
        return RunAnswer.model_validate(told | made | {"metrics": None})


def _going_on(run: RunWriter) -> RunAnswer:
    status = run.status
    return RunAnswer(
        id=run.id,
        run_id=run.run_id,
        piece=piece_of(run.id, run.run_id),
        mission=status.mission_name,
        mission_sha256=status.mission_sha256,
        vehicle="",
        started=_started(status.stamp.time_ns - elapsed_ns(status)),
        duration_s=elapsed_ns(status) * 1e-9,
        bytes=run.flushed_bytes,
        messages=run.messages,
        dropped=0,
        state=RECORDING,
        end_reason="",
        outcome=None,
        outcome_reason="",
        metrics=None,
        recorded=datetime.now(UTC),
    )


def _going_on_of(console: Served, run: str) -> RunWriter | None:
    recording = console.recorder.recording
    return recording if recording is not None and recording.id == run else None


@router.get("")
def runs(console: Served) -> list[RunAnswer]:
    """All runs, newest first; the one being recorded at the top."""
    recording = console.recorder.recording
    finished = [_finished(row, console.shelf.words(row.summary.id)) for row in console.catalogue.rows()]
    if recording is None:
        return finished
    return [_going_on(recording), *(run for run in finished if run.id != recording.id)]


@router.get("/{run}")
def one(console: Served, run: str) -> RunAnswer:
    """One run."""
    recording = _going_on_of(console, run)
    if recording is not None:
        return _going_on(recording)
    row = console.catalogue.row(run)
    if row is None:
        raise Refusal(404, f"there is no run {run!r}")
    return _finished(row, console.shelf.words(run))


@router.get("/{run}/metrics")
def metrics(console: Served, run: str) -> Metrics:
    """The run's bumpless.Metrics."""
    found = one(console, run).metrics
    if found is None:
        raise Refusal(404, f"run {run!r} has no metrics" + (" yet" if _going_on_of(console, run) else ""))
    return found


@router.get("/{run}/log.mcap", response_class=Response, responses={200: {"content": {MEDIA_TYPE: {}}}})
def download(console: Served, run: str) -> Response:
    """The run's MCAP file; of one being recorded, what is on the disk so far."""
    recording = _going_on_of(console, run)
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    if recording is None:
        return FileResponse(path, media_type=MEDIA_TYPE, filename=f"{run}.mcap")
    size = recording.flushed_bytes
    headers = {
        "content-length": str(size),
        "content-disposition": f'attachment; filename="{run}.mcap"',
        "cache-control": "no-store",
    }
    return StreamingResponse(_first(path, size), media_type=MEDIA_TYPE, headers=headers)


@router.delete("/{run}", status_code=204)
def remove(console: Served, run: str) -> Response:
    """Put a finished run into the bin."""
    if _going_on_of(console, run) is not None:
        raise Refusal(409, f"run {run!r} is being recorded")
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    console.shelf.throw(path)
    console.catalogue.delete(run)
    return Response(status_code=204)


def _first(path: Path, size: int) -> Iterator[bytes]:
    """The first `size` bytes of a file that may be growing."""
    with path.open("rb") as file:
        while size > 0 and (block := file.read(min(size, BLOCK_BYTES))):
            size -= len(block)
            yield block
