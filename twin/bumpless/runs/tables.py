"""A run's numbers for other programs: chosen signals of a range, as CSV or Parquet."""

import csv
from collections.abc import Sequence
from difflib import get_close_matches
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import numpy as np

from bumpless.contract.extras import imported
from bumpless.runs.cut import Range
from bumpless.runs.run import Run
from bumpless.runs.table import Table

KEYS = ("cycle", "time_s", "time_ns")  # in every table


def chosen(run: Run, signals: Sequence[str], part: Range) -> Table:
    """Columns of `Run.table` that these names or patterns ("navigation.*") choose, all when there are none.

    Raises ValueError for a name or pattern that chooses nothing, and for a range without a cycle.
    """
    table = run.table()
    within = part.holds(table["time_s"])
    if not within.any():
        raise ValueError(f"the log has no cycle in the range {part}")
    wanted = list(KEYS)
    for signal in signals or ["*"]:
        found = [name for name in table if fnmatchcase(name, signal)]
        if not found:
            near = get_close_matches(signal, table, 1, 0.3)
            raise ValueError(f"there is no signal {signal!r}" + (f"; near it is {near[0]!r}" if near else ""))
        wanted += [name for name in found if name not in wanted]
    return {name: table[name][within] for name in wanted}


def write_csv(table: Table, path: Path) -> None:
    """One row per cycle; what was not told is left empty."""
    columns = [_texts(column) for column in table.values()]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(table)
        writer.writerows(zip(*columns, strict=True))


def _texts(column: np.ndarray) -> list[str]:
    values: list[Any] = column.tolist()
    return ["" if value != value else str(value) for value in values]


def write_parquet(table: Table, path: Path) -> None:
    """One row group. Needs the extra `data`."""
    arrow = imported("pyarrow", "data")
    parquet = imported("pyarrow.parquet", "data")
    parquet.write_table(arrow.table({name: arrow.array(column) for name, column in table.items()}), path)
