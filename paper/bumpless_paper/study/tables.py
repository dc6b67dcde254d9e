"""Tables 6, 7 and 8 in the paper's format: paper, ours, relative change, and the spread over seeds.

    table6(seeds=(1, 2, 3, 4, 5))["rows"]["S4"]["d_u_FR"]
    -> {"paper": 0.9044, "ours": ..., "spread": [least, largest], "change": ..., "other": {...}, ...}

Everything returned is plain and fit for JSON. `change` is relative to the row's reference scenario
(S3 for S4's d_u, S1 for e_tau, S5 for S6), `other` holds the same figure under the other readings.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from bumpless_paper.study.figures import Figures
from bumpless_paper.study.fly import Job, fly_all, scenario_named
from bumpless_paper.study.published import REFERENCES, TABLE_6, TABLE_7, TABLE_8, Column
from bumpless_paper.study.scenarios import VARIANTS, Overrides

SEEDS = (1, 2, 3, 4, 5)
Progress = Callable[[int, int], None] | None


def table6(
    seeds: Sequence[int] = SEEDS, progress: Progress = None, workers: int = 1, extra: Overrides | None = None
) -> dict[str, Any]:
    """No fault: RMS e_tau, r_sat, d_u,FR and d_u,RH of S1 to S4, and of the variants of S1 and S3."""
    scenarios = ("S1", "S2", "S3", "S4")
    names = (*scenarios, *(name for name in VARIANTS if name.partition("-")[0] in scenarios))
    return _table("6", TABLE_6, names, seeds, progress, workers, extra)


def table7(
    seeds: Sequence[int] = SEEDS, progress: Progress = None, workers: int = 1, extra: Overrides | None = None
) -> dict[str, Any]:
    """Propeller fault: post-fault e_tau, attitude deviation and slack of S5 and S6."""
    return _table("7", TABLE_7, ("S5", "S6"), seeds, progress, workers, extra)


def table8(
    seeds: Sequence[int] = SEEDS, progress: Progress = None, workers: int = 1, extra: Overrides | None = None
) -> dict[str, Any]:
    """Time of the allocator in one cycle, ms. Depends on the machine, as the paper's does."""
    return _table("8", TABLE_8, ("S1", "S2", "S3", "S4", "S5", "S6"), seeds, progress, workers, extra)


def fly_seeds(
    names: Sequence[str], seeds: Sequence[int], progress: Progress, workers: int, extra: Overrides | None
) -> dict[str, list[Figures]]:
    """Figures of each scenario for each seed, on the nominal plant."""
    jobs = [Job(name, seed, extra=extra or {}) for name in names for seed in seeds]
    flat = fly_all(jobs, workers=workers, progress=progress)
    return {name: flat[i * len(seeds) : (i + 1) * len(seeds)] for i, name in enumerate(names)}


def _table(
    number: str,
    columns: Sequence[Column],
    names: Sequence[str],
    seeds: Sequence[int],
    progress: Progress,
    workers: int,
    extra: Overrides | None,
) -> dict[str, Any]:
    flown = fly_seeds(names, seeds, progress, workers, extra)
    rows = {}
    for name in names:
        cells = {column.name: _cell(column, name, flown) for column in columns}
        rows[name] = {"title": scenario_named(name).title, **cells}
    return {
        "table": number,
        "seeds": list(seeds),
        "columns": [
            {"name": c.name, "unit": c.unit, "definition": c.definition, "figure": c.figure} for c in columns
        ],
        "rows": rows,
    }


def spread_of(values: Sequence[float]) -> dict[str, Any]:
    """Median, least and largest of the seeds; None where the figure does not exist."""
    kept = np.array([v for v in values if np.isfinite(v)])
    if not len(kept):
        return {"ours": None, "spread": None}
    return {"ours": float(np.median(kept)), "spread": [float(kept.min()), float(kept.max())]}


def _cell(column: Column, name: str, flown: dict[str, list[Figures]]) -> dict[str, Any]:
    cell: dict[str, Any] = {"paper": column.paper.get(name)}
    cell |= spread_of([f[column.figure] for f in flown[name]])
    reference = REFERENCES.get((column.name, name), REFERENCES.get(("", name)))
    if reference is not None and reference in flown:
        cell["reference"] = reference
        pairs = zip(flown[name], flown[reference], strict=True)
        changes = [a[column.figure] / b[column.figure] - 1.0 for a, b in pairs if b[column.figure]]
        change = spread_of(changes)
        cell["change"], cell["change_spread"] = change["ours"], change["spread"]
        of, over = column.paper.get(name), column.paper.get(reference)
        cell["paper_change"] = of / over - 1.0 if of is not None and over else None
    cell["other"] = {figure: spread_of([f[figure] for f in flown[name]]) for figure in column.other}
    return cell
