"""Many flights as rows: the scenarios that a comparison needs, on one plant and with one seed.

Rows of several questions can be flown in one go, so that the workers start once:

    flown = fly_rows([*plant_rows(plants, ("S3", "S4")), *nominal_rows(("S3", "S4"))])
"""

from collections.abc import Sequence

import numpy as np

from bumpless_paper.study.figures import Figures
from bumpless_paper.study.fly import Job, fly_all
from bumpless_paper.study.goals import Goal
from bumpless_paper.study.plants import NOMINAL, Plant
from bumpless_paper.study.scenarios import Overrides
from bumpless_paper.study.tables import SEEDS, Progress, spread_of

Row = Sequence[Job]
Flown = dict[str, Figures]  # of one row, by scenario


def plant_rows(plants: Sequence[Plant], names: Sequence[str], extra: Overrides | None = None) -> list[Row]:
    """The scenarios named on each plant; a drawn plant's seed is its number plus one."""
    return [[Job(name, p.number + 1, p, extra or {}) for name in names] for p in plants]


def nominal_rows(
    names: Sequence[str], seeds: Sequence[int] = SEEDS, extra: Overrides | None = None
) -> list[Row]:
    """The scenarios named on the nominal plant, one row per seed."""
    return [[Job(name, seed, NOMINAL, extra or {}) for name in names] for seed in seeds]


def fly_rows(rows: Sequence[Row], progress: Progress = None, workers: int | None = None) -> list[Flown]:
    """Figures of every row, in order. workers: as in `fly_all`."""
    flat = iter(fly_all([job for row in rows for job in row], workers=workers, progress=progress))
    return [{job.scenario: next(flat) for job in row} for row in rows]


def share_of(goal: Goal, flown: Sequence[Flown]) -> float:
    """Share of rows on which the goal holds."""
    return float(np.mean([goal.holds(row) for row in flown]))


def ratio_of(goal: Goal, flown: Sequence[Flown]) -> float | None:
    """Median ratio over the rows; None where it does not exist."""
    return spread_of([goal.ratio(row) for row in flown])["ours"]
