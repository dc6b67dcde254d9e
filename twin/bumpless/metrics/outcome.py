"""How a run ended, in one word with its reason: a small record, computed from what was logged.

The one judge of runs, campaigns and the study. Where the truth is known (a simulated vehicle), it is judged
by; else by what the vehicle believed. `basis` says which.
"""

from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from bumpless.chart import Floor
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import HOVER, WAVED_OFF_STAGES
from bumpless.contract.modes import LOOKS, MODE_LETTERS
from bumpless.metrics.capture import Capture, capture_of
from bumpless.metrics.columns import GAP_S, Columns
from bumpless.metrics.dock import ANY_SIDE, Body, Clearance, clearance_of
from bumpless.metrics.errors import EndErrors, Errors, believed_errors, is_known, true_errors
from bumpless.metrics.floor import floor_clearance

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle


@dataclass(frozen=True)
class Limits:
    """What docked means: in H, this close to the observation point, for the last seconds of the run."""

    position_m: float = 0.15  # over three axes
    heading_deg: float = 5.0
    speed_mps: float = 0.05  # over ground
    hold_s: float = 10.0


DOCKED = Limits()


class Ending(StrEnum):
    """The ways a run can end."""

    DOCKED = "docked"  # captured, where there is a dock to enter; else within `Limits` up to the end
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
    why: str  # the same in a few words without numbers, to count by
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
    run: Columns,
    vehicle: "Vehicle",
    how: How,
    reason: str = "",
    body: Body = ANY_SIDE,
    limits: Limits = DOCKED,
    floor: Floor | None = None,
) -> Outcome:
    """The outcome of a run of `vehicle` that ended as `how`, for `reason`.

    body: the dock. Whenever a part of the hull was inside it or in the sea floor, the run has collided, and
    nothing later mends that.
    """
    if len(run) == 0:
        ending = Ending.TIME_OVER if how == "completed" else Ending(how)
        return Outcome(ending, reason or "No cycle of the mission was flown.", "no cycle flown", "believed")
    known, period_s = is_known(run), vehicle.control_period_s
    believed, true = believed_errors(run), true_errors(run) if known else None
    errors = true or believed
    held_s = _held_s(run, errors, period_s, limits)
    clearance, dock = clearance_of(run, vehicle, known, body), capture_of(run)
    if clearance.inside.any():
        ending, text, why = _collided(run, errors, clearance)
    elif (ground := _grounded(run, vehicle, known, floor)) is not None:
        ending, text, why = ground
    elif dock and dock.overloaded:
        ending, text, why = Ending.COLLIDED, dock.harm, "hull and dock met too hard"
    elif how != "completed":
        ending, text, why = Ending(how), reason or f"The run was {how}.", reason or how
    elif run.lost or not np.isfinite(run.eta_hat[-1]).all() or _is_lost(run):
        ending, text, why = Ending.ABORTED, "The state was no number any more.", "the simulation broke down"
    else:
        ending, text, why = _completed(run, errors, held_s, period_s, limits, dock)
    near = int(np.nanargmin(clearance.to_marker)) if np.isfinite(clearance.to_marker).any() else None
    return Outcome(
        ending=ending,
        reason=text,
        why=why,
        basis="true" if known else "believed",
        mode=MODE_LETTERS[int(run.mode[-1])],
        held_s=held_s,
        closest_m=None if near is None else float(clearance.to_marker[near]),
        closest_s=None if near is None else float(run.time[near]),
        true_errors=None if true is None else true.at(-1),
        believed_errors=believed.at(-1),
        tries=int(run.tried[-1]),
    )


def _is_lost(run: Columns) -> bool:
    """Whether the truth is told, but where the vehicle is in it is no number."""
    return bool(np.isfinite(run.target_true[-1]).all() and not np.isfinite(run.eta[-1]).all())


Said = tuple[Ending, str, str]  # ending, reason, why


def _completed(
    run: Columns, errors: Errors, held_s: float, period_s: float, limits: Limits, dock: Capture | None
) -> Said:
    where, stay = _where(run, errors), f"{held_s:.1f} s"
    if dock and dock.captured:
        return Ending.DOCKED, dock.sentence, "captured"
    if not dock and held_s >= limits.hold_s - 0.5 * period_s:
        return Ending.DOCKED, f"held in hover for {stay}, {where}.", "held within the limits"
    if int(run.stage[-1]) in WAVED_OFF_STAGES:
        why = _reason(int(run.reason[-1]))
        return Ending.WAVED_OFF, f"the approach was given up ({why}), {where}.", why
    if run.mode[-1] == HOVER:
        if dock:
            return Ending.HELD, f"in hover before the dock, {where}; not captured.", "not captured"
        text = f"in hover, {where}; within the limits for {stay} of {limits.hold_s:g} s."
        return Ending.HELD, text, _missed(errors.at(-1), limits)
    why = f"still in {LOOKS[int(run.mode[-1])].key}"
    return Ending.TIME_OVER, f"the time was over before hover, {where}.", why


def _missed(end: EndErrors, limits: Limits) -> str:
    """Which limits the last cycle is outside of."""
    far = {
        "position": end.position_m > limits.position_m,
        "heading": abs(end.heading_deg) > limits.heading_deg,
        "speed": end.speed_mps > limits.speed_mps,
    }
    said = " and ".join(name for name, missed in far.items() if missed)
    return f"{said} out of the limits" if said else "within the limits, not for long enough"


def _held_s(run: Columns, errors: Errors, period_s: float, limits: Limits) -> float:
    within = (run.mode == HOVER) & (errors.position <= limits.position_m)
    within &= (np.abs(errors.heading) <= limits.heading_deg) & (errors.speed <= limits.speed_mps)
    if not within[-1]:
        return 0.0
    # the stay begins after the last cycle that was outside, after the last gap or leap of the mission's time
    broken = np.flatnonzero(~within)
    steps = np.diff(run.time, prepend=-np.inf)
    gaps = np.flatnonzero(~run.follows | (steps <= 0.0) | (steps > max(GAP_S, 2.0 * period_s)))
    first = max(int(broken[-1]) + 1 if len(broken) else 0, int(gaps[-1]))
    return float(run.time[-1] - run.time[first]) + period_s


def _reason(number: int) -> str:
    """A WaveOffReason in words."""
    kinds = pb.WaveOffReason
    name = kinds.Name(cast("pb.WaveOffReason", number)) if number in kinds.values() else f"reason {number}"
    return name.removeprefix("WAVE_OFF_REASON_").replace("_", " ").lower()


def _collided(run: Columns, errors: Errors, clearance: Clearance) -> Said:
    row = int(np.argmax(clearance.inside))
    text = (
        f"the hull was in the dock, {clearance.to_marker[row]:.2f} m from its marker, "
        f"{run.time[row]:.1f} s after the start, at {errors.speed[row]:.2f} m/s."
    )
    return Ending.COLLIDED, text, f"in the dock in {LOOKS[int(run.mode[row])].key}"


def _grounded(run: Columns, vehicle: "Vehicle", known: bool, floor: Floor | None) -> Said | None:
    if floor is None:
        return None
    touched = floor_clearance(run.eta if known else run.eta_hat, vehicle, floor) < 0.0
    if not touched.any():
        return None
    row = int(np.argmax(touched))
    text = f"the hull was on the sea floor {run.time[row]:.1f} s after the start, at {run.depth[row]:.1f} m."
    return Ending.COLLIDED, text, f"on the sea floor in {LOOKS[int(run.mode[row])].key}"


def _where(run: Columns, errors: Errors) -> str:
    place = "truly" if is_known(run) else "as believed"
    side = "below" if errors.depth[-1] > 0.0 else "above"
    return (
        f"{place} {errors.position[-1]:.2f} m from the observation point "
        f"({abs(errors.depth[-1]):.2f} m of it {side}), {abs(errors.heading[-1]):.1f}° off "
        f"and at {errors.speed[-1]:.3f} m/s"
    )
