"""Tables, goals, ablation and robustness give plain values with the paper's numbers beside ours."""

import json
import math
from dataclasses import replace

from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless_paper.study.ablation import (
    ALL_ON,
    BUMPLESS_FIGURES,
    PUBLISHED,
    ablation,
    bumpless_variations,
    extension_ablation,
)
from bumpless_paper.study.extensions import EXTENSIONS
from bumpless_paper.study.goals import GOALS, goal_named
from bumpless_paper.study.many import fly_rows, nominal_rows, plant_rows
from bumpless_paper.study.plants import draw
from bumpless_paper.study.published import TABLE_6, TABLE_7, TABLE_8
from bumpless_paper.study.readings import READINGS, primary_definition, readings_of, scenarios_of
from bumpless_paper.study.robustness import SCENARIO_NAMES, run
from bumpless_paper.study.tables import table6, table7, table8
from bumpless_paper.study.tradeoff import CURVES, trade_offs


def test_tables_are_plain_and_complete() -> None:
    """Protects: the report reads every cell of the paper's tables from JSON, with reference and spread."""
    tables = [table6(seeds=(1, 2)), table7(seeds=(1, 2)), table8(seeds=(1,))]
    for table, columns in zip(tables, (TABLE_6, TABLE_7, TABLE_8), strict=True):
        rows = json.loads(json.dumps(table, allow_nan=False))["rows"]
        for column in columns:
            for scenario, printed in column.paper.items():
                cell = rows[scenario][column.name]
                assert cell["paper"] == printed
                assert cell["spread"][0] <= cell["ours"] <= cell["spread"][1]
    cell = tables[0]["rows"]["S4"]["d_u_FR"]
    assert cell["reference"] == "S3"
    assert math.isclose(cell["paper_change"], -0.8117, abs_tol=1e-4)


def test_goals_carry_the_published_ratios() -> None:
    """Protects: every goal says what the paper reached, and its other readings exist as figures."""
    by_name = {goal.name: goal for goal in GOALS}
    assert math.isclose(by_name["d_u,RH S3->S4"].paper, 1 - 0.6253)
    assert math.isclose(by_name["e_tau S5->S6"].paper, 0.9988 / 1.1335, abs_tol=1e-3)


def test_every_reading_names_figures_that_exist() -> None:
    """Protects: each other definition touches a goal, flies a known scenario and reads a computed figure."""
    names = scenarios_of()
    assert {"S1-rpm", "S3-keep", "S3-reset"} < set(names)
    assert set(scenarios_of(readings=False)) == set(SCENARIO_NAMES)
    figures = fly_rows(nominal_rows(names, seeds=(1,)), workers=1)[0]
    for reading in READINGS:
        assert any(reading.of(goal) for goal in GOALS), reading.name
    for goal in GOALS:
        assert primary_definition(goal)
        for _, read in readings_of(goal):
            assert math.isfinite(read.ratio(figures))


def test_windows_nest() -> None:
    """Protects: a wider window never shows a smaller step, and no step exceeds its bound."""
    figures = fly_rows(nominal_rows(("S3",), seeds=(1,)), workers=1)[0]["S3"]
    for switch in ("FR", "RH"):
        assert figures[f"d_u_{switch}_1s"] <= figures[f"d_u_{switch}_bound"]
        assert figures[f"d_u_{switch}_bound"] <= figures[f"d_u_{switch}_limit"] + 1e-9


def test_extensions_are_ablated_one_by_one() -> None:
    """Protects: the table of extensions: its ends are the design and the published method."""
    rows = extension_ablation(1, seeds=(1,), workers=1)
    assert [row["name"] for row in rows] == [ALL_ON, *(e.name for e in EXTENSIONS), PUBLISHED]
    flown = fly_rows(nominal_rows(SCENARIO_NAMES, seeds=(1,)), workers=1)
    assert rows[0]["goals"][GOALS[0].name]["ratio"] == GOALS[0].ratio(flown[0])
    assert rows[0]["goals"] != rows[-1]["goals"]
    json.dumps(rows, allow_nan=False)


def test_a_trade_off_is_judged_as_the_goals_are() -> None:
    """Protects: scenarios that fly once are not mixed up with those that fly at every point."""
    curve = replace(CURVES[0], values=(1.0, 10.0))
    flown = trade_offs([curve], n_plants=1, workers=1)[curve.id]
    used = default_parameters(load_vehicle("ts100")).bumpless.ramp_increment_price
    assert flown["in_use"] == used
    at_ten = plant_rows([draw(0)], SCENARIO_NAMES, {"bumpless": {"ramp_increment_price": 10.0}})
    plain = fly_rows(at_ten, workers=1)
    for name in curve.goals:
        assert flown["points"][1]["goals"][name]["ratio"] == goal_named(name).ratio(plain[0])
    json.dumps(flown, allow_nan=False)


def test_nan_never_meets_a_goal() -> None:
    """Protects: a plant on which a switch never happened counts as a failure."""
    goal = GOALS[0]
    nan = {goal.figure: float("nan")}
    assert not goal.holds({goal.of: nan, goal.over: {goal.figure: 1.0}})
    assert not goal.holds({goal.of: {goal.figure: 0.0}, goal.over: nan})
    assert goal.holds({goal.of: {goal.figure: 0.1}, goal.over: {goal.figure: 1.0}})


def test_ablation_spans_none_to_all() -> None:
    """Protects: the ends of the ablation are S3 and S4 themselves."""
    rows = ablation(bumpless_variations(), BUMPLESS_FIGURES, seeds=(1,))
    table = table6(seeds=(1,))["rows"]
    for row, name in ((rows[0], "S3"), (rows[-1], "S4")):
        assert row["figures"]["d_u_FR_bound"]["ours"] == table[name]["d_u_FR"]["ours"]
    json.dumps(rows, allow_nan=False)


def test_robustness_judges_every_goal_on_every_plant() -> None:
    """Protects: shares, failed plants and ratios agree with each other."""
    seen: list[tuple[int, int]] = []
    answer = run(2, progress=lambda done, total: seen.append((done, total)), workers=1)
    json.dumps(answer, allow_nan=False)
    assert seen[-1] == (12, 12)
    for goal in GOALS:
        judged = answer["goals"][goal.name]
        assert math.isclose(judged["share"], 1 - len(judged["failed_plants"]) / 2)
        assert len(judged["ratios"]) == 2
