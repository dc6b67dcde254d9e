"""What a report consists of: parts with tables and figures, still without any looks."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Series:
    """One curve. colour: index into the palette; style: line, dash, dots or steps."""

    name: str
    x: Array
    y: Array
    colour: int = 0
    style: str = "line"


@dataclass(frozen=True)
class Panel:
    """One pair of axes. spans: (from, to, mode index) of shaded modes on x; equal: one scale on both axes."""

    x_label: str
    y_label: str
    series: Sequence[Series]
    spans: Sequence[tuple[float, float, int]] = ()
    marks: Sequence[tuple[float, str]] = ()  # vertical lines at x, with a word
    equal: bool = False
    log_x: bool = False
    log_y: bool = False


@dataclass(frozen=True)
class Solid:
    """A convex body drawn in space: vertices (n, 3), faces (m, 3), axis names with units."""

    name: str
    vertices: Array
    faces: NDArray[np.int64]
    axes: tuple[str, str, str]
    inner: Array | None = None  # vertices of a second body inside, drawn as its outline's points


@dataclass(frozen=True)
class Figure:
    """Panels or solids side by side, with one CSV."""

    id: str
    title: str
    caption: str
    panels: Sequence[Panel | Solid]
    columns: int = 1


@dataclass(frozen=True)
class Comparison:
    """A published table beside ours: each cell is paper, ours (mean), spread, relative change.

    rows: label -> (paper, ours, spread); None where there is no number.
    """

    id: str
    title: str
    caption: str
    columns: Sequence[str]
    rows: dict[str, tuple[Sequence[float | None], Sequence[float | None], Sequence[float | None] | None]]

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        rows = {
            label: {
                "paper": _plain(paper),
                "ours": _plain(ours),
                **({} if spread is None else {"spread": _plain(spread)}),
                "change": [relative_change(p, o) for p, o in zip(paper, ours, strict=True)],
            }
            for label, (paper, ours, spread) in self.rows.items()
        }
        return {"columns": list(self.columns), "rows": rows}


@dataclass(frozen=True)
class Grid:
    """A plain table; numbers are formatted, texts shown as they are."""

    id: str
    title: str
    caption: str
    columns: Sequence[str]
    rows: Sequence[Sequence[Any]]

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return {"columns": list(self.columns), "rows": [_plain(row) for row in self.rows]}


@dataclass(frozen=True)
class Part:
    """One chapter. numbers: what machines read beside the tables; hashes: name -> SHA-256 of its inputs."""

    id: str
    title: str
    text: str
    tables: Sequence[Comparison | Grid] = ()
    figures: Sequence[Figure] = ()
    notes: Sequence[str] = ()
    numbers: dict[str, Any] = field(default_factory=dict)
    hashes: dict[str, str] = field(default_factory=dict)

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return {
            "title": self.title,
            "tables": {table.id: table.as_dict() for table in self.tables},
            "numbers": plain(self.numbers),
            "notes": list(self.notes),
            "hashes": self.hashes,
        }


def relative_change(paper: float | None, ours: float | None) -> float | None:
    """(ours - paper) / |paper|; None when there is nothing to compare."""
    if paper is None or ours is None or paper == 0 or not math.isfinite(ours):
        return None
    return rounded((ours - paper) / abs(paper))


def rounded(value: float, digits: int = 6) -> float:
    """To significant digits, so that files do not differ in their last bits."""
    return float(f"{value:.{digits}g}")


def plain(value: Any) -> Any:
    """Plain Python of nested NumPy values; not-a-number becomes None, numbers are rounded."""
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, bool | np.bool_):
        return bool(value)
    if isinstance(value, int | np.integer):
        return int(value)
    if isinstance(value, float | np.floating):
        return rounded(float(value)) if math.isfinite(value) else None
    return value


def _plain(row: Sequence[Any]) -> list[Any]:
    return [plain(item) for item in row]
