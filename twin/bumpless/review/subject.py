"""What of a log is compared and reported: read without its messages, where its end is there."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from bumpless.metrics import as_dict
from bumpless.runs import names
from bumpless.runs.flight import open_run
from bumpless.runs.info import RunInfo
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


def subject_of(path: Path) -> Subject:
    """Read one. Raises ValueError when the file is no log, or has no figures."""
    found = read_records(path)
    metrics, reason, outcome = _metrics(path, found)
    return Subject(
        info=RunInfo.read(found.run, path.stem),
        state=found.end.get("state", names.INTERRUPTED),
        outcome=outcome,
        reason=reason,
        metrics=metrics,
        mission=_mapping(_mission_text(found), yaml.safe_load),
        parameters=_mapping(found.attachments.get(names.PARAMETERS, b""), json.loads),
    )


def _metrics(path: Path, found: Records) -> tuple[Mapping[str, Any], str, str]:
    told = _mapping(found.attachments.get(names.METRICS, b""), json.loads)
    if told:
        return told, found.end.get("outcome_reason", ""), found.end.get("outcome", "")
    run = open_run(path)
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
