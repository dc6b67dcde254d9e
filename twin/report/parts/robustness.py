"""Not at one lucky point: the share of drawn plants on which each goal holds, and where it fails."""

import os
from typing import Any

from twin.report.content import Grid, Part
from twin.report.parts import Progress
from twin.report.parts.study import counted
from twin.report.ticks import number, percent
from twin.study.robustness import WANTED_SHARE, run

PLANTS = int(os.environ.get("BUMPLESS_PLANTS", "200"))


def part(progress: Progress) -> Part:
    """Fly S1 to S6 on every drawn plant."""
    answer = run(PLANTS, progress=counted(progress, 0.0, 1.0))
    goals = answer["goals"]
    met = [name for name, goal in goals.items() if goal["met"]]
    return Part(
        "robustness",
        "On many plants",
        f"One fixed set of parameters on {PLANTS} plants drawn from the stated distribution: {len(met)} of "
        f"{len(goals)} goals hold on at least {WANTED_SHARE:.0%} of them.",
        [_goals(goals), _readings(answer["readings"]), _distribution(answer["distribution"])],
        numbers={
            "plants": PLANTS,
            "share": {name: goal["share"] for name, goal in goals.items()},
            "met": met,
            "missed": [name for name in goals if name not in met],
        },
    )


def _goals(goals: dict[str, Any]) -> Grid:
    rows = []
    for name, goal in goals.items():
        q = goal["ratio_quantiles"]
        rows.append(
            [
                name,
                percent(goal["paper"] - 1.0),
                percent(goal["limit"] - 1.0),
                percent(None if q["q50"] is None else q["q50"] - 1.0),
                percent(None if q["q90"] is None else q["q90"] - 1.0),
                f"{goal['share']:.0%}",
                "met" if goal["met"] else "missed",
                "" if goal["share"] == 1.0 else _where(goal["where"]),
            ]
        )
    return Grid(
        "goals",
        "Goals",
        "Change of the figure between the two scenarios: the paper's, the goal, ours (median and the plant "
        "at the 90 % mark), the share of plants on which the goal holds, and what marks the others: the two "
        "uncertain numbers that differ most, as means over the range −1 to 1.",
        ["goal", "paper", "goal", "median", "90 % mark", "holds on", "", "fails where"],
        rows,
    )


def _where(where: dict[str, Any]) -> str:
    found = []
    for name, w in where.items():
        for label, good, bad in (
            (name, w["holds"], w["fails"]),
            (f"|{name}|", w["magnitude_holds"], w["magnitude_fails"]),
        ):
            if good is not None and bad is not None:
                found.append((abs(bad - good), f"{label} {number(bad, 2)} against {number(good, 2)}"))
    return "; ".join(text for _, text in sorted(found, reverse=True)[:2])


def _readings(readings: dict[str, dict[str, float]]) -> Grid:
    rows = [
        [reading, goal, f"{share:.0%}"]
        for reading, goals in readings.items()
        for goal, share in goals.items()
    ]
    return Grid(
        "goals_other_readings",
        "The same goals under other definitions",
        "Share of plants.",
        ["definition", "goal", "holds on"],
        rows,
    )


def _distribution(spreads: dict[str, Any]) -> Grid:
    rows = [
        [name, s["low"], s["high"], s["unit"], "log-uniform" if s["log"] else "uniform", s["about"]]
        for name, s in spreads.items()
    ]
    return Grid(
        "distribution", "The distribution of plants", "", ["number", "low", "high", "unit", "", "what"], rows
    )
