"""Tables 6, 7 and 8, the figures of the six scenarios, ablation, and the goals on many plants.

Source: Gao et al. 2026, section 4.2, figures 11 to 18, tables 6 to 8.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from bumpless.config.vehicle import load_vehicle
from bumpless_paper.report.content import Figure, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.flights import (
    command_figure,
    pose_figure,
    runtime_figure,
    track_figure,
    wrench_figure,
)
from bumpless_paper.report.parts.study_tables import (
    change_numbers,
    changes,
    comparison,
    definitions,
    mechanisms,
    readings,
)
from bumpless_paper.study.ablation import (
    BUMPLESS_FIGURES,
    FAULT_FIGURES,
    Variation,
    ablation,
    bumpless_variations,
    fault_variations,
)
from bumpless_paper.study.fly import Job, fly, scenario_named
from bumpless_paper.study.scenarios import mission_of
from bumpless_paper.study.tables import table6, table7, table8

SEEDS = (1, 2, 3, 4, 5)
RUNTIME = (
    "In one whole run of each scenario, wall time on this machine: whatever else it does shows in the last "
    "tenths of a percent."
)
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
    notes: Sequence[str] = ()


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
            [
                "The paper's r_sat near 1 says that in nearly every cycle some command rests at a bound; on "
                "our nominal plant hardly any does, so that column is shown and is no target.",
                "Differences of size against the paper come from plant, gains and path, which it does not "
                "print; the relations between the scenarios are what can be compared.",
            ],
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
            comparison(study.id, table, study.scenarios),
            changes(f"{study.id}_changes", table, study.scenarios),
            readings(f"{study.id}_readings", table),
            mechanisms(id, title, rows, columns),
        ],
        _scenario_figures(*study.figures, runs),
        notes=[*definitions(table), *study.notes],
        numbers={"changes": change_numbers(table)},
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
    figure = runtime_figure("fig18_runtime", "Figure 18: runtime distribution", RUNTIME, runs)
    return Part(
        "table8",
        "Runtime of the allocator (Table 8)",
        "Measured inside the compiled cycle, in a hot loop and on this machine: other machines give other "
        "numbers, and calls paced by a clock meet cold caches.",
        [comparison("table8", table, (*NO_FAULT, *FAULT))],
        [figure],
        hashes=study_hashes((*NO_FAULT, *FAULT)),
    )


def _scenario_figures(id: str, paper: str, runs: dict[str, Any]) -> list[Figure]:
    last = list(runs.values())[-1]
    name = list(runs)[-1]
    return [
        track_figure(
            f"{id}_track",
            f"{paper}: tracks",
            f"Nominal plant, seed 1, as in all figures of this part. Shaded: modes of {next(iter(runs))}; "
            "each scenario switches at its own time.",
            runs,
        ),
        pose_figure(f"{id}_pose", "Depth and attitude", f"True state. Shaded: modes of {name}.", runs),
        command_figure(
            f"{id}_thrusters", "Thrusters", f"Commands. Shaded: modes of {name}.", runs, "thruster"
        ),
        command_figure(f"{id}_fins", "Rudders", f"Commands. Shaded: modes of {name}.", runs, "fin"),
        wrench_figure(
            f"{id}_wrench",
            f"Wrench of {name}",
            "Demanded tau_d, and what the plant's actuators do, tau.",
            last,
        ),
    ]
