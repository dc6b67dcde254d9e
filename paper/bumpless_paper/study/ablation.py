"""What each mechanism buys alone: S3 with one mechanism added, S4 with one taken away, S6 likewise.

Source: Gao et al. 2026, eq. (54)-(57) for the three published mechanisms; the others are named in
`EXTENSIONS`, which says for each what it is and how to switch it off; `extension_ablation` flies that.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from bumpless_paper.study.extensions import EXTENSIONS
from bumpless_paper.study.figures import Figures
from bumpless_paper.study.fly import Job, fly_all
from bumpless_paper.study.goals import GOALS
from bumpless_paper.study.many import fly_rows, nominal_rows, plant_rows, ratio_of, share_of
from bumpless_paper.study.plants import NOMINAL, Plant, draw
from bumpless_paper.study.readings import scenarios_of
from bumpless_paper.study.scenarios import Overrides, merged
from bumpless_paper.study.tables import SEEDS, Progress, spread_of

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
    no_gains = {name: [1.0] * 6 for name in ("fault_kp", "fault_ki", "fault_kd")}
    parts = {"degraded map": no_map, "priorities": no_priority, "slack": no_slack, "gains": no_gains}
    rows = [Variation("none (S5)", "S5", {})]
    for name in parts:
        others = merged(*({"allocation": off} for other, off in parts.items() if other != name))
        rows.append(Variation(f"{name} alone", "S6", others))
    rows += [Variation(f"all but {name}", "S6", {"allocation": off}) for name, off in parts.items()]
    return [*rows, Variation("all (S6)", "S6", {})]


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


ALL_ON, PUBLISHED = "all on", "as published (all off)"


def extension_ablation(
    n_plants: int = 60,
    seeds: Sequence[int] = SEEDS,
    progress: Progress = None,
    workers: int | None = None,
) -> list[dict[str, Any]]:
    """Every extension on, each off alone, all off: of every goal the nominal ratio and the share of plants.

    Baselines that an extension does not touch are not flown again. Rows: name, about, and for each goal
    {"ratio": median over seeds on the nominal plant, "share": of plants 0 .. n_plants - 1}.
    """
    plants, names = [draw(i) for i in range(n_plants)], scenarios_of(readings=False)
    variations: list[tuple[str, str, tuple[str, ...], Overrides]] = [(ALL_ON, "", names, {})]
    variations += [
        (e.name, e.about, tuple(name for name in names if name in e.by), e.off) for e in EXTENSIONS
    ]
    variations.append((PUBLISHED, "", names, merged(*(e.off for e in EXTENSIONS))))
    rows = [
        row
        for _, _, touched, off in variations
        for row in (*nominal_rows(touched, seeds, off), *plant_rows(plants, touched, off))
    ]
    flown = fly_rows(rows, progress, workers)
    size = len(seeds) + n_plants
    base, out = flown[:size], []
    for k, (name, about, _, _) in enumerate(variations):
        mine = [{**on, **off} for on, off in zip(base, flown[k * size : (k + 1) * size], strict=True)]
        nominal, drawn = mine[: len(seeds)], mine[len(seeds) :]
        judged = {g.name: {"ratio": ratio_of(g, nominal), "share": share_of(g, drawn)} for g in GOALS}
        out.append({"name": name, "about": about, "goals": judged})
    return out
