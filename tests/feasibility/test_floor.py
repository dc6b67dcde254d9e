"""Legs keep clear of the sea floor, or a finding says where not and what would."""

from dataclasses import replace

import numpy as np
import pytest

from bumpless.chart import DepthGrid, Floor, with_floor
from bumpless.config.mission import Mission, missions_folder, parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.feasibility import check_mission
from bumpless.feasibility.floor import check_floor
from bumpless.metrics.floor import floor_clearance, keel_m

DOCKING = (missions_folder() / "docking.yaml").read_text()
TS100 = load_vehicle("ts100")


def _mission(said: str = "{clearance_m: 1.0, grid: basin}", sill_m: float = 2.6) -> Mission:
    """The docking mission over a basin of 8 m with a sill across its way at 12 m north."""
    depth = np.full((41, 21), 8.0, np.float32)
    depth[41 - 1 - 17 : 41 - 16 + 1, :] = sill_m  # rows of 10 to 14 m north
    grid = DepthGrid(depth, 75.0, -40.0, 4.0, 4.0, False)
    depth[:] = 8.0
    rows = [i for i in range(41) if 10.0 <= 75.0 - 4.0 * i <= 14.0]
    depth[rows] = sill_m
    return with_floor(parse_mission(f"{DOCKING}sea_floor: {said}\n"), grid)


def test_a_leg_too_near_the_floor_is_told_with_its_place_and_a_mend() -> None:
    """Protects: a mission over a sill does not start, and the change that is offered clears it."""
    mission = _mission()
    found = [f for f in check_floor(mission, TS100) if f.field == "legs[1].to_ned_m"]
    assert [f.code for f in found] == ["too_near_the_floor"] and found[0].blocks
    assert "2.6 m deep" in found[0].text and "asks for 1 m" in found[0].text
    assert found[0] in check_mission(mission, TS100)
    legs, start = list(mission.legs), mission.start
    for _ in range(3):
        for finding in check_floor(replace(mission, legs=tuple(legs), start=start), TS100):
            for mend in finding.mends:
                if mend.path.startswith("legs["):
                    assert isinstance(mend.value, tuple)
                    i = int(mend.path[5])
                    legs[i] = replace(legs[i], to_ned_m=mend.value)
                elif mend.path.startswith("start"):
                    start = replace(start, position_ned_m=mend.value)  # type: ignore[arg-type]
    assert list(check_floor(replace(mission, legs=tuple(legs), start=start), TS100)) == []


def test_a_leg_into_the_floor_says_so() -> None:
    """Protects: too near and into it are told apart."""
    found = list(check_floor(_mission(sill_m=1.5), TS100))
    assert any("into the sea floor" in f.text for f in found)


def test_enough_water_is_no_finding() -> None:
    """Protects: no warning that means nothing."""
    assert list(check_floor(_mission(sill_m=6.0), TS100)) == []


def test_a_mission_without_a_floor_is_left_alone() -> None:
    """Protects: missions that say nothing of a floor are checked as ever."""
    assert list(check_floor(parse_mission(DOCKING), TS100)) == []


def test_a_target_below_the_floor_is_a_finding_of_the_target() -> None:
    """Protects: the dock's place is looked at, not only the way to it."""
    mission = _mission(sill_m=8.0)
    grid = replace(mission.depth_grid, depth_m=np.full((41, 21), 2.4, np.float32))
    found = [f for f in check_floor(with_floor(mission, grid), TS100) if f.field == "target.position_ned_m"]
    assert found and found[0].mends[0].path == "target.position_ned_m"


@pytest.mark.parametrize(
    ("said", "grid", "field"),
    [("{clearance_m: 1, grid: basin}", False, "sea_floor.grid"), ("{clearance_m: 1}", False, "sea_floor")],
)  # fmt: skip
def test_a_floor_that_is_not_known_is_no_floor_that_is_clear(said: str, grid: bool, field: str) -> None:
    """Protects: asking for clearance above nothing is told, not passed."""
    mission = with_floor(_mission(said), None)
    found = list(check_floor(mission, TS100))
    assert [(f.code, f.field, f.blocks) for f in found] == [("sea_floor_unknown", field, True)]


def test_a_grid_on_the_earth_needs_an_origin() -> None:
    """Protects: a chart that can't be placed decides nothing."""
    mission = _mission()
    mission = with_floor(mission, DepthGrid(mission.depth_grid.depth_m, 47.5, 8.5, 1e-4, 1e-4, True))
    assert [f.field for f in check_floor(mission, TS100)] == ["origin"]


def test_legs_beyond_the_chart_are_told() -> None:
    """Protects: an unknown floor is not a deep one."""
    mission = _mission(sill_m=8.0)
    small = DepthGrid(mission.depth_grid.depth_m[20:24], -2.0 + 12.0, -40.0, 4.0, 4.0, False)
    found = list(check_floor(with_floor(mission, small), TS100))
    assert [(f.code, f.severity) for f in found] == [("sea_floor_uncharted", "soft")]


def test_clearance_counts_from_the_hulls_lowest_point() -> None:
    """Protects: a vehicle that pitches down is nearer to the floor than its middle tells."""
    level = np.zeros((1, 6))
    level[0, 2] = 4.0
    floor = Floor(flat_m=10.0)
    assert floor_clearance(level, TS100, floor)[0] == pytest.approx(6.0 - keel_m(TS100))
    down = level.copy()
    down[0, 4] = -0.3
    assert floor_clearance(down, TS100, floor)[0] < floor_clearance(level, TS100, floor)[0] - 0.1
