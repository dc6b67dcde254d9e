"""On which headings station can be held in a current, how surely, and why not.

A vehicle without sideways thrust holds station by pointing into the current: across stays what the flow over
the fins and a small crab angle can make good; the rest drifts. There are three zones. REFUSE: beyond the rule
that the docking automaton goes by in flight (`control.docking.heading`), so that what is refused before the
start is what is given up on the way. ACCEPT: within the narrower `sure_` limits of the parameters. WARN:
between the two; some plants and gusts can, others can't.
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
from bumpless.sim.approach import turn_used_deg

REFUSE, WARN, ACCEPT = 0, 1, 2
STEP_DEG = 1.0
_DRIFT_M = 0.15  # what docked means, in position
_DOCKED_S = 10.0
_CRAB_PUBLISHED = 0.35  # sine of the crab angle that the published guidance allows in H (`guidance.drift`)
_ASTERN_PUBLISHED = 0.03  # m/s along the hull for which it is meant at least
_SURE_SHARE = 0.8  # of what sideways thrust can do


@dataclass(frozen=True)
class Held:
    """Station keeping at one heading."""

    zone: int  # REFUSE, WARN or ACCEPT
    margin_mps: float  # of current across, to where it is refused; negative beyond
    reason: str = ""  # why not, or why not surely


@dataclass(frozen=True)
class Station:
    """Station keeping in one current, by heading. Arrays have one entry a degree, 0 to 359."""

    heading_deg: np.ndarray
    zone: np.ndarray  # REFUSE, WARN or ACCEPT
    chosen_deg: float  # the heading that the vehicle would take
    chosen: Held
    nearest_deg: float | None  # the accepted heading nearest to the target's; None: there is none


def station_keeping(
    vehicle: Vehicle, parameters: Parameters, current_ned_mps: tuple[float, float, float], target: Target
) -> Station:
    """Station keeping of a vehicle before a target in a steady current (NED, the way it flows, m/s)."""
    rule = _Rule(vehicle, parameters, current_ned_mps)
    headings = np.arange(0.0, 360.0, STEP_DEG)
    zone = np.array([rule.at(float(heading)).zone for heading in headings])
    chosen = rule.choose(target.heading_deg, turn_used_deg(target, vehicle))
    good = headings[zone == ACCEPT]
    off = np.abs((good - target.heading_deg + 180.0) % 360.0 - 180.0)
    nearest = float(good[np.argmin(off)]) if len(good) else None
    return Station(headings, zone, chosen, rule.at(chosen), nearest)


def surely_held(
    vehicle: Vehicle,
    parameters: Parameters,
    current_ned_mps: tuple[float, float, float],
    target: Target,
    off_mps: float,
) -> bool:
    """Whether station is surely kept though the current is so much stronger across the target's heading.

    Across from either side, in m/s; the vehicle turns into it as far as the target lets it.
    """
    heading = math.radians(target.heading_deg)
    north, east, down = current_ned_mps
    rule = _Rule(vehicle, parameters, current_ned_mps)
    for across in (-off_mps, off_mps):
        rule.take((north - across * math.sin(heading), east + across * math.cos(heading), down))
        if rule.at(rule.choose(target.heading_deg, turn_used_deg(target, vehicle))).zone != ACCEPT:
            return False
    return True


def _turned(given_deg: float, tolerance_deg: float, to_deg: float) -> float:
    """The heading within the tolerance of the given one that is nearest to another."""
    off = (to_deg - given_deg + 180.0) % 360.0 - 180.0
    return (given_deg + min(max(off, -tolerance_deg), tolerance_deg)) % 360.0


class _Rule:
    def __init__(self, vehicle: Vehicle, parameters: Parameters, current: tuple[float, float, float]) -> None:
        self.model: Any = build_model(vehicle)
        self.parameters = parameters
        self.docking = docking_settings(parameters.docking)
        self.sway = side_force(self.model)
        self.abeam = self._most_abeam() if self.sway > 0.0 else 0.0
        self.take(current)

    def take(self, current: tuple[float, float, float]) -> None:
        """Judge by this current from now on."""
        self.current, self.speed = current, math.hypot(current[0], current[1])

    def split(self, heading_deg: float) -> tuple[float, float]:
        """(along, across): the current from astern and to starboard of a heading, m/s."""
        c, s = math.cos(math.radians(heading_deg)), math.sin(math.radians(heading_deg))
        return self.current[0] * c + self.current[1] * s, -self.current[0] * s + self.current[1] * c

    def choose(self, given_deg: float, tolerance_deg: float) -> float:
        """The heading that the vehicle would take in flight: `control.docking.heading.choose_heading`."""
        if self.speed < 1e-9 or tolerance_deg <= 0.0:
            return given_deg
        into = math.degrees(math.atan2(-self.current[1], -self.current[0]))
        ahead = _turned(given_deg, tolerance_deg, into)
        if self.at(ahead).zone != REFUSE:
            return ahead
        astern = _turned(given_deg, tolerance_deg, into + 180.0)
        return astern if self.at(astern).zone != REFUSE else ahead

    def at(self, heading_deg: float) -> Held:
        """Can station be held at a heading?"""
        along, across = self.split(heading_deg)
        slowest = self.parameters.guidance.speed_min_mps
        if slowest > 0.0:
            return Held(REFUSE, -slowest, f"it steers by flow and can't fly slower than {slowest:g} m/s")
        if thrust_ahead(self.model, max(-along, 0.0)) < drag(self.model, 0, abs(along)):
            return Held(
                REFUSE, -abs(along), f"its thrust is no match for {abs(along):.2f} m/s along the hull"
            )
        if self.sway > 0.0:
            return self._pushing(across)
        return self._pointing(along, across) if self.parameters.docking.enabled else self._kept(along, across)

    def _most_abeam(self) -> float:
        """The current across, m/s, that sideways thrust is a match for."""
        speeds = np.linspace(0.0, 5.0, 501)
        return float(max(speed for speed in speeds if drag(self.model, 1, float(speed)) <= self.sway))

    def _pushing(self, across: float) -> Held:
        """With sideways thrust."""
        most, margin = self.abeam, self.abeam - abs(across)
        if abs(across) <= _SURE_SHARE * most:
            return Held(ACCEPT, margin)
        return Held(
            WARN if margin > 0.0 else REFUSE,
            margin,
            f"its sideways thrust holds no more than {most:.2f} m/s abeam",
        )

    def _pointing(self, along: float, across: float) -> Held:
        """Without, by the docking automaton's rule."""
        d = self.parameters.docking
        borne = float(plain(bearable)(self.docking, along))
        margin = borne - abs(across)
        if along > d.following_mps:
            return Held(REFUSE, margin, f"{along:.2f} m/s from astern takes the flow off its fins")
        abeam = f"it has no sideways thrust and bears {borne:.3f} m/s abeam, not {abs(across):.3f}"
        if margin < 0.0:
            return Held(REFUSE, margin, abeam)
        sure = d.sure_side_still_mps + d.sure_side_share * max(-along, 0.0)
        if along <= d.sure_following_mps and abs(across) <= sure:
            return Held(ACCEPT, margin)
        if along > d.sure_following_mps:
            return Held(WARN, margin, f"{along:.2f} m/s from astern takes flow off its fins")
        return Held(WARN, margin, f"it has no sideways thrust and surely bears {sure:.3f} m/s abeam only")

    def _kept(self, along: float, across: float) -> Held:
        """By the published guidance: the hull lies along the current as far as the camera allows."""
        margin = _CRAB_PUBLISHED * max(abs(along), _ASTERN_PUBLISHED) - abs(across)
        if margin >= 0.0:
            return Held(ACCEPT, margin)
        lasts = _DRIFT_M / -margin
        why = f"it has no sideways thrust and drifts out of place in about {lasts:.0f} s"
        return Held(WARN if lasts > 2.0 * _DOCKED_S else REFUSE, margin, why)
