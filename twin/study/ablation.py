"""What each mechanism buys alone: S3 with one mechanism added, S4 with one taken away, S6 likewise.

Source: Gao et al. 2026, eq. (54)-(57) for the three published mechanisms; the others are named in
`EXTENSIONS`, which says for each what it is, and how to switch it off.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from twin.study.extensions import EXTENSIONS
from twin.study.figures import Figures
from twin.study.fly import Job, fly_all
from twin.study.plants import NOMINAL, Plant
from twin.study.scenarios import Overrides, merged
from twin.study.tables import SEEDS, Progress, spread_of

MECHANISMS = ("ramp", "integrator_alignment", "warm_start_projection")
_OFF: dict[str, Any] = dict.fromkeys(MECHANISMS, False) | {
    "scale_integration": False,
    "integral_at_switch": "rescale",
}
BUMPLESS_FIGURES = ("d_u_FR_bound", "d_u_RH_bound", "rms_e_tau_true", "demand_step_violations")
FAULT_FIGURES = ("rms_e_tau_post_true", "d_theta_fault_rms", "d_psi_fault_rms", "s_rms")


@dataclass(frozen=True)
class Variation:
    """One row: a scenario with changed parameters."""

    name: str
    scenario: str
    extra: Overrides


def bumpless_variations() -> list[Variation]:
    """Hard, each published mechanism alone, all but one, all."""
    rows = [Variation("none (S3)", "S3", {})]
    for name in MECHANISMS:
        rows.append(Variation(f"{name} alone", "S4", {"bumpless": _OFF | {name: True}}))
    rows += [Variation(f"all but {name}", "S4", {"bumpless": {name: False}}) for name in MECHANISMS]
    return [*rows, Variation("all (S4)", "S4", {})]


def fault_variations() -> list[Variation]:
    """Nominal, each part of the fault tolerance alone, all but one, all."""
    no_map = {"degraded_map": False}
    no_priority = {"priority": [1.0] * 6}
    no_slack = {"slack_price": [0.0] * 6}
    parts = {"degraded map": no_map, "priorities": no_priority, "slack": no_slack}
    rows = [Variation("none (S5)", "S5", {})]
    for name in parts:
        others = merged(*({"allocation": off} for other, off in parts.items() if other != name))
        rows.append(Variation(f"{name} alone", "S6", others))
    rows += [Variation(f"all but {name}", "S6", {"allocation": off}) for name, off in parts.items()]
    return [*rows, Variation("all (S6)", "S6", {})]


def extension_variations(scenarios: Sequence[str]) -> list[Variation]:
    """Each extension switched off by itself, and all of them, for the scenarios named."""
    rows = [Variation("all on", s, {}) for s in scenarios]
    for e in EXTENSIONS:
        rows += [Variation(f"without {e.name}", s, e.off) for s in scenarios]
    nothing = merged(*(e.off for e in EXTENSIONS))
    return rows + [Variation("as published", s, nothing) for s in scenarios]


def ablation(
    variations: Sequence[Variation],
    figures: Sequence[str],
    seeds: Sequence[int] = SEEDS,
    plant: Plant = NOMINAL,
    progress: Progress = None,
    workers: int = 1,
) -> list[dict[str, Any]]:
    """One row per variation: median and spread over seeds of each figure, on one plant."""
    jobs = [Job(v.scenario, seed, plant, v.extra) for v in variations for seed in seeds]
    flown: list[Figures] = fly_all(jobs, workers=workers, progress=progress)
    rows = []
    for i, v in enumerate(variations):
        mine = flown[i * len(seeds) : (i + 1) * len(seeds)]
        rows.append(
            {
                "name": v.name,
                "scenario": v.scenario,
                "figures": {key: spread_of([f[key] for f in mine]) for key in figures},
            }
        )
    return rows
