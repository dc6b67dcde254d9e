"""Depth grids: read, kept, asked; a sea floor in a mission's own frame."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.chart import DepthGrid, NotAGrid, floor_of, from_bytes, to_bytes, with_floor
from bumpless.chart.beside import beside
from bumpless.chart.esri import read_esri
from bumpless.config.mission import missions_folder, parse_mission
from bumpless.config.mission.origin import Origin

DOCKING = (missions_folder() / "docking.yaml").read_text().split("\nenvironment:")[0] + "\n"
ASC = """ncols 3
nrows 2
xllcorner 100
yllcorner -20
cellsize 10
NODATA_value -9999
5 6 7
8 -9999 10
"""


def slope(geographic: bool = False) -> DepthGrid:
    """A floor that falls by 1 m from column to column and by 10 m from row to row."""
    rows, columns = np.meshgrid(np.arange(4.0), np.arange(5.0), indexing="ij")
    depth = (10.0 + 10.0 * rows + columns).astype(np.float32)
    if geographic:
        return DepthGrid(depth, 47.5, 8.5, 1e-4, 1e-4, True)
    return DepthGrid(depth, 30.0, 0.0, 10.0, 10.0, False)


def test_an_esri_grid_lies_as_its_head_says() -> None:
    """Protects: rows run from north to south and corners are no middles; half a cell is half a hazard."""
    grid = read_esri(ASC, geographic=False)
    assert (grid.west, grid.south, grid.north, grid.east) == (105.0, -15.0, -5.0, 125.0)
    assert grid.at(np.array([-5.0, -15.0]), np.array([105.0, 105.0])).tolist() == [5.0, 8.0]
    assert np.isnan(grid.at(np.array([-15.0]), np.array([115.0]))[0])


def test_heights_and_depths_are_told_apart_by_their_sign_or_by_whoever_says() -> None:
    """Protects: a chart of heights (negative below water) is no chart of negative depths."""
    heights = ASC.replace("5 6 7", "-5 -6 -7").replace("8 -9999 10", "-8 -9999 -10")
    assert np.nanmax(read_esri(heights, False).depth_m) == 10.0
    assert np.nanmin(read_esri(heights, False, down=True).depth_m) == -10.0


@pytest.mark.parametrize(
    "change",
    [("ncols 3", "ncols 4"), ("nrows 2", "nrows 1"), ("cellsize 10", "cellsize 0"), ("7\n", "x\n"),
     ("ncols 3", "ncols 1e9"), ("5 6 7\n8 -9999 10", ""), ("cellsize 10\n", ""), ("5 6 7", "5 6 1e9"),
     ("xllcorner 100", "xllcorner nan"), ("nrows 2\n", "")],
)  # fmt: skip
def test_a_broken_grid_is_refused(change: tuple[str, str]) -> None:
    """Protects: no grid that is half read decides about clearance."""
    with pytest.raises(NotAGrid):
        read_esri(ASC.replace(*change), geographic=False)


def test_between_cells_depth_is_linear_and_beyond_them_it_is_not_known() -> None:
    """Protects: clearance between two soundings is between theirs, and no number is made up beyond them."""
    grid = slope()
    found = grid.at(np.array([25.0, 30.0, 0.0, -0.1, 31.0]), np.array([5.0, 40.0, 40.0, 5.0, 5.0]))
    assert found[:3].tolist() == [15.5, 14.0, 44.0] and np.isnan(found[3:]).all()


def test_a_cell_that_is_not_known_spoils_only_what_leans_on_it() -> None:
    """Protects: a hole in the chart is a hole, at its edge and not beyond."""
    grid = slope()
    depth = grid.depth_m.copy()
    depth[1, 1] = np.nan
    holed = replace(grid, depth_m=depth)
    found = holed.at(np.array([20.0, 20.0, 30.0]), np.array([10.0, 20.0, 10.0]))
    assert np.isnan(found[0]) and found[1:].tolist() == [22.0, 11.0]


@given(
    st.integers(2, 6), st.integers(2, 6), st.booleans(),
    st.lists(st.floats(-100, 8000, width=32), min_size=36, max_size=36),
)  # fmt: skip
def test_a_kept_grid_is_the_same_grid(rows: int, columns: int, geographic: bool, depths: list[float]) -> None:
    """Protects: what foresight reads is what was stored, to the bit."""
    depth = np.array(depths[: rows * columns], np.float32).reshape(rows, columns)
    grid = DepthGrid(depth, 40.25, 8.125, 0.5, 0.25, geographic)
    back = from_bytes(to_bytes(grid))
    assert back.sha256 == grid.sha256 and back.depth_m.tolist() == depth.tolist()


@pytest.mark.parametrize("cut", [3, 20, 60, -5])
def test_a_kept_grid_that_is_cut_or_forged_is_refused(cut: int) -> None:
    """Protects: a torn file is no sea floor."""
    data = to_bytes(slope())
    for broken in (data[:cut], data.replace(b'"rows": 4', b'"rows": 9')):
        with pytest.raises(NotAGrid):
            from_bytes(broken)


def test_a_grid_on_the_earth_is_met_through_the_missions_origin() -> None:
    """Protects: the floor under a local place is the one under its latitude and longitude."""
    said = "origin: {latitude_deg: 47.4998, longitude_deg: 8.5002, heading_deg: 90}\n"
    text = DOCKING + said + "sea_floor: {clearance_m: 1, grid: lake, water_level_m: 0.5}\n"
    mission = with_floor(parse_mission(text), slope(geographic=True))
    floor = floor_of(mission)
    assert floor is not None
    assert floor.depth(0.0, 0.0)[0] == pytest.approx(10.0 + 20.0 + 2.0 + 0.5, abs=0.01)
    assert floor.depth(7.52, 0.0)[0] == pytest.approx(33.5, abs=0.01)  # the first axis leads east


def test_a_flat_floor_needs_no_grid() -> None:
    """Protects: a basin's depth is a sea floor too; without either there is none to keep clear of."""
    flat = DOCKING + "sea_floor: {clearance_m: 1}\n"
    assert floor_of(parse_mission(flat)) is None and floor_of(parse_mission(DOCKING)) is None
    floor = floor_of(parse_mission(flat + "environment: {water_depth_m: 6}\n"))
    assert floor is not None and floor.depth([0.0, 5.0], [1.0, 2.0]).tolist() == [6.0, 6.0]


def test_a_grid_beside_a_mission_is_found(tmp_path: Path) -> None:
    """Protects: the library knows a mission's floor without a server."""
    mission = parse_mission(DOCKING + "sea_floor: {clearance_m: 1, grid: basin}\n")
    assert beside(mission, tmp_path).depth_grid is None
    (tmp_path / "basin.asc").write_text(ASC)
    found = beside(mission, tmp_path).depth_grid
    assert found.depth_m.shape == (2, 3) and not found.geographic
    (tmp_path / "basin.asc").write_text("ncols")
    with pytest.raises(NotAGrid, match=r"basin\.asc"):
        beside(mission, tmp_path)


def test_places_on_the_earth_one_by_one_or_many_at_once_are_the_same() -> None:
    """Protects: one chart of the neighbourhood, whoever asks."""
    origin = Origin(latitude_deg=63.4, longitude_deg=10.4, heading_deg=30.0)
    north, east = np.array([0.0, 120.0, -800.0]), np.array([0.0, -55.0, 4000.0])
    latitudes, longitudes = origin.to_geographic(north, east)
    for n, e, lat, lon in zip(north, east, latitudes, longitudes, strict=True):
        assert origin.to_geographic(float(n), float(e)) == (lat, lon)
        assert origin.to_local(lat, lon) == pytest.approx((n, e), abs=1e-3)
