"""Read tables of a vehicle file into frozen dataclasses, collecting every broken rule.

A dataclass field says by `number`, `vector`, `choice`, ... what the file may hold; `read` checks a whole
table and names what is missing, unknown or out of range. Nothing is silently converted or dropped.
"""

import math
from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, field, fields
from typing import Any, TypeVar

from bumpless.config.problems import Problem

T = TypeVar("T")
Check = Callable[[Any], tuple[Any, str | None]]  # value as found -> (value to keep, broken rule or None)


@dataclass
class Collector:
    """The problems of one source, in the order in which they are found."""

    file: str
    lines: dict[str, int]  # path -> line where it is set
    problems: list[Problem]

    def add(self, path: str, value: Any, rule: str) -> None:
        """Note that `path` holds `value`, against `rule`."""
        line = self.lines.get(path)
        self.problems.append(Problem(self.file, line, None, path, value, rule))


def number(
    above: float | None = None,
    low: float | None = None,
    high: float | None = None,
    default: Any = MISSING,
) -> Any:
    """A finite number: > above, >= low, <= high where given."""

    def check(value: Any) -> tuple[Any, str | None]:
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            return None, "must be a finite number"
        if above is not None and not value > above:
            return None, f"must be > {above:g}"
        if low is not None and not value >= low:
            return None, f"must be >= {low:g}"
        if high is not None and not value <= high:
            return None, f"must be <= {high:g}"
        return float(value), None

    return _field(check, default)


def vector(length: int, low: float | None = None, default: Any = MISSING) -> Any:
    """A list of `length` finite numbers, each >= low where given; kept as a tuple."""

    def check(value: Any) -> tuple[Any, str | None]:
        rule = f"must be {length} finite numbers"
        if not isinstance(value, list) or len(value) != length:
            return None, rule
        if any(isinstance(x, bool) or not isinstance(x, (int, float)) or not math.isfinite(x) for x in value):
            return None, rule
        if low is not None and min(value) < low:
            return None, f"must be {length} numbers >= {low:g}"
        return tuple(float(x) for x in value), None

    return _field(check, default)


def text(default: Any = MISSING) -> Any:
    """A string that is not empty."""
    return _field(lambda v: (v, None) if isinstance(v, str) and v else (None, "must be text"), default)


def choice(*options: str, default: Any = MISSING) -> Any:
    """One of the given words."""
    rule = "must be one of " + ", ".join(options)
    return _field(lambda v: (v, None) if isinstance(v, str) and v in options else (None, rule), default)


def some_of(*options: str) -> Any:
    """A list of different words out of the options, at least one; kept as a tuple."""
    rule = "must list some of " + ", ".join(options) + ", each once"

    def check(value: Any) -> tuple[Any, str | None]:
        good = isinstance(value, list) and value and all(v in options for v in value)
        return (tuple(value), None) if good and len(set(value)) == len(value) else (None, rule)

    return _field(check, MISSING)


def _field(check: Check, default: Any) -> Any:
    return field(default=default, metadata={"check": check})


def read(kind: type[T], table: Any, path: str, found: Collector) -> T | None:
    """An instance of dataclass `kind` from a table of the file, or None when problems were added."""
    if not isinstance(table, dict):
        found.add(
            path, None if table is None else table, "must be a table" if table is not None else "is missing"
        )
        return None
    before = len(found.problems)
    prefix = path + "." if path else ""
    known = {f.name: f for f in fields(kind) if "check" in f.metadata}  # type: ignore[arg-type]
    for name in table:
        if name not in known:
            found.add(prefix + name, table[name], "is not a known field; known are " + ", ".join(known))
    values = {name: _value(f, table, prefix, found) for name, f in known.items()}
    return kind(**values) if len(found.problems) == before else None


def _value(f: "Field[Any]", table: dict[str, Any], prefix: str, found: Collector) -> Any:
    if f.name not in table:
        if f.default is MISSING:
            found.add(prefix + f.name, None, "is missing")
        return f.default
    value, rule = f.metadata["check"](table[f.name])
    if rule:
        found.add(prefix + f.name, table[f.name], rule)
    return value
