"""Runs beside each other: their figures against the first one's, and what they were flown with."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from bumpless.review.figures import FIGURES, Figure
from bumpless.review.subject import Subject

MOST = 6
FEW_CYCLES = 10  # missing cycles that make no figure another one
AT_THE_END = ("end.position_m", "end.heading_deg", "missing_cycles")  # whatever is missing before
Change = Literal["better", "worse", "same", ""]


@dataclass(frozen=True)
class FigureRow:
    """One figure of every run; `changes` against the first, "" where none can be told."""

    figure: Figure
    values: tuple[float | None, ...]
    changes: tuple[Change, ...]


@dataclass(frozen=True)
class SettingRow:
    """One entry of missions, parameters or software that is not the same in all runs."""

    kind: Literal["mission", "parameters", "software"]
    name: str  # dotted path
    values: tuple[str, ...]  # "–" where a run has none


@dataclass(frozen=True)
class Comparison:
    """Figures that at least one run has, and all differences of what was flown."""

    subjects: tuple[Subject, ...]
    figures: tuple[FigureRow, ...]
    settings: tuple[SettingRow, ...]


def compare(subjects: Sequence[Subject]) -> Comparison:
    """Compare two to six runs. Raises ValueError for another number of them."""
    if not 2 <= len(subjects) <= MOST:
        raise ValueError(f"two to {MOST} runs can be compared, not {len(subjects)}")
    rows = (_row(figure, subjects) for figure in FIGURES.values())
    return Comparison(
        tuple(subjects),
        tuple(row for row in rows if any(value is not None for value in row.values)),
        tuple(_settings(subjects)),
    )


def change_of(figure: Figure, base: float | None, value: float | None) -> Change:
    """Whether `value` is better than `base`, as far as the figure's decimals show."""
    if base is None or value is None:
        return ""
    if round(base, figure.decimals) == round(value, figure.decimals):
        return "same"
    if not figure.better:
        return ""
    return "better" if (value < base) == (figure.better == "less") else "worse"


def _row(figure: Figure, subjects: Sequence[Subject]) -> FigureRow:
    values = tuple(figure.of(subject.metrics) for subject in subjects)
    changes: list[Change] = [""]
    for value, subject in zip(values[1:], subjects[1:], strict=True):
        fair = figure.key in AT_THE_END or not (_lost(subject) or _lost(subjects[0]))
        changes.append(change_of(figure, values[0], value) if fair else "")
    return FigureRow(figure, values, tuple(changes))


def _lost(subject: Subject) -> bool:
    """Whether a part of the flight was not recorded: sums and extremes of the rest are no better for it."""
    return (subject.metrics.get("missing_cycles") or 0) > FEW_CYCLES


def _settings(subjects: Sequence[Subject]) -> Iterator[SettingRow]:
    yield from _differing("mission", [dict(_flat(s.mission)) for s in subjects])
    yield from _differing("parameters", [dict(_flat(s.parameters)) for s in subjects])
    names = ("mission", "vehicle", "vehicle_sha256", "seed", "software_version", "recorder_version")
    yield from _differing("software", [{n: str(getattr(s.info, n)) for n in names} for s in subjects])


def _differing(
    kind: Literal["mission", "parameters", "software"], tables: list[dict[str, str]]
) -> Iterator[SettingRow]:
    for name in dict.fromkeys(name for table in tables for name in table):
        values = tuple(table.get(name, "–") for table in tables)
        if len(set(values)) > 1:
            yield SettingRow(kind, name, values)


def _flat(value: Any, path: str = "") -> Iterator[tuple[str, str]]:
    """Every leaf of a mission or of parameters by its dotted path."""
    if isinstance(value, Mapping):
        for key, item in value.items():
            yield from _flat(item, f"{path}.{key}" if path else str(key))
    elif isinstance(value, list) and any(isinstance(item, Mapping | list) for item in value):
        for index, item in enumerate(value):
            yield from _flat(item, f"{path}[{index}]")
    else:
        yield path, _text(value)


def _text(value: Any) -> str:
    """A leaf; 90 and 90.0 are the same number."""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str([_Plain(_text(item)) for item in value]) if isinstance(value, list) else str(value)


class _Plain(str):
    """Stands in a list without quotes."""

    def __repr__(self) -> str:
        return str(self)
