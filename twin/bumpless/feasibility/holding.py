"""Can station be held before the target in the mission's current, and on which headings could it?"""

from collections.abc import Iterator

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.station import LASTS_S, Station, station_keeping

DOCKED_S = 10.0  # in place that count as docked
_THIN_MPS = 0.005  # of current across: a margin that a gust takes away
_FIELD = "target.heading_deg"


def check_station(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Can station be held before the target in the mission's current?"""
    if parameters.guidance.speed_min_mps > 0.0:
        return  # it passes through the observation point, which is its docking
    current, target = mission.environment.current_ned_mps, mission.target
    station = station_keeping(vehicle, parameters, current, target)
    at = f"At {station.chosen_deg % 360.0:.0f}°"
    change, mends = what_would(station, mission, parameters.docking.enabled)
    if not station.holds:
        text = f"{at} {vehicle.id} can't hold station in this current: {station.reason}."
        yield Finding(HARD, "current_not_holdable", _FIELD, text, change, mends)
        return
    wanted = mission.end.hover_hold_s or DOCKED_S
    if station.chosen_s < max(wanted, 2.0 * DOCKED_S):
        severity = HARD if station.chosen_s < min(wanted, DOCKED_S) else SOFT
        text = f"{at} the current drifts {vehicle.id} out of place after about {station.chosen_s:.0f} s."
        yield Finding(severity, "drifts_off", _FIELD, text, change, mends)
    elif station.chosen_s < LASTS_S:
        text = (
            f"{at} station is held for about {station.chosen_s:.0f} s at a time in this current; "
            "then the vehicle waves off and tries again."
        )
        yield Finding(SOFT, "held_for_a_while", _FIELD, text, change, mends)
    elif _moves(mission) and station.chosen_margin_mps < _thin(mission):
        text = (
            f"{at} the margin is {station.chosen_margin_mps:.3f} m/s of current abeam, less than its changes."
        )
        yield Finding(SOFT, "thin_margin", _FIELD, text, change, mends)


def _moves(mission: Mission) -> bool:
    """Whether there is any current."""
    north, east, _ = mission.environment.current_ned_mps
    return north != 0.0 or east != 0.0 or mission.environment.current_variation is not None


def _thin(mission: Mission) -> float:
    variation = mission.environment.current_variation
    return max(_THIN_MPS, variation.std_mps if variation else 0.0)


def what_would(station: Station, mission: Mission, chooses: bool) -> tuple[str, tuple[Mend, ...]]:
    """The headings that hold, in words and as changes. chooses: the autopilot may turn the approach."""
    nearest, given = station.nearest_deg, mission.target.heading_deg
    if nearest is None:
        return "No heading holds station in it: dock in less current.", ()
    off = float(np.ceil(abs((nearest - given + 180.0) % 360.0 - 180.0)))
    mends = [Mend(_FIELD, nearest, f"Approach with {nearest:03.0f}°")]
    if chooses:
        mends.insert(0, Mend("target.approach", "into_current", "Approach into the current"))
        mends.append(Mend("target.heading_tolerance_deg", off, f"Let the approach turn by {off:.0f}°"))
    return f"Can be held: {spans(station.heading_deg, station.holds_s >= LASTS_S)}.", tuple(mends)


def spans(headings: np.ndarray, good: np.ndarray) -> str:
    """Arcs of headings, deg, in words: "070° to 110°, 300° to 010°"; good: one flag a heading, a circle."""
    if good.all():
        return "any heading"
    first = int(np.argmin(good))  # begin where it is not good, so that no arc is cut
    turned, flags = np.roll(headings, -first), np.roll(good, -first).astype(int)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags, [0]])))
    arcs = [(turned[a], turned[b - 1]) for a, b in zip(edges[::2], edges[1::2], strict=True)]
    return ", ".join(f"{a:03.0f}°" if a == b else f"{a:03.0f}° to {b:03.0f}°" for a, b in arcs)
