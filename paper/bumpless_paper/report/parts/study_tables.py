"""The paper's tables 6 to 8 beside ours, with other definitions, changes and ablations."""

from collections.abc import Sequence
from typing import Any

from bumpless_paper.report.content import Comparison, Grid
from bumpless_paper.report.labels import label
from bumpless_paper.report.ticks import number, percent
from bumpless_paper.study.ablation import MECHANISMS
from bumpless_paper.study.scenarios import VARIANTS


def comparison(id: str, table: dict[str, Any], names: Sequence[str]) -> Comparison:
    """The paper's table beside ours."""
    columns = [c["name"] for c in table["columns"]]
    rows: dict[str, Any] = {}
    for name in names:
        cells = [table["rows"][name][column] for column in columns]
        spread = [None if c["spread"] is None else (c["spread"][1] - c["spread"][0]) / 2 for c in cells]
        rows[name] = ([c["paper"] for c in cells], [c["ours"] for c in cells], spread)
    return Comparison(
        id,
        f"Table {table['table']}",
        f"Ours: median of {len(table['seeds'])} seeds and half their range. The vehicle is the one that "
        "Table 3 identifies; the paper prints neither hull, gains nor path.",
        [f"{c['name']} ({c['unit']})" for c in table["columns"]],
        rows,
    )


def changes(id: str, table: dict[str, Any], names: Sequence[str]) -> Grid:
    """What changes from one scenario to another, in the paper and here."""
    rows = []
    for name in names:
        for column in table["columns"]:
            cell = table["rows"][name][column["name"]]
            if cell.get("change") is not None:
                low, high = cell["change_spread"]
                rows.append(
                    [
                        f"{cell['reference']}→{name} {label(column['name'])}",
                        percent(cell["paper_change"]),
                        percent(cell["change"]),
                        f"{percent(low)} … {percent(high)}",
                    ]
                )
    return Grid(
        id,
        "Relative changes between scenarios",
        "Median over seeds, and their range.",
        ["", "paper", "ours", "range"],
        rows,
    )


def change_numbers(table: dict[str, Any]) -> dict[str, Any]:
    """The same for machines."""
    return {
        f"{cell['reference']}_to_{name}_{column['name']}": {
            "paper": cell["paper_change"],
            "ours": cell["change"],
            "range": cell["change_spread"],
        }
        for name, row in table["rows"].items()
        for column in table["columns"]
        if (cell := row[column["name"]]).get("change") is not None
    }


def readings(id: str, table: dict[str, Any]) -> Grid:
    """Each figure under every definition, one row per scenario or variant of a baseline."""
    kinds: dict[str, str] = {}
    for column in table["columns"]:
        others = table["rows"][next(iter(table["rows"]))][column["name"]]["other"]
        if others:
            told = (column["figure"], *(other for other in others if not other.endswith("_limit")))
            kinds |= dict.fromkeys(told, column["name"])
    rows = []
    for name, row in table["rows"].items():
        cells = []
        for figure, column in kinds.items():
            value = row[column] if figure not in row[column]["other"] else row[column]["other"][figure]
            cells.append(f"{number(value['ours'], 3)}\n{_range(value['spread'])}")
        rows.append([name, *cells])
    titles = [f" {name}: {row['title']}." for name, row in table["rows"].items() if name in VARIANTS]
    return Grid(
        id,
        "The same under other definitions, and other baselines",
        "Median of the seeds, and below it their range. What the paper leaves open decides some figures: "
        "tau_c by the allocator's map or as the plant's true wrench, the units of d_u, peak instead of RMS "
        f"deviation, the mapping of S1 and the integral of S3.{''.join(titles)}",
        ["", *(label(figure) for figure in kinds)],
        rows,
    )


def _range(spread: Sequence[float] | None) -> str:
    return "–" if spread is None else f"{number(spread[0], 2)} … {number(spread[1], 2)}"


def definitions(table: dict[str, Any]) -> list[str]:
    """One line per column: how the figure is defined here."""
    return [f"{label(c['name'])}: {c['definition']}." for c in table["columns"]]


def mechanisms(id: str, title: str, rows: list[dict[str, Any]], figures: Sequence[str]) -> Grid:
    """One row per variation."""
    return Grid(
        id,
        title,
        "Median of five seeds on the nominal plant.",
        ["", *(label(key) for key in figures)],
        [[_mechanism(row["name"]), *(row["figures"][key]["ours"] for key in figures)] for row in rows],
    )


def _mechanism(name: str) -> str:
    for key in MECHANISMS:
        name = name.replace(key, label(key))
    return name
