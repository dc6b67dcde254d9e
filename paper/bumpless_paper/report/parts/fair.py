"""Allocator by ramp on the docking vehicle, each with the gains that are best for it."""

import os
from collections.abc import Sequence
from typing import Any

from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.study import counted
from bumpless_paper.report.ticks import number, share
from bumpless_paper.study.fair import ROWS, campaign, found, gains, judge
from bumpless_paper.study.outcomes import HELD_OUT

FLIGHTS = max(4, min(100, int(os.environ.get("BUMPLESS_PLANTS", "100"))))


def part(progress: Progress) -> Part:
    """Fly every row with its own gains on the same flights."""
    answer = judge(FLIGHTS, os.cpu_count() or 1, counted(progress, 0.0, 1.0))
    progress(1.0)
    rows, tune = answer["rows"], campaign().campaign.tune
    assert tune is not None
    return Part(
        "fair",
        "Allocator by ramp",
        f"TS-100 docks into a current with each allocator, with the ramp and without, on the same {FLIGHTS} "
        "drawn "
        f"flights (seed {HELD_OUT:,}), whose fins (slew, lag, lift), screws and sensors the autopilot does "
        "not "
        f"know. S2, S3 and S4 each fly the best gains of a search of their own: {tune.trials} trials of "
        f"{campaign().campaign.count} flights over the same {len(tune.search)} parameters with the same "
        "score, begun from the same gains, which stay where held-out flights find nothing clearly better. "
        f"{findings(rows)}",
        [_endings(rows), _steps(rows), _tracking(rows), _gains()],
        numbers=answer,
        hashes={
            "campaign": campaign().identity()["campaign"],
            "vehicle ts100": campaign().identity()["vehicle"],
        },
    )


def findings(rows: dict[str, Any]) -> str:
    """Who docks most often, who is gentlest, whose wrench is nearest to the demand."""
    best = max(rows.values(), key=lambda row: row["docked"])
    gentlest = min(rows.values(), key=_largest)
    nearest = min(rows.values(), key=lambda row: row["median"]["wrench_error_rms"] or 1e9)
    four = rows["mdca_ramp"]
    return (
        f"Docks most often: {best['title']}, {share(best['docked'])}; the whole method (S4) "
        f"{share(four['docked'])}. "
        f"Gentlest until 15 s after the ramp: {gentlest['title']}, whose largest step is "
        f"{number(_largest(gentlest), 2)} on the median flight; S4's is {number(_largest(four), 2)}. Nearest "
        "to the "
        f"demand by the true wrench: {nearest['title']}, {number(nearest['median']['wrench_error_rms'], 2)}; "
        "S4 "
        f"{number(four['median']['wrench_error_rms'], 2)}."
    )


def _largest(row: dict[str, Any]) -> float:
    steps = [row["median"][f"late_step_{switch}"] for switch in ("fr", "rh")]
    return max(float("inf") if step is None else step for step in steps)


def _endings(rows: dict[str, Any]) -> Grid:
    words = ("docked", "held", "waved_off", "time_over", "collided")
    return Grid(
        "fair_outcomes",
        "How the flights end",
        "Flights of each ending.",
        ["allocator", *(word.replace("_", " ") for word in words), "docked, 95 % interval"],
        [
            [
                row["title"],
                *(row["endings"].get(word, 0) for word in words),
                " – ".join(share(end) for end in row["docked_interval"]),
            ]
            for row in rows.values()
        ],
    )


def _steps(rows: dict[str, Any]) -> Grid:
    return Grid(
        "fair_steps",
        "Steps, true wrench and cost",
        "Largest step of the commands over their bounds in the paper's window and until 15 s after the "
        "ramp's end; "
        "the share of flights on which the latter is at most 0.05; RMS e_τ by the plant's true wrench; work "
        "at the "
        "shafts and way of the fins. Medians over the flights.",
        ["allocator", "F→R, ±2 s", "F→R, late", "≤ 0.05 on", "R→H, ±2 s", "R→H, late", "≤ 0.05 on",
         "RMS e_τ, true", "energy J", "fins °", "reversals"],
        [
            [
                row["title"],
                *_medians(row, ("step_fr", "late_step_fr")),
                share(row["gentle"]["fr"]),
                *_medians(row, ("step_rh", "late_step_rh")),
                share(row["gentle"]["rh"]),
                *_medians(row, ("wrench_error_rms", "energy_j", "fin_travel_deg", "reversals")),
            ]
            for row in rows.values()
        ],
    )  # fmt: skip


def _tracking(rows: dict[str, Any]) -> Grid:
    columns = {
        "depth F m": "forward_depth_m_rms",
        "depth R m": "reverse_depth_m_rms",
        "depth H m": "hover_depth_m_rms",
        "cross-track R m": "reverse_cross_m_rms",
        "heading H °": "hover_heading_deg_rms",
    }
    return Grid(
        "fair_tracking",
        "Tracking",
        "RMS of the believed state about its reference, by mode; medians over the flights.",
        ["allocator", *columns],
        [[row["title"], *_medians(row, tuple(columns.values()))] for row in rows.values()],
    )


def _gains() -> Grid:
    """What each row's search found, and what that was worth on flights that it had not seen."""
    rows = found()
    paths = list(next(iter(rows.values()))["values"])
    return Grid(
        "fair_gains",
        "The gains, and what the search was worth",
        "Values found; score (smaller is better) and flights docked of held-out flights, before and after.",
        ["allocator", *paths, "score before", "after", "docked before", "after", "flown"],
        [
            [
                ROWS[name].title,
                *(number(row["values"][path], 3) for path in paths),
                number(row["before"]["score"], 5),
                number(row["after"]["score"], 5),
                *(
                    f"{row[when]['docked']['count']} of {row[when]['docked']['total']}"
                    for when in ("before", "after")
                ),
                "found" if gains(name) == row["values"] else "as before",
            ]
            for name, row in rows.items()
        ],
    )


def _medians(row: dict[str, Any], keys: Sequence[str]) -> list[str]:
    return [number(row["median"].get(key), 3) for key in keys]
