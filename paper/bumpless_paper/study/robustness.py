"""Do the goals hold over the stated distribution of plants, with one fixed set of parameters?

answer = run(n_plants=200, progress=print)
answer["goals"]["d_u,FR S3->S4"]["share"]  -> share of plants on which the goal holds
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from bumpless_paper.study.figures import Figures
from bumpless_paper.study.goals import GOALS, Goal
from bumpless_paper.study.many import Flown, fly_rows, plant_rows, share_of
from bumpless_paper.study.plants import DISTRIBUTION, Plant, draw
from bumpless_paper.study.readings import READINGS, scenarios_of
from bumpless_paper.study.scenarios import Overrides
from bumpless_paper.study.tables import Progress

SCENARIO_NAMES: tuple[str, ...] = ("S1", "S2", "S3", "S4", "S5", "S6")
WANTED_SHARE = 0.9
TUNED_ON, HELD_OUT = (
    0,
    200,
)  # first plant of the 200 that the parameters were chosen on; of those they never saw


def run(
    n_plants: int = 200,
    progress: Progress = None,
    workers: int | None = None,
    extra: Overrides | None = None,
    first: int = 0,
    variants: bool = False,
) -> dict[str, Any]:
    """Fly S1 to S6 on plants first .. first + n_plants - 1 and hold every goal against every plant.

    Plant i flies with seed i + 1. workers: processes, None for every core. extra: parameters laid
    under the scenarios' own (a design under trial). variants: fly those of S1 and S3 as well, for the
    readings that need them. Returns plain values fit for JSON.
    """
    plants = [draw(first + i) for i in range(n_plants)]
    names = scenarios_of() if variants else SCENARIO_NAMES
    flown = fly_rows(plant_rows(plants, names, extra), progress, workers)
    return {
        "plants": [p.as_dict() for p in plants],
        "distribution": {
            k: {"low": s.low, "high": s.high, "unit": s.unit, "log": s.logarithmic, "about": s.about}
            for k, s in DISTRIBUTION.items()
        },
        "goals": {goal.name: _judge(goal, plants, flown) for goal in GOALS},
        "readings": {
            reading.name: {
                goal.name: share_of(read, flown)
                for goal in GOALS
                if (read := reading.of(goal)) is not None and {read.of, read.over} <= set(names)
            }
            for reading in READINGS
        },
        "figures": [{s: _plain(f) for s, f in row.items()} for row in flown],
    }


def _judge(goal: Goal, plants: Sequence[Plant], flown: Sequence[Flown]) -> dict[str, Any]:
    ratios = np.array([goal.ratio(row) for row in flown])
    holds = np.array([goal.holds(row) for row in flown])
    finite = ratios[np.isfinite(ratios)]
    quantiles = np.quantile(finite, (0.05, 0.5, 0.9, 0.95)) if len(finite) else [None] * 4
    share = share_of(goal, flown)
    return goal.as_dict() | {
        "share": share,
        "met": share >= WANTED_SHARE,
        "undefined": int(np.count_nonzero(~np.isfinite(ratios))),
        "ratio_quantiles": dict(zip(("q05", "q50", "q90", "q95"), map(_number, quantiles), strict=True)),
        "ratios": [_number(r) for r in ratios],
        "failed_plants": [p.number for p, ok in zip(plants, holds, strict=True) if not ok],
        "where": _where(plants, holds),
    }


def _where(plants: Sequence[Plant], holds: np.ndarray) -> dict[str, dict[str, float | None]]:
    """Mean of each uncertain number where the goal holds and where it fails, -1 to 1 over its range.

    `magnitude` compares distances from the range's middle: failures at both ends show there.
    """
    out = {}
    for name, spread in DISTRIBUTION.items():
        raw = np.array([getattr(p, name) for p in plants], float)
        low, high = spread.low, spread.high
        if spread.logarithmic:
            raw, low, high = np.log(raw), np.log(low), np.log(high)
        x = 2.0 * (raw - low) / (high - low) - 1.0
        out[name] = {
            "holds": _mean(x[holds]),
            "fails": _mean(x[~holds]),
            "magnitude_holds": _mean(np.abs(x[holds])),
            "magnitude_fails": _mean(np.abs(x[~holds])),
        }
    return out


def _mean(values: np.ndarray) -> float | None:
    return float(values.mean()) if len(values) else None


def _number(value: float | None) -> float | None:
    return float(value) if value is not None and np.isfinite(value) else None


def _plain(figures: Figures) -> dict[str, float | None]:
    return {key: _number(value) for key, value in figures.items()}
