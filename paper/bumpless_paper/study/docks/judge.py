"""How a drawn flight ended, by the judge of every run, and what a table needs beside it."""

import math
from dataclasses import dataclass

import numpy as np

from bumpless.config.mission.model import Target
from bumpless.metrics import Columns, figures_of
from bumpless.metrics.dock import body_of, is_inside
from bumpless.sim.twin import Result
from bumpless_paper.study.docks.cases import Case, vehicle


@dataclass(frozen=True)
class Judgement:
    """One flight, for a table."""

    number: int
    outcome: str  # a word of `bumpless.metrics.Ending`
    why: str
    time_s: float
    held_s: float  # within docked's limits, up to the end
    tried: int
    current_mps: float
    along_mps: float  # current from astern of the approach heading at the end
    across_mps: float
    tolerance_deg: float


def judge(case: Case, result: Result) -> Judgement:
    """How the flight of a case ended."""
    columns = Columns.from_log(result.log, len(result.vehicle.commands))
    metrics, outcome = figures_of(columns, result.vehicle, case.mission, "completed")
    heading = float(columns.heading[-1])
    north, east, _ = case.mission.environment.current_ned_mps
    return Judgement(
        number=case.number,
        outcome=outcome.ending.value,
        why=outcome.why,
        time_s=metrics.duration_s,
        held_s=outcome.held_s,
        tried=outcome.tries,
        current_mps=math.hypot(north, east),
        along_mps=north * math.cos(heading) + east * math.sin(heading),
        across_mps=-north * math.sin(heading) + east * math.cos(heading),
        tolerance_deg=case.mission.target.turn_deg,
    )


def hits(log: np.ndarray, target: Target) -> np.ndarray:
    """(n,) LOG rows in which a part of the hull is in the dock: along the approach heading in use, and along
    the target's own where the dock doesn't turn."""
    hit = inside_dock(log, log["approach"], target)
    if not target.turns:
        hit |= inside_dock(log, np.full(len(log), math.radians(target.heading_deg)), target)
    return hit


def inside_dock(log: np.ndarray, heading: np.ndarray, target: Target) -> np.ndarray:
    """(n,) LOG rows in which a part of the hull is in the dock behind the marker along `heading`, rad."""
    eta = np.ascontiguousarray(log["eta"])
    return is_inside(eta, eta[:, :3] - log["target_true"], heading, vehicle(), body_of(target))
