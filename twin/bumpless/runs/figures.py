"""A run's figures: metrics and outcome, the same from memory as from the file."""

import json
from typing import Any

from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Columns, Outcome, metrics_of, outcome_of
from bumpless.metrics.outcome import How
from bumpless.runs.names import COMPLETE

Figures = tuple[pb.Metrics, Outcome]


def figures_of(columns: Columns, vehicle: Vehicle, run_id: str, how: How, reason: str = "") -> Figures:
    """Metrics and outcome of a run that ended as `how`."""
    return metrics_of(columns, vehicle, run_id), outcome_of(columns, how, vehicle.control_period_s, reason)


def how_ended(state: str, phase: int) -> How:
    """What a run's state and its vehicle's last phase say about its end."""
    if state != COMPLETE:
        return "interrupted"
    return "aborted" if phase == pb.MISSION_PHASE_ABORTED else "completed"


def json_bytes(value: Any) -> bytes:
    """JSON as it is attached to a log: the same value always gives the same bytes."""
    return json.dumps(value, indent=1, ensure_ascii=False).encode()
