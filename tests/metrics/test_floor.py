"""A flight that meets the sea floor has collided, in memory and in its log; others are judged as ever."""

from dataclasses import replace
from pathlib import Path

import numpy as np

import bumpless
from bumpless.chart import DepthGrid, to_bytes, with_floor
from bumpless.config.mission import missions_folder, parse_mission
from bumpless.runs.summary import summarise
from tests.runs.flights import on_bus, record

TEXT = (missions_folder() / "docking.yaml").read_text().replace("duration_s: 90", "duration_s: 20")
TEXT = TEXT.split("\nenvironment:")[0] + "\n"


def test_who_flies_into_the_floor_has_collided_and_its_log_says_so_too(tmp_path: Path) -> None:
    """Protects: the outcome knows the floor that the mission names, and is the same from the file."""
    depth = np.full((2, 2), 2.1, np.float32)
    mission = parse_mission(TEXT + "sea_floor: {clearance_m: 0.5, grid: shoal}\n")
    run = bumpless.fly(with_floor(mission, DepthGrid(depth, 100.0, -100.0, 200.0, 200.0, False)))
    assert run.outcome.ending == "collided" and "sea floor" in run.outcome.reason
    run.save(tmp_path / "shoal.mcap")
    assert bumpless.open_run(tmp_path / "shoal.mcap").outcome == run.outcome
    deep = DepthGrid(depth + 20.0, 100.0, -100.0, 200.0, 200.0, False)
    assert bumpless.fly(with_floor(mission, deep)).outcome.ending == "time_over"


def test_a_live_run_is_judged_by_the_grid_that_its_recorder_knows(tmp_path: Path) -> None:
    """Protects: a live vehicle has no charts, so its run that had touched the shoal was called time over."""
    depth = np.full((2, 2), 2.1, np.float32)
    grid = to_bytes(DepthGrid(depth, 100.0, -100.0, 200.0, 200.0, False))
    bus = on_bus(bumpless.fly(parse_mission(TEXT + "sea_floor: {clearance_m: 0.5, grid: shoal}\n")))
    for name, known in {"known": grid, "unknown": None}.items():
        record(tmp_path / f"{name}.mcap", bus, depths=lambda _, known=known: known)
    told = {name: summarise(tmp_path / f"{name}.mcap").outcome for name in ("known", "unknown")}
    assert told == {"known": "collided", "unknown": "time_over"}
    assert bumpless.open_run(tmp_path / "known.mcap").outcome.ending == "collided"


def test_a_floor_changes_no_flight() -> None:
    """Protects: the autopilot and the plant know nothing of it: flights stay equal to the bit."""
    mission = parse_mission(TEXT)
    floored = parse_mission(TEXT + "sea_floor: {clearance_m: 1}\nenvironment: {}\n")
    one, two = (bumpless.fly(replace(m, environment=mission.environment)).columns for m in (mission, floored))
    assert np.array_equal(one.eta, two.eta) and np.array_equal(one.u, two.u)
