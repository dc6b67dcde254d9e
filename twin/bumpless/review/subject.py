"""What of a log is compared and reported: read without its messages, where its end is there."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from bumpless.metrics import as_dict
from bumpless.runs import names
from bumpless.runs.info import RunInfo
from bumpless.runs.open_flight import open_flight
from bumpless.runs.records import Records, read_records


@dataclass(frozen=True)
class Subject:
    """One run: who, how it ended, its figures, and what it was flown with."""

    info: RunInfo
    state: str
    outcome: str  # an Ending's word; "" when the run was not judged
    reason: str  # one sentence
    metrics: Mapping[str, Any]  # bumpless.Metrics as JSON
    mission: Mapping[str, Any]  # the file's content
    parameters: Mapping[str, Any]  # all that was flown with


def subject_of(path: Path | Sequence[Path]) -> Subject:
    """Read one: its file, or those of its pieces in order, told as the first piece tells it.

    Raises ValueError when the file is no log, or has no figures.
    """
    pieces = [path] if isinstance(path, Path) else path
    found = read_records(pieces[0])
    metrics, reason, outcome = _metrics(pieces, found)
    end = found.end if len(pieces) == 1 else read_records(pieces[-1]).end
    return Subject(
        info=RunInfo.read(found.run, pieces[0].stem),
        state=end.get("state", names.INTERRUPTED),
        outcome=outcome,
        reason=reason,
        metrics=metrics,
        mission=_mapping(_mission_text(found), yaml.safe_load),
        parameters=_mapping(found.attachments.get(names.PARAMETERS, b""), json.loads),
    )


def _metrics(pieces: Sequence[Path], found: Records) -> tuple[Mapping[str, Any], str, str]:
    told = _mapping(found.attachments.get(names.METRICS, b""), json.loads)
    if told and len(pieces) == 1:
        return told, found.end.get("outcome_reason", ""), found.end.get("outcome", "")
    run = open_flight(pieces)
    return as_dict(run.metrics), run.outcome.reason, run.outcome.ending.value


def _mission_text(found: Records) -> bytes:
    for name, data in found.attachments.items():
        if name.endswith((".yaml", ".yml")):
            return data
    return b""


def _mapping(data: bytes, read: Any) -> Mapping[str, Any]:
    try:
        value = read(data.decode()) if data else {}
    except (ValueError, yaml.YAMLError, RecursionError):
        return {}
    return value if isinstance(value, dict) else {}
