"""Not at one lucky point: the share of drawn plants on which each goal holds, and where it fails."""

import os
from typing import Any

from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.study import SEEDS, counted, study_hashes
from bumpless_paper.report.ticks import change, number, share, words
from bumpless_paper.study.goals import GOALS
from bumpless_paper.study.many import Flown, fly_rows, nominal_rows, ratio_of
from bumpless_paper.study.readings import primary_definition, readings_of, scenarios_of
from bumpless_paper.study.robustness import HELD_OUT, SCENARIO_NAMES, TUNED_ON, WANTED_SHARE, run

FAULTY = ("S5", "S6")
PLANTS = int(os.environ.get("BUMPLESS_PLANTS", "200"))


def part(progress: Progress) -> Part:
    """Fly S1 to S6 on the plants that the design was tuned on, and on as many that it never saw."""
    answer = run(PLANTS, counted(progress, 0.0, 0.55), first=TUNED_ON, variants=True)
    unseen = run(PLANTS, counted(progress, 0.55, 0.95), first=HELD_OUT)["goals"]
    nominal = fly_rows(nominal_rows(scenarios_of(), SEEDS), workers=1)
    progress(1.0)
    goals = answer["goals"]
    met = [name for name, goal in goals.items() if goal["met"]]
    kept = sum(goal["met"] for goal in unseen.values())
    readings = read_otherwise(answer, nominal)
    return Part(
        "robustness",
        "On many plants",
        f"One fixed set of parameters on {PLANTS} plants drawn from the stated distribution: {len(met)} of "
        f"{len(goals)} goals hold on at least {share(WANTED_SHARE)} of them. The parameters were chosen on "
        f"plants {_range(TUNED_ON)}; plants {_range(HELD_OUT)} had no part in the choice, and on them "
        f"{kept} of {len(goals)} hold.",
        [_goals(goals, unseen, nominal), _readings(readings), _distribution(answer["distribution"])],
        numbers={
            "plants": PLANTS,
            "share": {name: goal["share"] for name, goal in goals.items()},
            "held_out_share": {name: goal["share"] for name, goal in unseen.items()},
            "nominal_ratio": {goal.name: ratio_of(goal, nominal) for goal in GOALS},
            "median_ratio": {name: goal["ratio_quantiles"]["q50"] for name, goal in goals.items()},
            "met": met,
            "missed": [name for name in goals if name not in met],
            "readings": readings,
        },
        hashes=study_hashes(SCENARIO_NAMES),
    )


def _range(first: int) -> str:
    return f"{first} to {first + PLANTS - 1}"


def read_otherwise(answer: dict[str, Any], nominal: list[Flown]) -> dict[str, list[dict[str, Any]]]:
    """By goal: each definition with the nominal ratio and the share of plants; the primary one first."""
    return {
        goal.name: [
            {
                "definition": primary_definition(goal),
                "nominal_ratio": ratio_of(goal, nominal),
                "share": answer["goals"][goal.name]["share"],
            },
            *(
                {
                    "definition": name,
                    "nominal_ratio": ratio_of(read, nominal),
                    "share": answer["readings"][name].get(goal.name),
                }
                for name, read in readings_of(goal)
            ),
        ]
        for goal in GOALS
    }


def _goals(goals: dict[str, Any], unseen: dict[str, Any], nominal: list[Flown]) -> Grid:
    rows = []
    for goal in GOALS:
        of = goals[goal.name]
        q = of["ratio_quantiles"]
        rows.append(
            [
                words(goal.name),
                change(goal.paper),
                change(goal.limit),
                change(ratio_of(goal, nominal)),
                change(q["q50"]),
                change(q["q90"]),
                share(of["share"]),
                share(unseen[goal.name]["share"]),
                "met" if of["met"] else "missed",
                "" if of["share"] == 1.0 else _where(of["where"], goal.of in FAULTY),
            ]
        )
    return Grid(
        "goals",
        "Goals",
        "Change of the figure from the first scenario to the second (of S4 against S2 for S4 ≤ S2): the "
        "paper's; the goal; ours on the nominal plant (median of five seeds), on the median plant and on "
        "the plant at the 90 % mark; the share of plants on which the goal holds, of those used for tuning "
        "and of those never seen; and what marks the plants on which it fails: the two uncertain numbers "
        "whose means differ most, each scaled to −1 … 1 over its range.",
        [
            "goal",
            "paper",
            "wanted",
            "nominal plant",
            "median plant",
            "90 % mark",
            f"holds on {TUNED_ON}–{TUNED_ON + PLANTS - 1}",
            f"unseen {HELD_OUT}–{HELD_OUT + PLANTS - 1}",
            "",
            "fails where",
        ],
        rows,
    )


def _where(where: dict[str, Any], faulty: bool) -> str:
    """The two numbers that differ most; those of the fault only for goals that know one."""
    found = []
    for name, w in where.items():
        if name.startswith("fault_") and not faulty:
            continue
        for label, good, bad in (
            (name, w["holds"], w["fails"]),
            (f"|{name}|", w["magnitude_holds"], w["magnitude_fails"]),
        ):
            if good is not None and bad is not None:
                found.append((abs(bad - good), f"{label} {number(bad, 2)} against {number(good, 2)}"))
    return "; ".join(text for _, text in sorted(found, reverse=True)[:2])


def _readings(readings: dict[str, list[dict[str, Any]]]) -> Grid:
    rows = []
    for goal in GOALS:
        for k, read in enumerate(readings[goal.name]):
            rows.append(
                [
                    words(goal.name) if k == 0 else "",
                    ("ours: " if k == 0 else "") + read["definition"],
                    change(goal.limit) if k == 0 else "",
                    change(read["nominal_ratio"]),
                    share(read["share"]),
                ]
            )
    return Grid(
        "goals_other_readings",
        "The same goals under other definitions",
        "The paper leaves open in which units d_u is taken, what tau_c is, what S1 maps, what S3 does with "
        "its integrals, and which window and which deviation count. First line of each goal: the definition "
        "that decides it here; below it the others, judged against the same limit. Nominal plant: median of "
        f"five seeds; share of plants {_range(TUNED_ON)}.",
        ["goal", "definition", "wanted", "nominal plant", "holds on"],
        rows,
    )


def _distribution(spreads: dict[str, Any]) -> Grid:
    rows = [
        [name, s["low"], s["high"], s["unit"], "log-uniform" if s["log"] else "uniform", s["about"]]
        for name, s in spreads.items()
    ]
    return Grid(
        "distribution",
        "The distribution of plants",
        "Each number is drawn by itself; the autopilot keeps one nominal model and one set of parameters "
        "and is never told what was drawn.",
        ["number", "low", "high", "unit", "drawn", "what"],
        rows,
    )
