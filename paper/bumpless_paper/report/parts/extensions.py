"""What the design adds to the published method, and what each addition is needed for."""

import os
from typing import Any

from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.study import counted, study_hashes
from bumpless_paper.report.ticks import change, share, words
from bumpless_paper.study.ablation import ALL_ON, PUBLISHED, extension_ablation
from bumpless_paper.study.extensions import EXTENSIONS, Extension
from bumpless_paper.study.goals import GOALS
from bumpless_paper.study.robustness import SCENARIO_NAMES, WANTED_SHARE

PLANTS = min(60, int(os.environ.get("BUMPLESS_PLANTS", "60")))
NOTICED = 0.05  # change of a share that is named


def part(progress: Progress) -> Part:
    """Each extension switched off alone, all of them off, all on."""
    rows = extension_ablation(PLANTS, progress=counted(progress, 0.0, 1.0))
    by_name = {row["name"]: row["goals"] for row in rows}
    needed = {e.name: effect(by_name[ALL_ON], by_name[e.name]) for e in EXTENSIONS}
    return Part(
        "extensions",
        "What was added to the published method",
        f"{len(EXTENSIONS)} additions; each can be switched off by itself in the parameters of a vehicle or "
        "of a mission. All scenarios share them where they have a meaning, the baselines S1 to S3 included, "
        "so that they do not favour S4; only the priced ramp belongs to bumpless switching, what makes up "
        "for easing to the constrained allocator, and gains after a fault to fault tolerance.",
        [_needs(needed), _ablation(rows)],
        numbers={"plants": PLANTS, "goals": by_name, "needed": needed},
        hashes=study_hashes(SCENARIO_NAMES),
    )


def effect(on: dict[str, Any], off: dict[str, Any]) -> dict[str, list[str]]:
    """Goals that hold widely enough only with an extension, those it costs, and those it merely moves."""
    out: dict[str, list[str]] = {"needed for": [], "helps": [], "costs": []}
    for goal in GOALS:
        a, b = on[goal.name]["share"], off[goal.name]["share"]
        if a >= WANTED_SHARE > b:
            out["needed for"].append(goal.name)
        elif a - b >= NOTICED:
            out["helps"].append(goal.name)
        elif b - a >= NOTICED:
            out["costs"].append(goal.name)
    return out


def _flown_by(extension: Extension) -> str:
    return "all" if extension.by[0] == "S1" else f"{extension.by[0]} to {extension.by[-1]}"


def _needs(needed: dict[str, dict[str, list[str]]]) -> Grid:
    rows = []
    for extension in EXTENSIONS:
        found = needed[extension.name]
        said = {key: "; ".join(words(name) for name in names) or "–" for key, names in found.items()}
        rows.append([extension.name, extension.about, _flown_by(extension), *said.values()])
    return Grid(
        "extensions",
        "Each extension and what it is for",
        f"Needed for: the goal holds on at least {share(WANTED_SHARE)} of {PLANTS} plants with the extension "
        f"and on fewer without it. Helps, costs: its share is at least {share(NOTICED)} higher, or lower, "
        "with it.",
        ["extension", "what it does", "used by", "needed for", "helps", "costs"],
        rows,
    )


def _ablation(rows: list[dict[str, Any]]) -> Grid:
    lines = []
    for row in rows:
        name = row["name"] if row["name"] in (ALL_ON, PUBLISHED) else f"without {row['name']}"
        cells = [row["goals"][goal.name] for goal in GOALS]
        lines.append([name, *(f"{change(cell['ratio'])}\n{share(cell['share'])}" for cell in cells)])
    return Grid(
        "extension_ablation",
        "Every goal with one extension switched off",
        f"Upper line: change on the nominal plant, median of five seeds; lower line: share of plants 0 to "
        f"{PLANTS - 1} on which the goal holds. The baselines change too, so a larger change need not be a "
        "better S4.",
        ["", *(words(goal.name) for goal in GOALS)],
        lines,
    )
