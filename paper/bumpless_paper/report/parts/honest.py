"""Allocator by ramp on plants that no allocator's map fits: how flights end, track, step, and their cost."""

import math
import os
from collections.abc import Sequence
from typing import Any

from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.study import counted, study_hashes
from bumpless_paper.report.ticks import number, share
from bumpless_paper.study.honest import HELD_OUT, judge
from bumpless_paper.study.plants import WIDE
from bumpless_paper.study.scenarios import HONEST

PLANTS = min(60, int(os.environ.get("BUMPLESS_PLANTS", "60")))


def part(progress: Progress) -> Part:
    """Fly the whole table on drawn plants that had no part in choosing the parameters."""
    answer = judge(PLANTS, counted(progress, 0.0, 1.0))
    progress(1.0)
    rows = answer["rows"]
    return Part(
        "honest",
        "Judged by the mission",
        f"The same mission on {PLANTS} plants drawn from a wider distribution, whose fins, screws and "
        "sensors the "
        f"autopilot does not know (numbers {HELD_OUT} to {HELD_OUT + PLANTS - 1}: none had a part in "
        "choosing "
        "parameters). Every allocator flies the same gains, with the ramp and without; PID direct knows its "
        "inflow. "
        f"{_findings(rows)}",
        [_endings(rows), _steps(rows), _tracking(rows), _distribution()],
        numbers=answer,
        hashes=study_hashes(("S1", "S2", "S3", "S4")),
    )


def _findings(rows: dict[str, Any]) -> str:
    best = max(rows.values(), key=lambda row: row["docked"])
    gentlest = min(rows.values(), key=_largest_step)
    docked = f"{best['title']} docks most often, on {share(best['docked'])}"
    if best["docked"] == 0.0:
        docked = "No row docks on any plant"
    four = rows["S4"]
    return (
        f"{docked}; the whole method (S4) docks on {share(four['docked'])} and goes through the dock's plane "
        "on "
        f"{share(four['collided'])}. Until 15 s after the ramp the gentlest is {gentlest['title']}, whose "
        "largest "
        f"step is {number(_largest_step(gentlest), 2)} on the median plant; S4's is "
        f"{number(_largest_step(four), 2)}, of which the paper's window shows "
        f"{number(max(four['median']['window_FR'], four['median']['window_RH']), 2)}."
    )


def _largest_step(row: dict[str, Any]) -> float:
    """Median over the plants while settling, the larger of both switches; infinite where none switched."""
    steps = [row["median"].get(f"settling_{switch}") for switch in ("FR", "RH")]
    return max(math.inf if step is None else step for step in steps)


def _endings(rows: dict[str, Any]) -> Grid:
    words = ("docked", "held", "waved_off", "time_over", "collided")
    return Grid(
        "honest_outcomes",
        "How the flights end",
        "Docked: within 0.15 m, 5° and 0.05 m/s of the observation point for the last 10 s, by the truth; "
        "held: in "
        "hover, but not that; collided: the hull's axis went through the dock's plane within 0.5 m of the "
        "marker, "
        "whatever came after. Position and heading error: median over the plants at the end.",
        [
            "allocator",
            *(word.replace("_", " ") for word in words),
            "docked, 95 % interval",
            "position m",
            "heading °",
        ],
        [
            [
                row["title"],
                *(share(row[word]) for word in words),
                " – ".join(share(end) for end in row["docked_interval"]),
                *_medians(row, ("position_m", "heading_deg")),
            ]
            for row in rows.values()
        ],
    )


def _steps(rows: dict[str, Any]) -> Grid:
    return Grid(
        "honest_steps",
        "Steps and cost",
        "Largest step of the commands over their bounds: in the paper's window, 2 s either side of the "
        "switch, and "
        "from the switch until 15 s after the ramp's end, into which a ramp can defer its step; the share of "
        "plants "
        "on which the latter is at most 0.05; the largest step of the plant's true force and moment over "
        "that time; "
        "RMS e_τ by the allocator's map, by what the actuators gave as told (the true wrench without the "
        "lift that fins have in a stream from aside, which the map leaves out), by the true wrench; "
        "work at the shafts and way of the fins in the whole flight. "
        "Medians "
        "over the plants.",
        [
            "allocator",
            "F→R, ±2 s",
            "F→R, to ramp + 15 s",
            "≤ 0.05 on",
            "R→H, ±2 s",
            "R→H, to ramp + 15 s",
            "≤ 0.05 on",
            "force N",
            "moment N·m",
            "RMS e_τ, map",
            "RMS e_τ, as told",
            "RMS e_τ, true",
            "energy J",
            "fins °",
        ],
        [
            [
                row["title"],
                *_medians(row, ("window_FR", "settling_FR")),
                share(row["gentle_FR"]),
                *_medians(row, ("window_RH", "settling_RH")),
                share(row["gentle_RH"]),
                *_medians(row, ("force_step_n", "moment_step_nm")),
                *_medians(row, ("e_tau_map", "e_tau_told", "e_tau_true", "energy_j", "fin_travel_deg")),
            ]
            for row in rows.values()
        ],
    )


def _tracking(rows: dict[str, Any]) -> Grid:
    columns = {
        "depth F m": "depth_F_m",
        "depth R m": "depth_R_m",
        "depth H m": "depth_H_m",
        "cross-track R m": "cross_R_m",
        "heading R °": "heading_R_deg",
        "heading H °": "heading_H_deg",
        "speed R m/s": "speed_R_mps",
    }
    return Grid(
        "honest_tracking",
        "Tracking",
        "RMS of the believed state about its reference (not about its own mean, as in the paper's tables A5 "
        "and "
        "A6), by mode; medians over the plants.",
        ["allocator", *columns],
        [[row["title"], *_medians(row, tuple(columns.values()))] for row in rows.values()],
    )


def _medians(row: dict[str, Any], keys: Sequence[str]) -> list[str]:
    return [number(row["median"].get(key), 3) for key in keys]


def _distribution() -> Grid:
    return Grid(
        "honest_distribution",
        "The wider distribution",
        f"All of the distribution of plants above is drawn, the fault aside, which no row of these "
        f"{len(HONEST)} "
        "has; and beside it what makes the allocator's own map wrong. The autopilot is told none of it.",
        ["number", "low", "high", "unit", "drawn", "what"],
        [
            [name, s.low, s.high, s.unit, "log-uniform" if s.logarithmic else "uniform", s.about]
            for name, s in WIDE.items()
            if not name.startswith("fault_")
        ],
    )
