"""How a drawn flight ended, by the truth: docked, waved off, and never through the dock.

The dock's body is the mission's box behind the marker's plane; hull and struts are points that must stay out
of it, with the hull's radius.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from bumpless.config.mission.model import Target
from bumpless.contract.enums import APPROACH, HOLD, HOVER
from bumpless.sim.twin import Result
from bumpless_paper.study.docks.cases import Case

HULL_RADIUS_M = 0.1
AXIS_M, STRUTS_M = (1.036, -1.214), (-0.41, 0.41)  # nose and tail along x_b; the struts' ends along y_b
POSITION_M, HEADING_DEG, SPEED_MPS, DOCKED_S = 0.15, 5.0, 0.05, 10.0


@dataclass(frozen=True)
class Judgement:
    """One flight, for a table."""

    number: int
    outcome: str  # "docked", "waved_off", "time_over", "held_elsewhere" or "collided"
    time_s: float
    held_s: float  # longest stay that counts as docked
    tried: int
    reason: int  # WaveOffReason of the last wave-off
    current_mps: float
    along_mps: float  # current from astern of the approach heading at the end
    across_mps: float
    tolerance_deg: float
    hit_s: float | None  # when the hull was first inside the dock


def judge(case: Case, result: Result) -> Judgement:
    """How the flight of a case ended."""
    log, mission = result.log, case.mission
    hit = hits(log, mission.target)
    held = _longest(docked_rows(log, mission.target)) * result.vehicle.control_period_s
    last, heading = log[-1], float(log["approach"][-1])
    north, east, _ = mission.environment.current_ned_mps
    return Judgement(
        number=case.number,
        outcome=_outcome(bool(hit.any()), held, last, mission.duration_s),
        time_s=float(last["time"]),
        held_s=held,
        tried=int(last["tried"]),
        reason=int(last["reason"]),
        current_mps=math.hypot(north, east),
        along_mps=north * math.cos(heading) + east * math.sin(heading),
        across_mps=-north * math.sin(heading) + east * math.cos(heading),
        tolerance_deg=mission.target.turn_deg,
        hit_s=float(log["time"][np.argmax(hit)]) if hit.any() else None,
    )


def _outcome(hit: bool, held: float, last: Any, duration_s: float) -> str:
    if hit:
        return "collided"
    if held >= DOCKED_S:
        return "docked"
    if last["stage"] == HOLD:
        return "waved_off"
    return "held_elsewhere" if last["time"] < duration_s - 1.0 else "time_over"


def docked_rows(log: np.ndarray, target: Target) -> np.ndarray:
    """Rows that meet the docked criterion: in H on an allowed heading, within 0.15 m, 5 deg and 0.05 m/s."""
    a = log["approach"]
    ahead = np.stack([np.cos(a), np.sin(a), 0.0 * a], axis=1)
    gap = np.linalg.norm(log["eta"][:, :3] - (log["target_true"] - target.standoff_m * ahead), axis=1)
    speed = np.hypot(log["nu"][:, 0], log["nu"][:, 1])
    straight = np.abs(_wrapped(log["eta"][:, 5] - a)) <= math.radians(HEADING_DEG)
    off = np.abs(_wrapped(a - math.radians(target.heading_deg)))
    allowed = off <= math.radians(target.turn_deg) + 1e-6
    there = (log["mode"] == HOVER) & (log["stage"] == APPROACH) & (gap <= POSITION_M)
    return np.asarray(there & straight & allowed & (speed <= SPEED_MPS))


def hits(log: np.ndarray, target: Target) -> np.ndarray:
    """Rows in which the hull is in the dock, wherever it lies: along the approach heading in use, and along
    the target's own where the dock doesn't turn."""
    hit = inside_dock(log, log["approach"], target)
    if not target.turns:
        hit |= inside_dock(log, np.full(len(log), math.radians(target.heading_deg)), target)
    return hit


def inside_dock(log: np.ndarray, heading: np.ndarray, target: Target) -> np.ndarray:
    """Rows in which a point of the hull is in the dock, which lies behind the marker along `heading`, rad."""
    rel = hull_points(log["eta"]) - log["target_true"][:, None, :]
    c, s = np.cos(heading)[:, None], np.sin(heading)[:, None]
    along = rel[..., 0] * c + rel[..., 1] * s
    across = np.abs(-rel[..., 0] * s + rel[..., 1] * c)
    half = 0.5 * target.dock_width_m + HULL_RADIUS_M
    within = (along > 0.0) & (along < target.dock_length_m) & (across < half)
    return np.any(within & (np.abs(rel[..., 2]) < half), axis=1)


def hull_points(eta: np.ndarray) -> np.ndarray:
    """Points of the hull's axis and the struts, NED m, (rows, points, 3); pitch counts, roll does not."""
    x = np.concatenate([np.linspace(*AXIS_M, 10), [0.0, 0.0]])
    y = np.concatenate([np.zeros(10), STRUTS_M])
    psi, theta = eta[:, 5, None], eta[:, 4, None]
    return np.stack(
        [
            eta[:, 0, None] + x * np.cos(psi) * np.cos(theta) - y * np.sin(psi),
            eta[:, 1, None] + x * np.sin(psi) * np.cos(theta) + y * np.cos(psi),
            eta[:, 2, None] - x * np.sin(theta),
        ],
        axis=-1,
    )


def _wrapped(angle: np.ndarray) -> np.ndarray:
    return (angle + np.pi) % (2.0 * np.pi) - np.pi


def _longest(mask: np.ndarray) -> int:
    """Most rows in a row."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(np.int8), [0]])))
    return int((edges[1::2] - edges[::2]).max(initial=0))
