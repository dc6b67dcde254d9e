"""The one judge: every figure of a flight and how it ended, for runs, campaigns and the study alike."""

from typing import TYPE_CHECKING

from bumpless.chart import floor_of
from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics.columns import Columns
from bumpless.metrics.dock import body_of
from bumpless.metrics.outcome import DOCKED, How, Limits, Outcome, outcome_of
from bumpless.metrics.summary import metrics_of

if TYPE_CHECKING:
    from bumpless.config.mission import Mission
    from bumpless.config.vehicle import Vehicle

Figures = tuple[pb.Metrics, Outcome]


def figures_of(
    columns: Columns,
    vehicle: "Vehicle",
    mission: "Mission | None",
    how: How,
    reason: str = "",
    *,
    run_id: str = "",
    limits: Limits = DOCKED,
    checks: bool = True,
) -> Figures:
    """Metrics, which hold the outcome, and the outcome of a run that ended as `how`, for `reason`.

    mission: says where the dock stands; None where nobody knows. limits: what docked means.
    checks: as in `metrics_of`.
    """
    metrics, body = (
        metrics_of(columns, vehicle, run_id, checks=checks),
        body_of(mission.target if mission else None),
    )
    floor = floor_of(mission) if mission else None
    outcome = outcome_of(columns, vehicle, how, reason, body, limits, floor)
    metrics.outcome.CopyFrom(outcome.message())
    return metrics, outcome
