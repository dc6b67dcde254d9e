"""What one MCAP file says about its run, as a row of a list."""

import contextlib
import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bumpless.metrics import Ending
from bumpless.runs import names
from bumpless.runs.info import RunInfo
from bumpless.runs.names import COMPLETE, INTERRUPTED
from bumpless.runs.records import read_records


@dataclass(frozen=True)
class RunSummary:
    """A finished run. `metrics` is bumpless.Metrics as JSON, None when there are none."""

    id: str
    run_id: str
    mission: str
    mission_sha256: str
    vehicle: str
    started_ns: int  # UNIX time
    duration_s: float
    state: str  # "complete" or "interrupted"
    end_reason: str
    messages: int
    dropped: int
    outcome: str  # an Ending's word; "" when the run was not judged
    outcome_reason: str  # one sentence
    metrics: dict[str, Any] | None
    seed: int = 0
    parameters_sha256: str = ""  # "": the vehicle did not say
    software_version: str = ""


def summarise(path: Path) -> RunSummary:
    """Read a file's metadata and metrics. A file that cannot be read is listed as interrupted."""
    found = read_records(path, check=True)
    metrics: dict[str, Any] | None = None
    reason = found.fault or names.CUT_OFF
    with contextlib.suppress(ValueError, RecursionError):
        text = found.attachments.get(names.METRICS)
        told = None if text is None else json.loads(text, parse_constant=lambda _: None)
        metrics = told if isinstance(told, dict) else None
    seconds = (found.last_ns - found.first_ns) * 1e-9
    info = RunInfo.read({"started_ns": str(found.first_ns)} | found.run, path.stem)
    end = found.end
    state = end.get("state", INTERRUPTED)
    reason = end.get("reason", reason)
    if found.damage:
        reason = f"{reason}; the file has changed since: {found.damage}"
    return RunSummary(
        id=path.stem,
        run_id=info.run_id,
        mission=info.mission,
        mission_sha256=info.mission_sha256,
        vehicle=info.vehicle,
        started_ns=info.started_ns,
        duration_s=_duration(end.get("duration_s"), seconds),
        state=state if state in (COMPLETE, INTERRUPTED) else INTERRUPTED,
        end_reason=reason,
        messages=_number(end.get("messages"), found.messages),
        dropped=_number(end.get("dropped"), 0),
        outcome=_ending(end.get("outcome", "")),
        outcome_reason=end.get("outcome_reason", ""),
        metrics=metrics,
        seed=info.seed,
        parameters_sha256=info.parameters_sha256,
        software_version=info.software_version,
    )


def _ending(word: str) -> str:
    return word if word in set(Ending) else ""


def _number(text: str | None, otherwise: int) -> int:
    if not text or not text.isascii() or not text.isdigit() or len(text) > 18:
        return otherwise
    return int(text)


def _duration(text: str | None, otherwise: float) -> float:
    try:
        seconds = float(text or "nan")
    except ValueError:
        return otherwise
    return seconds if math.isfinite(seconds) else otherwise
