"""Do the legs keep clear of the sea floor?"""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from bumpless.chart import floor_of
from bumpless.config.mission import Mission
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.metrics.floor import Below, below


def check_floor(mission: Mission, vehicle: Vehicle) -> Iterator[Finding]:
    """Every leg, the start and the target against the floor that the mission names."""
    said = mission.sea_floor
    if said is None:
        return
    floor = floor_of(mission)
    if floor is None:
        yield _unknown(mission)
        return
    blind = False
    for i, leg in enumerate(pairwise(mission.path_ned_m)):
        found = below(np.array(leg, np.float64), vehicle, floor)
        blind = blind or bool(np.isnan(found.floor).any())
        if np.isfinite(found.clearance).any():
            yield from _leg(mission, i, found)
    target = np.array([mission.target.observation_point_ned_m] * 2, np.float64)
    found = below(target, vehicle, floor)
    if found.clearance[0] < said.clearance_m:
        yield _target(mission, float(found.clearance[0]))
    if blind:
        text = "The depth grid does not reach along all of the legs: beyond it nothing is known of the floor."
        yield Finding(SOFT, "sea_floor_uncharted", "sea_floor.grid", text, "Look at the legs that leave it.")


def _leg(mission: Mission, i: int, found: Below) -> Iterator[Finding]:
    assert mission.sea_floor is not None
    wanted, least = mission.sea_floor.clearance_m, float(np.nanmin(found.clearance))
    if least >= wanted:
        return
    at = int(np.nanargmin(found.clearance))
    north, east = found.places[at, :2]
    field = f"legs[{i}].to_ned_m"
    place = f"at [{north:.1f}, {east:.1f}], where the floor is {found.floor[at]:.1f} m deep"
    if least < 0.0:
        text = f"It leads {-least:.1f} m into the sea floor {place}."
    else:
        text = f"It keeps {least:.1f} m above the sea floor {place}; the mission asks for {wanted:g} m."
    yield Finding(HARD, "too_near_the_floor", field, text, *_mended(mission, i, wanted - least))


def _mended(mission: Mission, i: int, more: float) -> tuple[str, tuple[Mend, ...]]:
    """What to change so that a leg is `more` m shallower at both of its ends, where that is the leg's own."""
    end = mission.legs[i].to_ned_m
    shallower = math.floor(10.0 * (end[2] - more)) / 10.0
    begin = mission.path_ned_m[i][2]
    if shallower < 0.0:
        return "Lead it where the water is deeper, or ask for less clearance.", ()
    words = f"End leg {i + 1} at {shallower:g} m"
    mends = [Mend(f"legs[{i}].to_ned_m", (end[0], end[1], shallower), words)]
    if begin > shallower + 1e-9:
        where = f"legs[{i - 1}].to_ned_m" if i else "start.position_ned_m"
        before = mission.path_ned_m[i]
        mends.append(Mend(where, (before[0], before[1], shallower), f"Begin it at {shallower:g} m"))
    return f"Fly it at {shallower:g} m or less.", tuple(mends)


def _target(mission: Mission, clearance: float) -> Finding:
    assert mission.sea_floor is not None
    wanted = mission.sea_floor.clearance_m
    north, east, depth = mission.target.position_ned_m
    where, asks = "The observation point lies", f"the mission asks for {wanted:g} m"
    text = f"{where} {clearance:.1f} m above the sea floor; {asks}."
    if clearance < 0.0:
        text = f"{where} {-clearance:.1f} m below the sea floor."
    shallower = math.floor(10.0 * (depth - wanted + clearance)) / 10.0
    field = "target.position_ned_m"
    if shallower < 0.0:
        return Finding(HARD, "too_near_the_floor", field, text, "Ask for less clearance.")
    words = f"Target at {shallower:g} m"
    return Finding(
        HARD, "too_near_the_floor", field, text, f"{words}.", (Mend(field, (north, east, shallower), words),)
    )


def _unknown(mission: Mission) -> Finding:
    said = mission.sea_floor
    assert said is not None
    if not said.grid:
        text = "It asks for clearance above a floor that it does not tell: environment.water_depth_m is 0."
        return Finding(
            HARD, "sea_floor_unknown", "sea_floor", text, "Set the water's depth, or name a depth grid."
        )
    if mission.depth_grid is None:
        text = f"There is no depth grid {said.grid} here."
        mend = Mend("sea_floor", None, "Fly without a sea floor")
        what = "Store it among the charts, or beside the mission's file."
        return Finding(HARD, "sea_floor_unknown", "sea_floor.grid", text, what, (mend,))
    text = f"The depth grid {said.grid} lies on the earth, and the mission has no origin."
    return Finding(HARD, "sea_floor_unknown", "origin", text, "Say where [0, 0, 0] lies.")
