"""How a run ended, in one word with its reason: a small record, computed from what was logged.

Where the truth is known (a simulated vehicle), it is judged by; else by what the vehicle believed. `basis`
says which.
"""

from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import HOVER, WAVED_OFF_STAGES
from bumpless.contract.modes import MODE_LETTERS
from bumpless.metrics.columns import Columns
from bumpless.metrics.dock import KEEP_OUT_M, clearance_of
from bumpless.metrics.errors import EndErrors, Errors, believed_errors, is_known, true_errors

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

POSITION_M, HEADING_DEG, SPEED_MPS, HOLD_S = 0.15, 5.0, 0.05, 10.0  # what docked means


class Ending(StrEnum):
    """The ways a run can end."""

    DOCKED = "docked"  # in H within 0.15 m, 5 deg and 0.05 m/s of the observation point for the last 10 s
    HELD = "held"  # over in H, but not docked
    WAVED_OFF = "waved_off"  # the approach was given up for a safe place
    TIME_OVER = "time_over"  # over before hover was reached
    ABORTED = "aborted"
    COLLIDED = "collided"  # whatever came after it
    INTERRUPTED = "interrupted"  # the run goes on or was cut off, as far as anybody knows

    @property
    def words(self) -> str:
        """For people: "waved off"."""
        return self.value.replace("_", " ")


How = Literal["completed", "aborted", "interrupted"]


@dataclass(frozen=True)
class Outcome:
    """How a run ended. What nobody knows is None: a real vehicle's truth, all of a run without a cycle."""

    ending: Ending
    reason: str  # one sentence
    basis: Literal["true", "believed"]  # what it was judged by
    mode: str = ""  # of the last cycle, "F", "R" or "H"
    held_s: float = 0.0  # how long, up to the end, all of docked's conditions were met
    closest_m: float | None = None  # least distance of the hull's axis from the marker
    closest_s: float | None = None  # mission time of that
    true_errors: EndErrors | None = None  # of the last cycle
    believed_errors: EndErrors | None = None
    tries: int = 0  # approaches begun, where the vehicle counts them

    @property
    def sentence(self) -> str:
        """For an operator: "Docked: held in hover for 12.0 s, ..."."""
        return f"{self.ending.words.capitalize()}: {self.reason}"

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)

    def record(self) -> dict[str, str]:
        """For a log's metadata."""
        return {"outcome": self.ending.value, "outcome_reason": self.reason, "outcome_basis": self.basis}

    def message(self) -> pb.Outcome:
        """As the contract's; NaN for what is not known."""
        nothing = float("nan")
        modes = {letter: mode for mode, letter in MODE_LETTERS.items()}
        return pb.Outcome(
            ending=cast("pb.Ending", pb.Ending.Value(f"ENDING_{self.ending.name}")),
            reason=self.reason,
            basis=self.basis,
            mode=cast("pb.Mode", modes.get(self.mode, pb.MODE_UNSPECIFIED)),
            held_s=self.held_s,
            closest_m=nothing if self.closest_m is None else self.closest_m,
            closest_s=nothing if self.closest_s is None else self.closest_s,
            true_errors=None if self.true_errors is None else self.true_errors.message(),
            believed_errors=None if self.believed_errors is None else self.believed_errors.message(),
            tries=self.tries,
        )


def outcome_of(
    run: Columns, vehicle: "Vehicle", how: How, reason: str = "", keep_out_m: float = KEEP_OUT_M
) -> Outcome:
    """The outcome of a run of `vehicle` that ended as `how`, for `reason`.

    keep_out_m: radius of the dock about its marker, across the approach heading. Whatever part of the hull's
    axis was inside it, the run has collided, and nothing later mends that.
    """
    if len(run) == 0:
        ending = Ending.TIME_OVER if how == "completed" else Ending(how)
        return Outcome(ending, reason or "No cycle of the mission was flown.", "believed")
    known, period_s = is_known(run), vehicle.control_period_s
    believed, true = believed_errors(run), true_errors(run) if known else None
    errors = true or believed
    held_s = _held_s(run, errors, period_s)
    clearance = clearance_of(run, vehicle, known)
    hits = np.flatnonzero(clearance.in_plane <= keep_out_m)
    if len(hits):
        ending, text = Ending.COLLIDED, _hit(run, errors, int(hits[0]), clearance.in_plane)
    elif how != "completed":
        ending, text = Ending(how), reason or f"The run was {how}."
    else:
        ending, text = _completed(run, errors, held_s, period_s)
    near = int(np.nanargmin(clearance.to_marker)) if np.isfinite(clearance.to_marker).any() else None
    return Outcome(
        ending=ending,
        reason=text,
        basis="true" if known else "believed",
        mode=MODE_LETTERS[int(run.mode[-1])],
        held_s=held_s,
        closest_m=None if near is None else float(clearance.to_marker[near]),
        closest_s=None if near is None else float(run.time[near]),
        true_errors=None if true is None else true.at(-1),
        believed_errors=believed.at(-1),
        tries=int(run.tried[-1]),
    )


def _completed(run: Columns, errors: Errors, held_s: float, period_s: float) -> tuple[Ending, str]:
    where = _where(run, errors)
    if held_s >= HOLD_S - 0.5 * period_s:
        return Ending.DOCKED, f"held in hover for {held_s:.1f} s, {where}."
    if int(run.stage[-1]) in WAVED_OFF_STAGES:
        return Ending.WAVED_OFF, f"the approach was given up ({_why(int(run.reason[-1]))}), {where}."
    if run.mode[-1] == HOVER:
        return Ending.HELD, f"in hover, {where}; within the limits for {held_s:.1f} s of {HOLD_S:g} s."
    return Ending.TIME_OVER, f"the time was over before hover, {where}."


def _held_s(run: Columns, errors: Errors, period_s: float) -> float:
    within = (run.mode == HOVER) & (errors.position <= POSITION_M)
    within &= (np.abs(errors.heading) <= HEADING_DEG) & (errors.speed <= SPEED_MPS)
    if not within[-1]:
        return 0.0
    # the stay begins after the last cycle that was outside, or after the last gap
    broken = np.flatnonzero(~within)
    gaps = np.flatnonzero(~run.follows)
    first = max(int(broken[-1]) + 1 if len(broken) else 0, int(gaps[-1]))
    return float(run.time[-1] - run.time[first]) + period_s


def _why(reason: int) -> str:
    """A WaveOffReason in words, where the contract has them."""
    kinds = getattr(pb, "WaveOffReason", None)
    name = kinds.Name(reason) if kinds is not None and reason in kinds.values() else f"reason {reason}"
    return name.removeprefix("WAVE_OFF_REASON_").replace("_", " ").lower()


def _hit(run: Columns, errors: Errors, row: int, in_plane: np.ndarray) -> str:
    return (
        f"the hull went through the dock's plane {in_plane[row]:.2f} m from the marker, "
        f"{run.time[row]:.1f} s after the start, at {errors.speed[row]:.2f} m/s."
    )


def _where(run: Columns, errors: Errors) -> str:
    place = "truly" if is_known(run) else "as believed"
    side = "below" if errors.depth[-1] > 0.0 else "above"
    return (
        f"{place} {errors.position[-1]:.2f} m from the observation point "
        f"({abs(errors.depth[-1]):.2f} m of it {side}), {abs(errors.heading[-1]):.1f}° off "
        f"and at {errors.speed[-1]:.3f} m/s"
    )
