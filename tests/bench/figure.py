"""One measured figure: a median over rounds with its spread, a goal, and whether it is met."""

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np


@dataclass(frozen=True)
class Figure:
    """A row of the table. `ratio` rows are compared with the committed figures, the others are shown only."""

    key: str
    title: str
    value: float
    low: float
    high: float
    unit: str
    goal: str = ""
    met: bool | None = None
    ratio: bool = False
    better: str = "higher"

    def reached(self, value: float) -> bool:
        """Whether `value` would meet this figure's goal; a figure without one is content with any."""
        if not self.goal:
            return True
        sign, limit = self.goal.split()
        return {"≥": value >= float(limit), "≤": value <= float(limit), "<": value < float(limit)}[sign]

    def as_json(self) -> dict:
        """Plain values for the file of figures."""
        return asdict(self)


def short(value: float) -> str:
    """Three significant digits."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def figure(
    key: str,
    title: str,
    values: Sequence[float] | np.ndarray,
    unit: str,
    at_least: float | None = None,
    at_most: float | None = None,
    below: float | None = None,
    ratio: bool = False,
    better: str | None = None,
) -> Figure:
    """Median and quartiles of `values`; the goal, if there is one, is tested on the median."""
    low, value, high = (float(v) for v in np.percentile(np.asarray(values, float), [25, 50, 75]))
    limits = {"≥": at_least, "≤": at_most, "<": below}
    goal = next((f"{sign} {limit:g}" for sign, limit in limits.items() if limit is not None), "")
    better = better or ("higher" if at_least is not None else "lower")
    made = Figure(key, title, value, low, high, unit, goal, None, ratio, better)
    return replace(made, met=made.reached(value)) if goal else made


def cpu_seconds(work: Callable[[], object]) -> float:
    """CPU time of this thread for one call: the wall clock also measures the machine's other work."""
    begin = time.thread_time_ns()
    work()
    return (time.thread_time_ns() - begin) * 1e-9


def interleaved(works: Mapping[str, Callable[[], object]], rounds: int) -> dict[str, np.ndarray]:
    """CPU seconds (rounds,) of each, taken in turns, so that a slow minute is slow for all of them."""
    taken: dict[str, list[float]] = {name: [] for name in works}
    for work in works.values():
        work()
    for _ in range(rounds):
        for name, work in works.items():
            taken[name].append(cpu_seconds(work))
    return {name: np.array(values) for name, values in taken.items()}
