"""A run's figures: metrics and outcome, the same from memory as from the file."""

import json
from typing import Any

from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Columns, Ending, Outcome, metrics_of, outcome_of
from bumpless.metrics.outcome import How
from bumpless.runs.names import COMPLETE

Figures = tuple[pb.Metrics, Outcome]
OUTCOME = "outcome"  # code of the event
SEVERITIES = {
    Ending.DOCKED: pb.SEVERITY_INFO,
    Ending.HELD: pb.SEVERITY_INFO,
    Ending.COLLIDED: pb.SEVERITY_ALARM,
}


def figures_of(columns: Columns, vehicle: Vehicle, run_id: str, how: How, reason: str = "") -> Figures:
    """Metrics, which hold the outcome, and the outcome of a run that ended as `how`."""
    metrics, outcome = metrics_of(columns, vehicle, run_id), outcome_of(columns, vehicle, how, reason)
    metrics.outcome.CopyFrom(outcome.message())
    return metrics, outcome


def how_ended(state: str, phase: int) -> How:
    """What a run's state and its vehicle's last phase say about its end."""
    if state != COMPLETE:
        return "interrupted"
    return "aborted" if phase == pb.MISSION_PHASE_ABORTED else "completed"


def why_ended(how: How, reason: str) -> str:
    """What the outcome's reason starts from: a completed run is judged by its flight alone."""
    return "" if how == "completed" else reason


def outcome_event(outcome: Outcome, status: pb.MissionStatus) -> pb.Event:
    """The last event of a run; `status` is the last that its vehicle said."""
    at = status.stamp
    stamp = pb.Stamp(time_ns=at.time_ns, mission_time_s=status.elapsed_s, cycle=at.cycle)
    severity = SEVERITIES.get(outcome.ending, pb.SEVERITY_WARNING)
    details = {"ending": outcome.ending.value, "basis": outcome.basis}
    return pb.Event(stamp=stamp, severity=severity, code=OUTCOME, text=outcome.sentence, details=details)


def json_bytes(value: Any) -> bytes:
    """JSON as it is attached to a log: the same value always gives the same bytes."""
    return json.dumps(value, indent=1, ensure_ascii=False).encode()
