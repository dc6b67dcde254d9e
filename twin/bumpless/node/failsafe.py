"""Looks at each cycle for what the vehicle's file declares a reaction to."""

from collections.abc import Callable, Iterator
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from bumpless.config.vehicle.failsafe import WORDS, Failsafe, Reaction
from bumpless.contract.enums import RUNNING
from bumpless.feasibility.outline import inside
from bumpless.sim.condition import Condition

if TYPE_CHECKING:
    from bumpless.config.mission import Mission

Cause = tuple[str, str, Reaction]  # code, what happened in words, declared reaction


class Watch:
    """Tells of each cause once, and again only after it had gone."""

    def __init__(self, declared: Failsafe, period_s: float) -> None:
        self._declared, self._period_s = declared, period_s
        self._mission: Mission | None = None
        self._unseen_s = 0.0
        self._holds: set[str] = set()

    def begin(self, mission: "Mission") -> None:
        """A mission starts: nothing of an earlier one counts."""
        self._mission, self._unseen_s = mission, 0.0
        self._holds.clear()

    def look(self, row: np.void, phase: int, condition: Condition) -> list[Cause]:
        """What calls for a reaction since this cycle; `row` is its LOG row, `phase` one in which it moves."""
        self._unseen_s = self._unseen_s + self._period_s if phase == RUNNING and not row["detected"] else 0.0
        now = {cause[0]: cause for cause in self._causes(row, phase, condition)}
        new = [cause for code, cause in now.items() if code not in self._holds]
        self._holds = set(now)
        return new

    def _causes(self, row: np.void, phase: int, condition: Condition) -> Iterator[Cause]:
        d = self._declared
        if d.not_finite != "none" and not is_finite(row):
            yield "not_finite", "Its state or its commands are no numbers any more", d.not_finite
            return  # no other number can be told from it
        depth = float(row["depth"])
        if 0.0 < d.depth_most_m < depth:
            yield (
                "depth_exceeded",
                f"It is {depth:.1f} m deep, {d.depth_most_m:g} m at most",
                d.depth_exceeded,
            )
        yield from self._boundary(row)
        if condition.leak:
            yield "leak", "It reports a leak", d.leak
        if condition.battery is not None and condition.battery < d.battery_least:
            yield "battery_low", f"Its battery holds {condition.battery:.0%}", d.battery_low
        if row["faults"]:
            yield "actuator_fault", "It diagnoses a fault of an actuator", d.actuator_fault
        if phase == RUNNING and 0.0 < d.target_missing_s <= self._unseen_s:
            text = f"The target was not seen for {self._unseen_s:.0f} s"
            yield "target_missing", text, d.target_missing

    def _boundary(self, row: np.void) -> Iterator[Cause]:
        d, north, east = self._declared, float(row["eta_hat"][0]), float(row["eta_hat"][1])
        away = hypot(north, east)
        if 0.0 < d.distance_most_m < away:
            text = f"It is {away:.0f} m from the mission's origin, {d.distance_most_m:g} m at most"
            yield "boundary_exceeded", text, d.boundary_exceeded
        keep_in = self._mission.keep_in if self._mission is not None else None
        if keep_in is None or d.boundary_exceeded == "none":
            return
        if not inside((north, east), [(c.north_m, c.east_m) for c in keep_in.corners]):
            yield "keep_in_left", "It has left the mission's keep-in boundary", d.boundary_exceeded


def is_finite(row: np.void) -> bool:
    """Whether the estimated state, the measured depth and the commands are numbers."""
    return bool(
        np.isfinite(row["eta_hat"]).all()
        and np.isfinite(row["nu_hat"]).all()
        and np.isfinite(row["u"]).all()
        and np.isfinite(row["depth"])
    )


def told(what: str, reaction: Reaction) -> str:
    """One sentence for the operator."""
    return f"{what}: the vehicle {WORDS[reaction]}, as its file declares."


class ClockWatch:
    """Notices a jump of the UNIX clock against the one that only ever goes on."""

    def __init__(self, most_s: float, wall: Callable[[], int], steady: Callable[[], int]) -> None:
        self._most_s, self._wall, self._steady = most_s, wall, steady
        self._offset = wall() - steady()

    def jump_s(self) -> float | None:
        """By how much it has jumped since the last look, where that is more than declared, s."""
        before, self._offset = self._offset, self._wall() - self._steady()
        jump = (self._offset - before) * 1e-9
        return jump if 0.0 < self._most_s < abs(jump) else None
