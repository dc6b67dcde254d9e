"""The plans that are asked how often they dock, and what is counted of them."""

import re
from pathlib import Path

import pytest

from bumpless.config.mission import missions_folder, parse_mission
from bumpless.feasibility import check_mission
from bumpless_paper.study.docks import asked, plans, shares
from bumpless_paper.study.docks.cases import vehicle
from bumpless_paper.study.docks.sides import FAMILIES

ROOT = Path(__file__).parents[3]


def test_the_newcomers_mission_is_what_the_planner_begins_with() -> None:
    """Protects: the share told of a newcomer's first mission is that of a mission nobody would draw."""
    template = (ROOT / "console_web/src/planner/model/templates.ts").read_text(encoding="utf-8")
    placed = (ROOT / "console_web/src/planner/model/operations.ts").read_text(encoding="utf-8")
    numbers = {k: float(v) for k, v in re.findall(r"const ([A-Z_]+) = ([\d.]+);", template + placed)}
    first = parse_mission(plans.FIRST, "first.yaml")
    assert first.duration_s == numbers["DURATION_S"] and first.end.hover_hold_s == numbers["HOVER_S"]
    assert first.target.standoff_m == numbers["STANDOFF_M"]
    assert {leg.speed_mps for leg in first.legs} == {numbers["CRUISE_MPS"]}
    assert "position_ned_m: [0, 0, 2]\n  heading_deg: 0\n  speed_mps: 0.7" in template
    assert first.start.position_ned_m == (0.0, 0.0, 2.0) and first.start.speed_mps == 0.7


def test_every_shipped_mission_is_asked_and_its_title_is_its_promise() -> None:
    """Protects: a mission that does not dock and does not say so is an example of nothing."""
    named = {one.name: one.promise for one in plans.examples()}
    assert set(named) == {file.stem for file in missions_folder().glob("*.yaml")}
    assert named["docking_refused"] == plans.NOT_MEANT
    assert {name for name, promise in named.items() if promise == plans.SELDOM} == {
        name for name in named if re.match(r"s\d_|tank\d", name)
    }


def test_a_row_counts_what_was_promised() -> None:
    """Protects: a wave-off where a docking was promised, or a touch anywhere, counted as kept."""
    ends = {"docked": 38, "waved_off": 1, "time_over": 1}
    assert shares.Row("x", plans.DOCKS, 2, ends).keeps
    assert not shares.Row("x", plans.DOCKS, 0, {**ends, "waved_off": 2}).keeps
    assert not shares.Row("x", plans.NOT_MEANT, 0, ends).keeps
    assert not shares.Row("x", plans.SELDOM, 0, {"held": 18, "collided": 2}).keeps
    assert shares.Row("x", plans.DOCKS, 2, ends).cells == (
        "x", "docks", "38 of 40 (83% – 99%)", "0", "1", "0", "1", "2",
    )  # fmt: skip


def test_a_plan_is_flown_again_as_it_was() -> None:
    """Protects: figures that nobody can repeat."""
    (row,) = shares.rows(800_000, 2, only=("rov_docking",), workers=1)
    assert row.ends == {"docked": 2} and row.keeps
    assert plans.odd(7) == plans.odd(7) != plans.odd(9)


@pytest.mark.parametrize("name", ["fast", "short", "brief", "nose", "sight", "long"])
def test_a_family_is_on_both_sides_of_its_rule(name) -> None:
    """Protects: a rule that is tried on one side only is not tried."""
    family = FAMILIES[name]
    told = [{one.code for one in check_mission(family.mission(name, k), vehicle())} for k in range(10)]
    said = [bool(codes & set(family.codes)) for codes in told]
    assert any(said) and not all(said)


def test_the_check_is_judged_by_how_the_flight_ends() -> None:
    """Protects: shares of refused and let pass that no flight stands behind."""
    row = asked.row("brief", 800_000, 6, workers=1)
    assert sum(row.asked.values()) == 6
    assert row.docked.get(asked.SILENT, 0) == row.asked[asked.SILENT] > 0
