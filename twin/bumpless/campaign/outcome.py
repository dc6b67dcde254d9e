"""How a flight ended, and the row at which that was decided.

The words and docked's limits are those of `bumpless.metrics.outcome`, which judges a whole run; here a flight
that is decided need not be flown to its end.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from bumpless.campaign.declaration import Docked
from bumpless.campaign.geometry import Errors, nose_clearance, nose_x, true_errors
from bumpless.config.mission import Mission
from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import ABORTED, HOVER
from bumpless.contract.modes import LOOKS
from bumpless.metrics.outcome import Ending


@dataclass(frozen=True)
class Decided:
    """An outcome, why, and how many rows of the flight lead to it."""

    outcome: Ending
    reason: str
    rows: int


class Judge:
    """Decides a flight from its log, however often it looks while the flight grows."""

    def __init__(self, mission: Mission, vehicle: Vehicle, rule: Docked) -> None:
        self.mission, self.vehicle, self.rule = mission, vehicle, rule
        self.hold = max(1, round(rule.hold_s / vehicle.control_period_s))
        # farther away than this nothing but a breakdown can be decided: the nose cannot be at the marker
        self.reach = max(mission.target.standoff_m + nose_x(vehicle) + rule.touch_m, rule.range_m)
        self._seen = 0  # rows
        self._inside = 0  # of these, how many in a row up to now are within the tolerances

    def look(self, log: npt.NDArray) -> Decided | None:
        """Judge the rows that were not there at the last look; None while nothing is decided."""
        new, before = log[self._seen :], self._seen
        self._seen = len(log)
        if not len(new):
            return None
        errors = true_errors(new, self.mission)
        broken = ~np.isfinite(new["eta"].sum(axis=1))
        if errors.range.min() > self.reach:
            touching = held = np.zeros(len(new), bool)
            self._inside = 0
        else:
            touching = nose_clearance(new, self.mission, self.vehicle) < self.rule.touch_m
            held = self._held(self._within(new, errors))
        ends = [
            (_first(broken), Ending.ABORTED, "the simulation broke down"),
            (_first(touching), Ending.COLLIDED, f"nose within {self.rule.touch_m:g} m of the marker"),
            (_first(new["phase"] == ABORTED), Ending.ABORTED, "mission aborted"),
        ]
        if self.mission.target.dock is None:
            ends.append((_first(held), Ending.DOCKED, f"within tolerances for {self.rule.hold_s:g} s"))
        else:
            hard = new["contact_force"] > new["contact_most"]
            ends.append((_first(hard), Ending.COLLIDED, "hull and dock met harder than they bear"))
            ends.append((_first(new["captured"] == 1), Ending.DOCKED, "captured"))
        row, name, why = min(ends, key=lambda end: end[0])
        return Decided(name, why, before + row + 1) if row < len(new) else None

    def over(self, log: npt.NDArray) -> Decided:
        """What a flight is that came to its end undecided."""
        last = log[-1:]
        if last["mode"][0] != HOVER:
            return Decided(Ending.TIME_OVER, f"still in {LOOKS[int(last['mode'][0])].key}", len(log))
        if self._inside:
            return Decided(Ending.HELD, "within tolerances, but not yet for long enough", len(log))
        errors, rule = true_errors(last, self.mission), self.rule
        far = (
            ("position", errors.range[0] > rule.range_m),
            ("heading", abs(errors.heading[0]) > np.radians(rule.heading_deg)),
            ("speed", errors.speed[0] > rule.speed_mps),
        )
        said = " and ".join(name for name, missed in far if missed)
        return Decided(Ending.HELD, f"in hover, {said} out of tolerance", len(log))

    def _within(self, log: npt.NDArray, errors: Errors) -> npt.NDArray[np.bool_]:
        rule = self.rule
        return (
            (log["mode"] == HOVER)
            & (errors.range <= rule.range_m)
            & (np.abs(errors.heading) <= np.radians(rule.heading_deg))
            & (errors.speed <= rule.speed_mps)
        )

    def _held(self, within: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
        """Where the vehicle has been within the tolerances for the whole hold time."""
        rows = np.arange(len(within))
        last_out = np.maximum.accumulate(np.where(within, -1 - self._inside, rows))
        run = rows - last_out
        self._inside = int(run[-1]) if within[-1] else 0
        return within & (run >= self.hold)


def _first(flags: npt.NDArray[np.bool_]) -> int:
    """Index of the first True; the length when there is none."""
    return int(np.argmax(flags)) if flags.any() else len(flags)
