"""How a run ended, in one word with its reason: a small record, computed from the run's last cycles.

Where the truth is known (a simulated vehicle), it is judged by; else by what the vehicle believed. `basis`
says which. Nothing tells of a wave-off or a collision yet, so WAVED_OFF and COLLIDED do not occur.
"""

from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import Any, Literal

import numpy as np

from bumpless.contract.enums import HOVER
from bumpless.contract.modes import MODE_LETTERS
from bumpless.metrics.columns import Columns, Floats

POSITION_M, HEADING_DEG, SPEED_MPS, HOLD_S = 0.15, 5.0, 0.05, 10.0  # what docked means


class Ending(StrEnum):
    """The ways a run can end."""

    DOCKED = "docked"  # in H within 0.15 m, 5 deg and 0.05 m/s of the observation point for the last 10 s
    HELD = "held"  # completed in H, but not docked
    WAVED_OFF = "waved_off"  # the approach was given up for a safe place
    TIME_OVER = "time_over"  # completed before hover was reached
    ABORTED = "aborted"
    COLLIDED = "collided"
    INTERRUPTED = "interrupted"  # the run goes on or was cut off, as far as anybody knows


How = Literal["completed", "aborted", "interrupted"]


@dataclass(frozen=True)
class Outcome:
    """How a run ended. Errors are those of its last cycle, by `basis`; NaN when no cycle was flown."""

    ending: Ending
    reason: str  # one sentence
    basis: Literal["true", "believed"]  # what position, heading and speed were judged by
    mode: str  # "F", "R", "H", or "" when no cycle was flown
    range_m: float  # horizontal, to the observation point, as believed
    position_error_m: float  # 3-D distance from the observation point, the vertical part included
    depth_error_m: float  # positive below it
    heading_error_deg: float  # from the approach heading, -180 to 180
    speed_mps: float  # over ground, 3-D
    held_s: float  # how long, up to the end, all of docked's conditions were met

    def as_dict(self) -> dict[str, Any]:
        """For JSON: None for NaN."""
        return {name: None if value != value else value for name, value in asdict(self).items()}

    def record(self) -> dict[str, str]:
        """For a log's metadata."""
        return {"outcome": self.ending.value, "outcome_reason": self.reason, "outcome_basis": self.basis}


@dataclass(frozen=True)
class _Errors:
    basis: Literal["true", "believed"]
    position: Floats  # (n,) m, 3-D
    depth: Floats  # (n,) m
    heading: Floats  # (n,) deg
    speed: Floats  # (n,) m/s


def outcome_of(columns: Columns, how: How, period_s: float, reason: str = "") -> Outcome:
    """The outcome of a run that ended as `how`, for `reason`; `period_s` is the control period."""
    if len(columns) == 0:
        ending = {"aborted": Ending.ABORTED, "interrupted": Ending.INTERRUPTED}.get(how, Ending.TIME_OVER)
        nothing = float("nan")
        text = reason or "No cycle of the mission was flown."
        return Outcome(ending, text, "believed", "", *[nothing] * 5, held_s=0.0)
    errors = _errors(columns)
    held_s = _held_s(columns, errors, period_s)
    hovers = int(columns.mode[-1]) == HOVER
    if how != "completed":
        ending, text = Ending(how), reason or f"The run was {how}."
    elif held_s >= HOLD_S - 0.5 * period_s:
        ending, text = Ending.DOCKED, f"Held in hover for {held_s:.1f} s, {_where(errors)}."
    elif hovers:
        ending = Ending.HELD
        text = f"In hover, {_where(errors)}; within the limits for {held_s:.1f} s of {HOLD_S:g} s."
    else:
        ending, text = Ending.TIME_OVER, f"The time was over before hover, {_where(errors)}."
    return Outcome(
        ending=ending,
        reason=text,
        basis=errors.basis,
        mode=MODE_LETTERS[int(columns.mode[-1])],
        range_m=float(columns.range[-1]),
        position_error_m=float(errors.position[-1]),
        depth_error_m=float(errors.depth[-1]),
        heading_error_deg=float(errors.heading[-1]),
        speed_mps=float(errors.speed[-1]),
        held_s=held_s,
    )


def _errors(c: Columns) -> _Errors:
    """From the observation point and the approach heading: true where each of the last cycles knows them."""
    true = bool(np.isfinite(c.eta[-1]).all() and np.isfinite(c.target_true[-1]).all())
    eta, nu = (c.eta, c.nu) if true else (c.eta_hat, c.nu_hat)
    point = c.observation_point
    if true:  # it stands off the target by as much as is believed
        point = point + (c.target_true - c.target[:, :3])
    off = eta[:, :3] - point
    return _Errors(
        basis="true" if true else "believed",
        position=np.linalg.norm(off, axis=1),
        depth=off[:, 2],
        heading=(np.degrees(eta[:, 5] - c.target[:, 3]) + 180.0) % 360.0 - 180.0,
        speed=np.linalg.norm(nu[:, :3], axis=1),
    )


def _held_s(c: Columns, errors: _Errors, period_s: float) -> float:
    within = (c.mode == HOVER) & (errors.position <= POSITION_M)
    within &= (np.abs(errors.heading) <= HEADING_DEG) & (errors.speed <= SPEED_MPS)
    if not within[-1]:
        return 0.0
    # the stay begins after the last cycle that was outside, or after the last gap
    broken = np.flatnonzero(~within)
    gaps = np.flatnonzero(~c.follows)
    first = max(int(broken[-1]) + 1 if len(broken) else 0, int(gaps[-1]))
    return float(c.time[-1] - c.time[first]) + period_s


def _where(errors: _Errors) -> str:
    place = "truly" if errors.basis == "true" else "as believed"
    return (
        f"{place} {errors.position[-1]:.2f} m from the observation point, "
        f"{abs(errors.heading[-1]):.1f}° off and at {errors.speed[-1]:.3f} m/s"
    )
