"""The dock as a body: legs that lead through it, and room for the nose before its face."""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.mission.model import Target
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.docking.gates import NOSE_GUARD
from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.outline import near_part
from bumpless.sim.approach import turn_limit_deg

_STEP_M = 0.1
ROOM_M = 0.3  # least way from the nose in place to the dock's face: an overshoot is stopped within it
_JOIN_M = 2.0  # before the line begins, in which the vehicle turns on to it
HULL_M = 0.5  # half width of hull and struts, with a little


def check_dock(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """Legs against the dock, and the place before it."""
    target = mission.target
    if parameters.docking.enabled:
        yield from _near_legs(mission, parameters)
        yield from _place(target, vehicle)
        yield from _way_round(target, parameters)
    else:
        yield from _through(mission)


def inside(target: Target, place: tuple[float, float, float], margin: float) -> bool:
    """Whether a place (NED, m) is in the dock's box, or within a margin (m) of it."""
    heading, half = math.radians(target.heading_deg), 0.5 * target.dock_width_m + margin
    north, east, down = (a - b for a, b in zip(place, target.position_ned_m, strict=True))
    along = north * math.cos(heading) + east * math.sin(heading)
    across = -north * math.sin(heading) + east * math.cos(heading)
    return -margin < along < target.dock_length_m + margin and max(abs(across), abs(down)) < half


def nearest(mission: Mission, leg: int, depth_m: float) -> float:
    """Least horizontal way from a leg to the target, m, where it is within depth_m of its depth; else inf."""
    start, end = (np.array(x) for x in mission.path_ned_m[leg : leg + 2])
    off, way = start - np.array(mission.target.position_ned_m), end - start
    first, last = 0.0, 1.0
    if abs(way[2]) > 1e-9:  # the part of the leg between the two depths
        at_depths = sorted((depth - off[2]) / way[2] for depth in (-depth_m, depth_m))
        first, last = max(first, at_depths[0]), min(last, at_depths[1])
    elif abs(off[2]) > depth_m:
        return math.inf
    if first > last:
        return math.inf
    length2 = float(way[0] ** 2 + way[1] ** 2)
    share = -float(off[0] * way[0] + off[1] * way[1]) / length2 if length2 > 0.0 else first
    north, east, _ = off + min(max(share, first), last) * way
    return math.hypot(north, east)


def _near_legs(mission: Mission, parameters: Parameters) -> Iterator[Finding]:
    """Legs before the last that the docking automaton flies round the dock."""
    target, margin = mission.target, parameters.docking.keep_out_m
    keep, depth = margin + target.dock_radius_m, margin + 0.5 * target.dock_width_m
    for i in range(len(mission.legs) - 1):
        near = nearest(mission, i, depth)
        if near >= keep:
            continue
        text = f"It passes {near:.1f} m from the target; the vehicle flies round the dock, {keep:.1f} m off."
        field = f"legs[{i}].to_ned_m"
        place = _moved_out(mission.legs[i].to_ned_m, target, keep + 0.1)
        mends = (Mend(field, place, f"End the leg {keep:.0f} m off the dock"),) if place else ()
        what = f"End it {keep:.0f} m off." if place else "Lead it round the dock."
        yield Finding(SOFT, "leg_near_dock", field, text, what, mends)


def _moved_out(
    place: tuple[float, float, float], target: Target, keep: float
) -> tuple[float, float, float] | None:
    """The place moved straight away from the target to `keep` m; None where it is as far already."""
    north, east = place[0] - target.position_ned_m[0], place[1] - target.position_ned_m[1]
    far = math.hypot(north, east)
    if far >= keep or far < 1e-6:
        return None
    return (
        round(target.position_ned_m[0] + keep / far * north, 2),
        round(target.position_ned_m[1] + keep / far * east, 2),
        place[2],
    )


def _place(target: Target, vehicle: Vehicle) -> Iterator[Finding]:
    """Is there room for the nose where the vehicle is to hover, on every heading it may take?"""
    nose = vehicle.ends_m[0]
    before, limit = target.standoff_m - nose, turn_limit_deg(target, vehicle)
    if before < ROOM_M:
        least = math.ceil(10.0 * (nose + ROOM_M)) / 10.0
        text = (
            f"{vehicle.id}'s nose would stand {before:.2f} m before the dock's face; it needs {ROOM_M:g} m."
        )
        mend = Mend("target.standoff_m", least, f"Stand off {least:g} m")
        kind = HARD if before < NOSE_GUARD else SOFT
        yield Finding(kind, "standoff_too_short", "target.standoff_m", text, f"Make it {least:g} m.", (mend,))
    elif not target.turns and target.turn_deg > limit:
        text = (
            f"The approach turns by {limit:.0f}° at most: farther off the dock's axis the nose would come "
            "too near to its face."
        )
        field, most = "target.heading_tolerance_deg", float(math.floor(limit))
        mend = Mend(field, most, f"Let the approach turn by {most:g}°")
        yield Finding(SOFT, "tolerance_too_wide", field, text, f"{most:g}° says the same.", (mend,))


def _way_round(target: Target, parameters: Parameters) -> Iterator[Finding]:
    """Does the approach line begin outside of what is kept clear of the dock?"""
    docking = parameters.docking
    keep, begins = docking.keep_out_m + target.dock_radius_m, docking.entry_distance_m + target.standoff_m
    if begins >= keep + _JOIN_M:
        return
    text = (
        f"The approach line begins {begins:.1f} m before a dock that is passed {keep:.1f} m off: "
        "who doesn't come straight on to it, or waves off, never gets round."
    )
    field = "parameters.docking.entry_distance_m"
    longer = float(math.ceil(keep - target.standoff_m + _JOIN_M))
    mend = Mend(field, longer, f"Begin the line {longer:g} m off")
    yield Finding(SOFT, "line_in_keep_out", field, text, f"Set it to {longer:g} m.", (mend,))


def _through(mission: Mission) -> Iterator[Finding]:
    """Legs through the dock, where nothing leads the vehicle round it."""
    target = mission.target
    half = 0.5 * target.dock_width_m + HULL_M
    reach = math.hypot(target.dock_length_m + HULL_M, half, half)  # no farther is a place in it
    for i, (start, end) in enumerate(pairwise(mission.path_ned_m)):
        part = near_part(start, end, mission.target.position_ned_m, reach)
        if part is None:
            continue
        a, b = np.array(start), np.array(end)
        steps = np.linspace(*part, max(2, math.ceil((part[1] - part[0]) * math.dist(start, end) / _STEP_M)))
        if any(inside(mission.target, tuple(a + s * (b - a)), HULL_M) for s in steps):
            text = "It leads through the dock."
            yield Finding(HARD, "leg_through_dock", f"legs[{i}].to_ned_m", text, "Lead it round.")
