"""What a run's figures are told as, and what its end is called: the same from memory as from the file."""

import json
import math
from typing import TYPE_CHECKING, Any

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Columns, Ending, Figures, Outcome, figures_of
from bumpless.metrics.columns import GAP_S
from bumpless.metrics.outcome import How
from bumpless.runs.info import elapsed_ns
from bumpless.runs.names import COMPLETE

if TYPE_CHECKING:
    from bumpless.config.mission import Mission
    from bumpless.config.vehicle import Vehicle

OUTCOME = "outcome"  # code of the event
SEVERITIES = {
    Ending.DOCKED: pb.SEVERITY_INFO,
    Ending.HELD: pb.SEVERITY_INFO,
    Ending.COLLIDED: pb.SEVERITY_ALARM,
}


def figures_of_log(
    columns: Columns,
    vehicle: "Vehicle | None",
    mission: "Mission | None",
    status: pb.MissionStatus,
    state: str,
    reason: str,
    run_id: str,
) -> Figures | None:
    """Metrics and outcome of what was recorded of a run; None without a cycle of it or a usable vehicle.

    status: the last that the vehicle said. state, reason: how the recording ended.
    """
    if vehicle is None or len(columns) == 0:
        return None
    how, why = _how_ended(columns, status, state, reason)
    return figures_of(columns, vehicle, mission, how, why, run_id=run_id)


def _how_ended(columns: Columns, status: pb.MissionStatus, state: str, reason: str) -> tuple[How, str]:
    """What the outcome starts from: a completed run is judged by its flight alone, where that is known."""
    if state != COMPLETE:
        return "interrupted", reason
    if status.phase == pb.MISSION_PHASE_ABORTED:
        return "aborted", reason
    missing_s = elapsed_ns(status) * 1e-9 - float(columns.time.max())
    ended = status.stamp.cycle or math.inf  # its time alone may have leapt
    if missing_s > GAP_S and ended > columns.cycle[-1] and not columns.lost:
        return "interrupted", f"the last {missing_s:.1f} s of the flight were not recorded"
    return "completed", ""


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
