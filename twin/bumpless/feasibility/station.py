"""Which headings can hold station in a current, for how long, and why not.

A vehicle without sideways thrust holds station by pointing into the current: across stays what the flow over
the fins and a small crab angle can make good; the rest drifts. The rules are those of the docking automaton
(`control.docking.heading`), so that what is refused before the start is what is waved off in flight.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from bumpless.config.mission.model import Target
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.docking.heading import bearable
from bumpless.feasibility.reach import docking_settings, drag, plain, side_force, thrust_ahead
from bumpless.physics.model import build_model

STEP_DEG = 1.0
IN_PLACE_M = 0.15  # what docked means
LASTS_S = 1e6  # for good
_CRAB_PUBLISHED = 0.35  # sine of the crab angle that the published guidance allows in H (`guidance.drift`)
_ASTERN_PUBLISHED = 0.03  # m/s along the hull for which it is meant at least


@dataclass(frozen=True)
class Station:
    """Station keeping in one current, by heading. Arrays have one entry a degree, 0 to 359."""

    heading_deg: np.ndarray
    holds_s: np.ndarray  # how long: 0 not at all, LASTS_S for good
    margin_mps: np.ndarray  # of current across that could be borne besides; negative where it can't be held
    chosen_deg: float  # the heading that the vehicle would take
    chosen_s: float  # how long it holds there
    chosen_margin_mps: float
    reason: str  # why it can't be held at the chosen heading; "" where it can
    nearest_deg: float | None  # the heading nearest to the target's that holds for good; None: there is none

    @property
    def holds(self) -> bool:
        """Whether station can be held at the chosen heading, at least to dock."""
        return self.chosen_s > 0.0


def station_keeping(
    vehicle: Vehicle, parameters: Parameters, current_ned_mps: tuple[float, float, float], target: Target
) -> Station:
    """Station keeping of a vehicle before a target in a steady current (NED, the way it flows, m/s)."""
    rule = _Rule(vehicle, parameters, current_ned_mps)
    headings = np.arange(0.0, 360.0, STEP_DEG)
    each = [rule.at(float(heading)) for heading in headings]
    holds, margins = np.array([one[0] for one in each]), np.array([one[1] for one in each])
    chosen = rule.choose(target.heading_deg, target.turn_deg)
    chosen_s, margin, reason = rule.at(chosen)
    good = headings[holds >= LASTS_S]
    off = np.abs((good - target.heading_deg + 180.0) % 360.0 - 180.0)
    nearest = float(good[np.argmin(off)]) if len(good) else None
    return Station(headings, holds, margins, chosen, chosen_s, margin, reason, nearest)


class _Rule:
    def __init__(self, vehicle: Vehicle, parameters: Parameters, current: tuple[float, float, float]) -> None:
        self.model: Any = build_model(vehicle)
        self.current, self.parameters = current, parameters
        self.docking = docking_settings(parameters.docking)
        self.sway = side_force(self.model)
        self.speed = math.hypot(current[0], current[1])

    def split(self, heading_deg: float) -> tuple[float, float]:
        """(along, across): the current from astern and to starboard of a heading, m/s."""
        c, s = math.cos(math.radians(heading_deg)), math.sin(math.radians(heading_deg))
        return self.current[0] * c + self.current[1] * s, -self.current[0] * s + self.current[1] * c

    def choose(self, given_deg: float, tolerance_deg: float) -> float:
        """The heading within the tolerance that is nearest to straight into the current."""
        if self.speed < 1e-9 or tolerance_deg <= 0.0:
            return given_deg
        into = math.degrees(math.atan2(-self.current[1], -self.current[0]))
        off = (into - given_deg + 180.0) % 360.0 - 180.0
        return (given_deg + min(max(off, -tolerance_deg), tolerance_deg)) % 360.0

    def at(self, heading_deg: float) -> tuple[float, float, str]:
        """(how long station is held, margin m/s, why not) at a heading."""
        along, across = self.split(heading_deg)
        slowest = self.parameters.guidance.speed_min_mps
        if slowest > 0.0:
            return 0.0, -slowest, f"it steers by flow and can't fly slower than {slowest:g} m/s"
        if thrust_ahead(self.model, max(-along, 0.0)) < drag(self.model, 0, abs(along)):
            return 0.0, -abs(along), f"its thrust is no match for {abs(along):.2f} m/s along the hull"
        if self.sway > 0.0:
            return self._pushing(across)
        if self.parameters.docking.enabled:
            return self._pointing(along, across)
        return self._published(along, across)

    def _pushing(self, across: float) -> tuple[float, float, str]:
        """With sideways thrust."""
        speeds = np.linspace(0.0, 5.0, 501)
        most = float(max(speed for speed in speeds if drag(self.model, 1, float(speed)) <= self.sway))
        margin = most - abs(across)
        why = "" if margin > 0.0 else f"its sideways thrust holds no more than {most:.2f} m/s abeam"
        return (LASTS_S if margin > 0.0 else 0.0), margin, why

    def _pointing(self, along: float, across: float) -> tuple[float, float, str]:
        """Without, by the docking automaton's rule."""
        borne = float(plain(bearable)(self.docking, along))
        if along > self.docking.following:
            why = f"{along:.2f} m/s from astern takes the flow off its fins"
            return 0.0, borne - abs(across), why
        margin = borne - abs(across)
        if margin < 0.0:
            why = f"it can bear {borne:.3f} m/s abeam, not {abs(across):.3f}, for want of sideways thrust"
            return 0.0, margin, why
        d = self.parameters.docking
        left = max(abs(across) - d.crab_near * max(-along, 0.0), 0.0)
        if left < 1e-4:
            return LASTS_S, margin, ""
        aim = min(left * d.aim_time_s, d.aim_most_m)
        return (IN_PLACE_M + aim) / left, margin, ""

    def _published(self, along: float, across: float) -> tuple[float, float, str]:
        """By the published guidance: the hull lies along the current as far as the camera allows."""
        borne = _CRAB_PUBLISHED * max(abs(along), _ASTERN_PUBLISHED)
        margin = borne - abs(across)
        if margin >= 0.0:
            return LASTS_S, margin, ""
        return IN_PLACE_M / (-margin), margin, ""
