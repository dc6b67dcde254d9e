"""Recorded runs as the same typed frames that the stream sends: a moment, or a range of them."""

import struct
from typing import Annotated, Any

from fastapi import APIRouter, Query, Response

from bumpless.contract.messages import as_json
from bumpless.runs.replay import NoReplay, Replay
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.replay import ReplayAnswer, RunEvent
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/runs", responses=REFUSALS)

FRAMES = "application/octet-stream"
MOST = 4000  # cycles in one answer
BINARY: dict[int | str, dict[str, Any]] = {200: {"content": {FRAMES: {}}}}
Seconds = Annotated[float, Query(ge=-1e9, le=1e9, allow_inf_nan=False)]


def _replay(console: Served, run: str) -> Replay:
    recording = console.recorder.recording
    if recording is not None and recording.id == run:
        raise Refusal(409, f"run {run!r} is being recorded; it can be replayed when it is over")
    path = console.catalogue.path(run)
    if path is None:
        raise Refusal(404, f"there is no run {run!r}")
    try:
        return console.replays.of(path)
    except NoReplay as error:
        raise Refusal(422, f"run {run!r} cannot be replayed: {error}") from error


@router.get("/{run}/replay")
def replay(console: Served, run: str) -> ReplayAnswer:
    """How long the run is and what happened in it."""
    found = _replay(console, run)
    events = [RunEvent.model_validate(as_json(event)) for event in found.events()]
    return ReplayAnswer(
        run=run, first_s=found.first_s, last_s=found.last_s, cycles=found.cycles, events=events
    )


@router.get("/{run}/at", response_class=Response, responses=BINARY)
def at(console: Served, run: str, t: Seconds) -> Response:
    """What was known at mission time `t`, s: one StreamFrame with the last message of each topic."""
    return Response(_replay(console, run).at(t).SerializeToString(), media_type=FRAMES)


@router.get("/{run}/frames", response_class=Response, responses=BINARY)
def frames(
    console: Served,
    run: str,
    from_s: Seconds,
    to_s: Seconds,
    most: Annotated[int, Query(ge=1, le=MOST)] = MOST,
) -> Response:
    """The cycles of a range as StreamFrames, each behind its length (32 bit, little endian).

    Where there are more than `most`, cycles are left out evenly.
    """
    parts = bytearray()
    for frame in _replay(console, run).frames(from_s, to_s, most):
        data = frame.SerializeToString()
        parts += struct.pack("<I", len(data)) + data
    return Response(bytes(parts), media_type=FRAMES)
