"""One figure of trust: what was tried, how often, what came of it, and what was promised."""

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class Figure:
    """A row of the table; `value` and `most` in `unit`, `met` when it keeps to the promise."""

    trial: str
    what: str
    value: float
    unit: str
    goal: str
    met: bool

    def row(self) -> str:
        """For a terminal."""
        return f"{self.trial:9s} {self.what:62s} {self.value:>10.4g} {self.unit:6s} {self.goal:10s} " + (
            "met" if self.met else "NOT MET"
        )

    def record(self) -> dict[str, Any]:
        """For the file of figures."""
        return asdict(self)


def at_most(trial: str, what: str, value: float, unit: str, most: float) -> Figure:
    """A figure that must not be larger than `most`."""
    return Figure(trial, what, value, unit, f"<= {most:g}", value <= most)


def exactly(trial: str, what: str, value: float, unit: str, goal: float) -> Figure:
    """A figure that must be `goal`."""
    return Figure(trial, what, value, unit, f"= {goal:g}", value == goal)


def at_least(trial: str, what: str, value: float, unit: str, least: float) -> Figure:
    """A figure that must not be less than `least`."""
    return Figure(trial, what, value, unit, f">= {least:g}", value >= least)
