"""What is wrong with a file or a setting: where it stands, what it says and the rule it breaks."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Problem:
    """One broken rule.

    `str()` gives one line for people:
    `ts100.toml: thrusters[1].thrust_max_n = -0.5; must be > 0`, or with a known place
    `docking.yaml:12:5: legs[0].speed_mps = 9; must be <= 2`.
    """

    file: str  # name of the file or other source; "" when there is none
    line: int | None  # 1-based; None or 0 when not known
    column: int | None  # 1-based; None or 0 when not known
    field: str  # path inside the file, such as "actuators[2].shaft_speed_max_rpm"; "" for the whole file
    value: Any  # as found; None when it is missing
    rule: str  # "must be > 0"

    def __str__(self) -> str:
        place = self.file
        if self.line:
            place += f":{self.line}" + (f":{self.column}" if self.column else "")
        said = self.field
        if self.field and self.value is not None:
            said += f" = {_short(self.value)}"
        fault = f"{said}; {self.rule}" if said else self.rule
        return f"{place}: {fault}" if place else fault

    def as_dict(self) -> dict[str, Any]:
        """The same for JSON: line and column 0 when unknown, the value as text."""
        return {
            "file": self.file,
            "line": self.line or 0,
            "column": self.column or 0,
            "field": self.field,
            "value": "" if self.value is None else _short(self.value),
            "rule": self.rule,
        }


def _short(value: Any, limit: int = 60) -> str:
    text = value if isinstance(value, str) else repr(value)
    return text if len(text) <= limit else text[: limit - 1] + "…"


class ProblemsError(ValueError):
    """Refusal of an input, with every problem that was found in it."""

    problems: tuple[Problem, ...]

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.problems,)
