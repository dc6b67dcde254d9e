"""How a run met a dock to enter: captured or not, how hard, how long it took."""

from dataclasses import dataclass

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics.columns import Columns

_NAN = float("nan")


@dataclass(frozen=True)
class Capture:
    """Of a run with a dock to enter; NaN for what did not happen or is not known."""

    captured: bool
    time_s: float  # mission time of the capture
    seat_time_s: float  # from the nose in the entry to the capture
    force_max_n: float  # largest sum of normal forces
    force_most_n: float  # what dock and hull bear
    force_max_s: float  # mission time of the largest
    entry_offset_m: float  # of the nose from the axis when it last came in

    @property
    def overloaded(self) -> bool:
        """Whether hull and dock met harder than they bear."""
        return self.force_max_n > self.force_most_n

    @property
    def sentence(self) -> str:
        """For an operator, after "Docked: "."""
        seat = "" if np.isnan(self.seat_time_s) else f", {self.seat_time_s:.1f} s after the entry"
        return f"captured {self.time_s:.1f} s after the start{seat}; largest force {self.force_max_n:.0f} N."

    @property
    def harm(self) -> str:
        """For an operator, after "Collided: "."""
        force = f"{self.force_max_n:.0f} N, more than the {self.force_most_n:.0f} N they bear"
        return f"hull and dock met with {force}, {self.force_max_s:.1f} s after the start."

    def message(self) -> pb.CaptureMetrics:
        """As the contract's."""
        names = ("captured", "time_s", "seat_time_s", "force_max_n", "force_most_n", "entry_offset_m")
        return pb.CaptureMetrics(**{name: getattr(self, name) for name in names})


def capture_of(run: Columns) -> Capture | None:
    """None where there is no dock to enter; its place is known to the truth alone, its latch to all."""
    dock = run.dock
    if not len(run) or dock is None:
        return None
    force, most, shut = dock.contact_force, dock.contact_most, np.flatnonzero(dock.captured)
    first = int(shut[0]) if len(shut) else len(run)
    inside = dock.nose_depth[:first] >= 0.0
    came_in = np.flatnonzero(inside[1:] & ~inside[:-1]) + 1
    entered = int(came_in[-1]) if len(came_in) else None
    hardest = int(np.nanargmax(force)) if np.isfinite(force).any() else 0
    time_s = float(run.time[first]) if len(shut) else _NAN
    return Capture(
        captured=bool(len(shut)),
        time_s=time_s,
        seat_time_s=_NAN if entered is None else time_s - float(run.time[entered]),
        force_max_n=float(force[hardest]),
        force_most_n=float(most[hardest]),
        force_max_s=float(run.time[hardest]),
        entry_offset_m=_NAN if entered is None else float(dock.nose_offset[entered]),
    )
