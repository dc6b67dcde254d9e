"""What a campaign found, in numbers: shares with their intervals, the figures' spread, the worst flights."""

from dataclasses import asdict, dataclass
from math import sqrt
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

import numpy as np

from bumpless.metrics.outcome import Ending

if TYPE_CHECKING:
    import pyarrow as pa

CONFIDENCE = 0.95
WORST = 20
SEVERITY = (  # worst first
    Ending.COLLIDED, Ending.ABORTED, Ending.INTERRUPTED, Ending.TIME_OVER, Ending.WAVED_OFF, Ending.HELD,
    Ending.DOCKED,
)  # fmt: skip
FIGURES = (
    "duration_s", "end_range_m", "end_heading_deg", "end_speed_mps", "largest_step", "energy_j",
    "wrench_error_rms", "forward_depth_m_rms", "reverse_depth_m_rms", "hover_depth_m_rms",
    "hover_heading_deg_rms",
)  # fmt: skip


@dataclass(frozen=True)
class Share:
    """`count` of `total`, with the Wilson interval of the share."""

    count: int
    total: int
    share: float
    low: float
    high: float


def share_of(count: int, total: int) -> Share:
    """Score interval. Source: Wilson 1927, J. Am. Stat. Assoc. 22. No flights: anything between 0 and 1.

    SciPy has it too, but its import costs as much as a hundred flights.
    """
    if total == 0:
        return Share(0, 0, float("nan"), 0.0, 1.0)
    z, p = NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE), count / total
    middle = (p + z * z / (2 * total)) / (1 + z * z / total)
    half = z / (1 + z * z / total) * sqrt(p * (1 - p) / total + (z / (2 * total)) ** 2)
    return Share(count, total, p, max(0.0, middle - half), min(1.0, middle + half))


@dataclass(frozen=True)
class Spread:
    """Of a figure over the flights in which it is known; magnitudes for those with a sign."""

    name: str
    known: int
    median: float
    p95: float
    worst: float


@dataclass(frozen=True)
class Summary:
    """The page's and `--json`'s numbers."""

    flights: int
    docked: Share
    outcomes: dict[str, Share]
    reasons: dict[str, int]  # "time_over: still in reverse" -> flights, most first
    spreads: tuple[Spread, ...]
    worst: tuple[dict[str, Any], ...]  # rows, worst first

    def as_dict(self) -> dict[str, Any]:
        """For JSON; NaN becomes None."""
        return _plain(asdict(self))


def summary_of(table: "pa.Table") -> Summary:
    """Summary of a table of flights."""
    outcomes = np.array(table.column("outcome").to_pylist(), dtype=object)
    reasons = table.column("why").to_pylist()
    counts: dict[str, int] = {}
    for outcome, reason in zip(outcomes, reasons, strict=True):
        text = f"{outcome}: {reason}"
        counts[text] = counts.get(text, 0) + 1
    total = table.num_rows
    shares = {end.value: share_of(int(np.sum(outcomes == end.value)), total) for end in Ending}
    return Summary(
        flights=total,
        docked=shares[Ending.DOCKED.value],
        outcomes=shares,
        reasons=dict(sorted(counts.items(), key=lambda item: (-item[1], item[0]))),
        spreads=tuple(_spread(table, name) for name in FIGURES),
        worst=tuple(worst_of(table)),
    )


def worst_of(table: "pa.Table", most: int = WORST) -> list[dict[str, Any]]:
    """The worst flights that did not dock: by how they ended, then the farther away the worse."""
    kept = ["number", "seed", "outcome", "reason", "current_mps", "current_relative_deg", "duration_s",
            "end_range_m", "end_heading_deg", "end_speed_mps", "closest_m"]  # fmt: skip
    rows = [row for row in table.select(kept).to_pylist() if row["outcome"] != "docked"]
    rows.sort(key=lambda row: (SEVERITY.index(row["outcome"]), -row["end_range_m"], row["number"]))
    return rows[:most]


def _spread(table: "pa.Table", name: str) -> Spread:
    values = np.abs(np.array(table.column(name).to_pylist(), float))
    values = values[np.isfinite(values)]
    if not len(values):
        return Spread(name, 0, float("nan"), float("nan"), float("nan"))
    return Spread(
        name, len(values), float(np.median(values)), float(np.percentile(values, 95)), float(values.max())
    )


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value
