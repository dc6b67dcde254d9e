"""A survey of hundreds of long legs is checked for what it is, at a cost that grows with its legs only."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.capacity import MAX_WAYPOINTS
from bumpless.config.mission import Mission, missions_folder, parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.feasibility import check_mission
from bumpless.feasibility.dock import nearest
from bumpless.feasibility.outline import near_part
from bumpless.feasibility.sight import seen_from

TS100 = load_vehicle("ts100")
HEAD = (missions_folder() / "docking.yaml").read_text().split("legs:")[0]


def survey(count: int, length_m: float = 40.0, depth_m: float = 2.0) -> Mission:
    """A lawnmower of so many legs, the target after its last."""
    places, north, east = [], 0.0, 0.0
    for i in range(count):
        north, east = (length_m - north, east) if i % 2 == 0 else (north, east + 5.0)
        places.append((north, east))
    legs = "".join(f"  - {{to_ned_m: [{n:g}, {e:g}, {depth_m:g}], speed_mps: 0.7}}\n" for n, e in places)
    (a, b), (c, d) = places[-2:]
    heading = math.degrees(math.atan2(d - b, c - a))
    n, e = c + 1.5 * math.cos(math.radians(heading)), d + 1.5 * math.sin(math.radians(heading))
    target = f"target: {{position_ned_m: [{n:.3f}, {e:.3f}, {depth_m:g}], heading_deg: {heading:.2f}, "
    return parse_mission(f"{HEAD}legs:\n{legs}{target}standoff_m: 1.5}}\n".replace("_s: 90", "_s: 90000"))


def test_a_plan_of_500_legs_is_read_and_checked_like_a_short_one() -> None:
    """Protects: a survey gets the findings that three legs get, and none for being long."""
    many, few = (check_mission(survey(n), TS100) for n in (501, 5))
    assert [f.code for f in many] == [f.code for f in few]
    assert len(survey(501).legs) == 501 < MAX_WAYPOINTS


def test_long_legs_are_looked_at_where_the_target_is_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: kilometres of survey cost no more than metres: a check answers while somebody draws."""
    looked = []
    plain_linspace, plain_arange = np.linspace, np.arange
    monkeypatch.setattr(np, "linspace", lambda *a, **k: looked.append(x := plain_linspace(*a, **k)) or x)
    monkeypatch.setattr(np, "arange", lambda *a, **k: looked.append(x := plain_arange(*a, **k)) or x)
    check_mission(survey(101, 50_000.0), TS100)
    assert sum(map(len, looked)) < 50_000  # sampled each quarter metre it would be twenty millions


PLACES = st.tuples(*[st.floats(-30.0, 30.0)] * 3)


@given(PLACES, PLACES, PLACES, st.floats(0.1, 20.0))
def test_the_near_part_of_a_way_is_all_that_is_near(
    start: tuple[float, float, float],
    end: tuple[float, float, float],
    middle: tuple[float, float, float],
    radius: float,
) -> None:
    """Protects: nothing that is near is left out of what is looked at."""
    part = near_part(start, end, middle, radius)
    for share in np.linspace(0.0, 1.0, 101):
        place = [a + share * (b - a) for a, b in zip(start, end, strict=True)]
        if math.dist(place, middle) < radius - 1e-6:
            assert part is not None and part[0] - 1e-6 <= share <= part[1] + 1e-6


@given(st.floats(-20, 40), st.floats(-15, 15), st.floats(-20, 40), st.floats(0.5, 12.0), st.floats(0.2, 3.0))
def test_the_nearest_place_of_a_leg_is_that_of_a_fine_search(
    a: float, b: float, c: float, depth: float, within: float
) -> None:
    """Protects: a leg that passes the dock is told with its true distance, at the dock's depth only."""
    mission = survey(3)
    start, (n, e, d) = (a, b, 2.0), mission.target.position_ned_m
    object.__setattr__(mission, "path_ned_m", (start, (c, e + 0.5, depth)))
    shares = np.linspace(0.0, 1.0, 4001)[:, None]
    off = np.array(start) + shares * (np.array((c, e + 0.5, depth)) - start) - (n, e, d)
    near = np.abs(off[:, 2]) <= within
    found = nearest(mission, 0, within)
    if near.any():
        assert found == pytest.approx(np.hypot(off[near, 0], off[near, 1]).min(), abs=0.02)


def test_a_leg_far_away_sees_nothing() -> None:
    """Protects: what is not looked at is what the camera can't see."""
    mission = survey(5, 400.0)
    assert seen_from(mission, TS100, 0) is None
    assert seen_from(mission, TS100, 4) is not None
