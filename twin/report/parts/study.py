"""Tables 6, 7 and 8, the figures of the six scenarios, ablation, and the goals on many plants.

Source: Gao et al. 2026, section 4.2, figures 11 to 18, tables 6 to 8.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from twin.records import FIN, THRUSTER
from twin.report.content import Comparison, Figure, Grid, Part
from twin.report.parts import Progress
from twin.report.parts.flights import (
    command_figure,
    pose_figure,
    runtime_figure,
    track_figure,
    wrench_figure,
)
from twin.report.ticks import number, percent
from twin.study.ablation import (
    BUMPLESS_FIGURES,
    FAULT_FIGURES,
    Variation,
    ablation,
    bumpless_variations,
    fault_variations,
)
from twin.study.fly import Job, fly, scenario_named
from twin.study.scenarios import mission_of
from twin.study.tables import table6, table7, table8
from twin.vehicle import load_vehicle

SEEDS = (1, 2, 3, 4, 5)
NO_FAULT, FAULT = ("S1", "S2", "S3", "S4"), ("S5", "S6")


def counted(progress: Progress, start: float, end: float) -> Any:
    """A callback (done, total) that moves `progress` from start to end."""
    return lambda done, total: progress(start + (end - start) * done / max(total, 1))


@dataclass(frozen=True)
class Study:
    """One of the paper's two tables of scenarios, and what is flown beside it."""

    id: str
    title: str
    text: str
    scenarios: Sequence[str]
    table: Callable[..., dict[str, Any]]
    ablation: tuple[str, str, Sequence[Variation], Sequence[str]]  # id, title, rows, columns
    figures: tuple[str, str]  # id, numbers in the paper


def table6_part(progress: Progress) -> Part:
    """No fault: S1 to S4."""
    return _part(
        Study(
            "table6",
            "Switching without a fault (Table 6)",
            "S1: PID channels drive their own actuators; S2: weighted pseudo-inverse, clipped; S3: "
            "constrained allocation, hard switching; S4: the same, bumpless. One plant, one mission, "
            "one set of gains.",
            NO_FAULT,
            table6,
            (
                "ablation_bumpless",
                "Each bumpless mechanism by itself",
                bumpless_variations(),
                BUMPLESS_FIGURES,
            ),
            ("s1_s4", "Figures 11 to 14"),
        ),
        progress,
    )


def table7_part(progress: Progress) -> Part:
    """Propeller fault: S5 and S6."""
    return _part(
        Study(
            "table7",
            "Fault of the main propeller (Table 7)",
            "At 45 s the propeller loses 60 % of its thrust over 2 s. S5 goes on with the nominal map; S6 "
            "allocates with the degraded map, softened constraints and priorities. tau_c is the plant's true "
            "wrench, so that S5's ignorance counts.",
            FAULT,
            table7,
            (
                "ablation_fault",
                "Each part of the fault tolerance by itself",
                fault_variations(),
                FAULT_FIGURES,
            ),
            ("s5_s6", "Figures 15 to 17"),
        ),
        progress,
    )


def _part(study: Study, progress: Progress) -> Part:
    table = study.table(SEEDS, counted(progress, 0.0, 0.6))
    id, title, variations, columns = study.ablation
    rows = ablation(variations, columns, SEEDS, progress=counted(progress, 0.6, 0.9))
    runs = {name: fly(Job(name)) for name in study.scenarios}
    progress(1.0)
    return Part(
        study.id,
        study.title,
        study.text,
        [
            _comparison(study.id, table, study.scenarios),
            _changes(f"{study.id}_changes", table, study.scenarios),
            _readings(f"{study.id}_readings", table),
            _ablation(id, title, rows, columns),
        ],
        _scenario_figures(*study.figures, runs),
        notes=_definitions(table),
        numbers={"changes": _change_numbers(table)},
        hashes=study_hashes(study.scenarios),
    )


def study_hashes(names: Sequence[str]) -> dict[str, str]:
    """SHA-256 of the vehicle and of the scenarios' missions."""
    missions = [mission_of(scenario_named(name)) for name in names]
    return {
        "vehicle ts100": load_vehicle("ts100").sha256,
        **{f"mission {m.name}": m.sha256 for m in missions},
    }


def table8_part(progress: Progress) -> Part:
    """Runtime of the allocator."""
    table = table8(SEEDS, counted(progress, 0.0, 0.8))
    runs = {name: fly(Job(name)) for name in (*NO_FAULT, *FAULT)}
    progress(1.0)
    figure = runtime_figure(
        "fig18_runtime", "Figure 18: runtime distribution", "In a whole run, on this machine.", runs
    )
    return Part(
        "table8",
        "Runtime of the allocator (Table 8)",
        "Measured inside the compiled cycle, in a hot loop and on this machine: other machines give other "
        "numbers, and calls paced by a clock meet cold caches.",
        [_comparison("table8", table, (*NO_FAULT, *FAULT))],
        [figure],
        hashes=study_hashes((*NO_FAULT, *FAULT)),
    )


def _comparison(id: str, table: dict[str, Any], names: Sequence[str]) -> Comparison:
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


def _changes(id: str, table: dict[str, Any], names: Sequence[str]) -> Grid:
    rows = []
    for name in names:
        for column in table["columns"]:
            cell = table["rows"][name][column["name"]]
            if cell.get("change") is not None:
                low, high = cell["change_spread"]
                rows.append(
                    [
                        f"{cell['reference']}→{name} {column['name']}",
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


def _change_numbers(table: dict[str, Any]) -> dict[str, Any]:
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


def _readings(id: str, table: dict[str, Any]) -> Grid:
    rows = []
    for name, row in table["rows"].items():
        for column in table["columns"]:
            cell = row[column["name"]]
            for reading, value in {column["figure"]: cell, **cell["other"]}.items():
                if value["ours"] is not None and (cell["other"] or name not in (*NO_FAULT, *FAULT)):
                    rows.append([name, column["name"], reading, value["ours"], _range(value["spread"])])
    return Grid(
        id,
        "The same under other definitions, and other baselines",
        "What the paper leaves open decides some figures: tau_c by the allocator's model, d_u in thrust or "
        "in mixed degrees and rpm, peak instead of RMS deviation; other mappings of S1 and integrals of S3.",
        ["scenario", "column", "definition", "ours", "range over seeds"],
        rows,
    )


def _range(spread: Sequence[float] | None) -> str:
    return "–" if spread is None else f"{number(spread[0], 3)} … {number(spread[1], 3)}"


def _definitions(table: dict[str, Any]) -> list[str]:
    return [f"{c['name']}: {c['definition']}" for c in table["columns"]]


def _ablation(id: str, title: str, rows: list[dict[str, Any]], figures: Sequence[str]) -> Grid:
    return Grid(
        id,
        title,
        "Median of five seeds on the nominal plant.",
        ["", *figures],
        [[row["name"], *(row["figures"][key]["ours"] for key in figures)] for row in rows],
    )


def _scenario_figures(id: str, paper: str, runs: dict[str, Any]) -> list[Figure]:
    last = list(runs.values())[-1]
    name = list(runs)[-1]
    return [
        track_figure(f"{id}_track", f"{paper}: tracks", "Seed 1. Shaded: modes of the first.", runs),
        pose_figure(f"{id}_pose", "Depth and attitude", f"Shaded: modes of {name}.", runs),
        command_figure(f"{id}_thrusters", "Thrusters", "", runs, THRUSTER),
        command_figure(f"{id}_fins", "Rudders", "", runs, FIN),
        wrench_figure(
            f"{id}_wrench", f"Wrench of {name}", "Demanded, and what the plant's actuators do.", last
        ),
    ]
