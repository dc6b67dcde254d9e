"""A gate for a build: what the figures of a run must keep to, from a TOML file.

outcome = ["docked"]                       # endings that pass; any when absent
[figures.d_u_rh]
max = 0.05                                 # a bound of its own
[figures."hover.depth_error_rms_m"]
worse_by = 0.01                            # than in the first run, in the figure's unit
worse_by_percent = 10                      # the larger of both counts
"""

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from bumpless.metrics import Ending
from bumpless.review.compare import Comparison
from bumpless.review.figures import FIGURES, Figure


class GateError(ValueError):
    """The file is no gate; one line for whoever wrote it."""


class Limit(BaseModel):
    """What one figure must keep to."""

    model_config = ConfigDict(extra="forbid")

    min: float | None = None
    max: float | None = None
    worse_by: float | None = Field(None, ge=0.0)
    worse_by_percent: float | None = Field(None, ge=0.0)


class Gate(BaseModel):
    """What every run after the first must keep to."""

    model_config = ConfigDict(extra="forbid")

    outcome: list[Ending] = []
    figures: dict[str, Limit] = {}


@dataclass(frozen=True)
class Verdict:
    """One rule on one run."""

    run: str
    rule: str
    passed: bool


def read_gate(path: Path) -> Gate:
    """Read a gate. Raises GateError, also for a figure that there is none of."""
    try:
        gate = Gate.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise GateError(f"{path}: {error}") from error
    except ValidationError as error:
        fault = error.errors()[0]
        raise GateError(f"{path}: {'.'.join(map(str, fault['loc']))}: {fault['msg']}") from error
    for key, limit in gate.figures.items():
        if key not in FIGURES:
            raise GateError(f"{path}: there is no figure {key!r}")
        if (limit.worse_by, limit.worse_by_percent) != (None, None) and not FIGURES[key].better:
            raise GateError(f"{path}: neither more nor less of {key!r} is worse; give it min or max")
    return gate


def judge(gate: Gate, comparison: Comparison) -> list[Verdict]:
    """Every rule on every run but the first, which is what they are compared with."""
    verdicts = []
    rows = {row.figure.key: row for row in comparison.figures}
    for index, subject in enumerate(comparison.subjects[1:], start=1):
        name = subject.info.id
        if gate.outcome:
            words = " or ".join(ending.words for ending in gate.outcome)
            rule = f"outcome {subject.outcome.replace('_', ' ') or 'unknown'}, must be {words}"
            verdicts.append(Verdict(name, rule, subject.outcome in gate.outcome))
        for key, limit in gate.figures.items():
            row = rows.get(key)
            base, value = (row.values[0], row.values[index]) if row else (None, None)
            verdicts += [Verdict(name, rule, ok) for rule, ok in _rules(FIGURES[key], limit, base, value)]
    return verdicts


def _rules(
    figure: Figure, limit: Limit, base: float | None, value: float | None
) -> Iterator[tuple[str, bool]]:
    """A figure that a run lacks passes no rule."""
    shown = "none" if value is None else f"{value:.{figure.decimals}f}"
    told = f"{figure.key} {shown}"
    if limit.max is not None:
        yield f"{told}, at most {limit.max:g}", value is not None and value <= limit.max
    if limit.min is not None:
        yield f"{told}, at least {limit.min:g}", value is not None and value >= limit.min
    if limit.worse_by is None and limit.worse_by_percent is None:
        return
    if base is None or value is None:
        yield f"{told}, to be compared with {base}", False
        return
    allowed = max(limit.worse_by or 0.0, (limit.worse_by_percent or 0.0) / 100.0 * abs(base))
    worse = value - base if figure.better == "less" else base - value
    yield f"{told}, at most {allowed:.4g} worse than {base:.{figure.decimals}f}", worse <= allowed
