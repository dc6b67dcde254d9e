"""Recorded runs as the same typed frames that the stream sends: a moment, or a range of them."""

import struct
from typing import Annotated, Any

from fastapi import APIRouter, Query, Response

from bumpless.contract.messages import as_json
from bumpless.runs.flight_replay import FlightReplay
from bumpless.runs.replay import NoReplay
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.answers.replay import ReplayAnswer, RunEvent
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.flight import pieces_of, stretches

router = APIRouter(prefix="/api/runs", responses=REFUSALS)

FRAMES = "application/octet-stream"
MOST = 4000  # cycles in one answer
BINARY: dict[int | str, dict[str, Any]] = {200: {"content": {FRAMES: {}}}}
Seconds = Annotated[float, Query(ge=-1e9, le=1e9, allow_inf_nan=False)]


def _replay(console: Served, run: str) -> FlightReplay:
    try:
        return console.replays.of(pieces_of(console, run))
    except NoReplay as error:
        raise Refusal(422, f"run {run!r} cannot be replayed: {error}") from error


@router.get("/{run}/replay")
def replay(console: Served, run: str) -> ReplayAnswer:
    """How long the flight is that the run is of, what happened in it, and what was not recorded."""
    found = _replay(console, run)
    events = [RunEvent.model_validate(as_json(event)) for event in found.events()]
    return ReplayAnswer(
        run=run,
        first_s=found.first_s,
        last_s=found.last_s,
        cycles=found.cycles,
        events=events,
        **stretches(found),
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
