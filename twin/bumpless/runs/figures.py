"""What a run's figures are told as, and what its end is called: the same from memory as from the file."""

import json
from typing import Any

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Ending, Outcome
from bumpless.metrics.outcome import How
from bumpless.runs.names import COMPLETE

OUTCOME = "outcome"  # code of the event
SEVERITIES = {
    Ending.DOCKED: pb.SEVERITY_INFO,
    Ending.HELD: pb.SEVERITY_INFO,
    Ending.COLLIDED: pb.SEVERITY_ALARM,
}


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
