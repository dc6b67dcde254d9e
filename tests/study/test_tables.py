"""Tables, goals, ablation and robustness give plain values with the paper's numbers beside ours."""

import json
import math

from twin.study.ablation import BUMPLESS_FIGURES, ablation, bumpless_variations
from twin.study.goals import GOALS, READINGS, other_reading
from twin.study.published import TABLE_6, TABLE_7, TABLE_8
from twin.study.robustness import run
from twin.study.tables import table6, table7, table8


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
    for reading in READINGS:
        assert any(other_reading(goal, reading) for goal in GOALS)


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
