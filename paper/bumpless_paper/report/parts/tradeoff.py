"""Goals that cannot all be met, and what each would cost: curves over one parameter of the design."""

import os
from typing import Any

import numpy as np

from bumpless_paper.report.content import Figure, Grid, Panel, Part, Series
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.study import counted, study_hashes
from bumpless_paper.report.ticks import number, share, words
from bumpless_paper.study.robustness import SCENARIO_NAMES, WANTED_SHARE
from bumpless_paper.study.tradeoff import CURVES, Curve, trade_offs

PLANTS = min(40, int(os.environ.get("BUMPLESS_PLANTS", "40")))


def part(progress: Progress) -> Part:
    """Fly every curve; scenarios that a parameter does not touch fly once."""
    flown = trade_offs(CURVES, PLANTS, counted(progress, 0.0, 1.0))
    progress(1.0)
    return Part(
        "tradeoff",
        "Goals that pull against each other",
        "Where a goal is missed, its price: one parameter of the design moves through its range, all "
        f"else stays, and the goals it touches are judged on plants 0 to {PLANTS - 1}. Dotted line: in use.",
        [_table(flown)],
        [_figure(curve, flown[curve.id]) for curve in CURVES],
        numbers={
            "plants": PLANTS,
            "titles": {curve.id: curve.parameter for curve in CURVES},
            "curves": flown,
            "best": [top for curve in CURVES for top in best(curve, flown[curve.id])],
        },
        hashes=study_hashes(SCENARIO_NAMES),
    )


def _figure(curve: Curve, flown: dict[str, Any]) -> Figure:
    x = np.array([point["value"] for point in flown["points"]])
    ends = x[[0, -1]]
    shares, medians = [], []
    for k, name in enumerate(curve.goals):
        goals = [point["goals"][name] for point in flown["points"]]
        shares.append(Series(words(name), x, 100.0 * np.array([g["share"] for g in goals]), k))
        medians.append(Series(words(name), x, np.array([_value(g["over_limit"]) for g in goals]), k))
    shares.append(Series("wanted", ends, np.full(2, 100.0 * WANTED_SHARE), 5, "dash"))
    medians.append(Series("limit", ends, np.ones(2), 5, "dash"))
    marks = [(float(flown["in_use"]), "in use")]
    return Figure(
        f"tradeoff_{curve.id}",
        curve.parameter,
        f"{curve.about} Left: share of plants on which the goal holds; right: the median plant's ratio over "
        "the goal's limit, below 1 is better than wanted.",
        [
            Panel(curve.parameter, "holds on (% of plants)", shares, marks=marks, log_x=curve.log),
            Panel(curve.parameter, "median ratio / limit", medians, marks=marks, log_x=curve.log, log_y=True),
        ],
        2,
    )


def _value(value: float | None) -> float:
    return np.nan if value is None else value


def best(curve: Curve, flown: dict[str, Any]) -> list[dict[str, Any]]:
    """Of each goal: the point of the curve where most plants meet it, and what the other goals are there."""
    found = []
    for name in curve.goals:
        points = flown["points"]
        top = max(points, key=lambda point: point["goals"][name]["share"])
        others = {other: top["goals"][other]["share"] for other in curve.goals if other != name}
        found.append(
            {
                "curve": curve.id,
                "goal": name,
                "share": top["goals"][name]["share"],
                "at": top["value"],
                "others": others,
            }
        )
    return found


def _table(flown: dict[str, dict[str, Any]]) -> Grid:
    rows = []
    for curve in CURVES:
        for k, top in enumerate(best(curve, flown[curve.id])):
            others = "; ".join(f"{words(name)} {share(of)}" for name, of in top["others"].items())
            rows.append(
                [
                    curve.parameter if k == 0 else "",
                    number(flown[curve.id]["in_use"], 3) if k == 0 else "",
                    words(top["goal"]),
                    share(top["share"]),
                    number(float(top["at"]), 3),
                    others,
                ]
            )
    return Grid(
        "tradeoffs",
        "The best that each parameter can do for a goal",
        "Share of plants at the best point of the curve for that goal, and what is left of the others there.",
        ["parameter", "in use", "goal", "at best", "at", "the other goals there"],
        rows,
    )
