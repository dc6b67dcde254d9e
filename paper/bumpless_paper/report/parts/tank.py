"""The tank study: three scenarios with noise, dropouts and weak actuators, in the format of tables A5, A6.

Source: Gao et al. 2026, section 4.3, tables A5 and A6; `study.tank` says how the figures are taken.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bumpless.config.mission import shipped_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import HOVER
from bumpless.sim.twin import Result, simulate
from bumpless_paper.report.content import Comparison, Figure, Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.flights import command_figure, pose_figure, track_figure, wrench_figure
from bumpless_paper.report.published import published
from bumpless_paper.study.tank import (
    GOALS,
    MISSIONS,
    about_mean,
    about_reference,
    hover_row,
    per_mode,
    samples,
    segments,
)
from bumpless_paper.study.tank_alternatives import ALTERNATIVES, FIGURES, changes, hover_figures

Array = NDArray[np.float64]
SEEDS = tuple(range(1, 21))
FEW = SEEDS[:5]  # of each alternative


def part(progress: Progress) -> Part:
    """Fly the three scenarios with twenty seeds each, and with five each choice made otherwise."""
    vehicle = load_vehicle("ts100")
    missions = {label: shipped_mission(name) for label, name in MISSIONS.items()}
    runs: dict[str, list[Result]] = {}
    for k, (label, mission) in enumerate(missions.items()):
        runs[label] = [simulate(mission, vehicle, seed=seed) for seed in SEEDS]
        progress((k + 1) / 8)
    printed = published()
    a5 = {label: np.array([hover_row(run) for run in flown]) for label, flown in runs.items()}
    rows: dict[str, Any] = {
        label: (printed["tableA5_tank"][label], *_mean_and_spread(values)) for label, values in a5.items()
    }
    modes: dict[str, Any] = {}
    for label, flown in runs.items():
        for row in printed["tableA6_tank"][label]:
            ours = [per_mode(run)[row[0]] for run in flown if row[0] in per_mode(run)]
            modes[f"{label} {row[0]}"] = (row[1:], *_mean_and_spread(np.array(ours)))
    kept = {label: np.mean([about_reference(run) for run in flown], axis=0) for label, flown in runs.items()}
    first = {f"{label}: {missions[label].title}": flown[0] for label, flown in runs.items()}
    goals = {
        name: {
            "S1_to_S2": float(a5["S2"][:, k].mean() / a5["S1"][:, k].mean() - 1.0),
            "S1_to_S3": float(a5["S3"][:, k].mean() / a5["S1"][:, k].mean() - 1.0),
            "met": bool(a5["S3"][:, k].mean() < a5["S1"][:, k].mean()),
            "seeds_better": float(np.mean(a5["S3"][:, k] < a5["S1"][:, k])),
        }
        for name, k in GOALS.items()
    }
    otherwise: list[list[str]] = []
    for k, alternative in enumerate(ALTERNATIVES):
        found = changes(hover_figures(alternative, missions, vehicle, FEW))
        otherwise.append([alternative.name, *(_both(found[figure]) for figure in FIGURES)])
        progress(0.4 + 0.6 * (k + 1) / len(ALTERNATIVES))
    tables = [
        Comparison(
            "tableA5",
            "Table A5: hover and the switching windows",
            f"Mean and standard deviation over {len(SEEDS)} seeds. 1 Hz samples, RMS about the mean, largest "
            "adjacent step within ±2 s of a switch; depth is the navigation's, free of the cell's own noise. "
            "The paper ran each scenario once.",
            printed["tableA5_tank"]["columns"],
            rows,
        ),
        Comparison(
            "tableA6",
            "Table A6: every mode",
            "As above. The paper's tracks and durations are unknown; ours are in the mission files.",
            printed["tableA6_tank"]["columns"][1:],
            modes,
        ),
        Grid(
            "tank_about_reference",
            "Hover about its reference instead of its mean",
            f"RMS about the mean forgives a steady error; this does not. True state, every cycle, "
            f"{len(SEEDS)} seeds.",
            ["scenario", "depth (m)", "roll (°)", "pitch (°)", "yaw (°)"],
            [[label, *(float(v) for v in values)] for label, values in kept.items()],
        ),
        _goal_table(a5),
        Grid(
            "tank_alternatives",
            "Each choice made otherwise",
            f"Change of the hover RMS against S1, S2 and S3, {len(FEW)} seeds; in every row all three "
            "scenarios fly one mission with one set of gains. First come the design's choices.",
            ["", "depth", "roll", "pitch", "yaw", "yaw about its reference"],
            otherwise,
        ),
    ]
    return Part(
        "tank",
        "Tank study (tables A5 and A6)",
        "A 60 m by 100 m basin, twice the vehicle's sensor noise, 30 % of the camera's frames lost, worn "
        "thrusters. S1: PID channels drive their own actuators and the propeller stops on detection; S2: "
        "allocation, modes change at once; S3: allocation, bumpless. Plant, gains and mission are the same "
        "in all three; the paper's own path, gains and disturbances are not printed, so only the relations "
        "between the scenarios compare.",
        tables,
        _figures(first),
        notes=[_by_the_cell(runs)],
        numbers={"goals": goals, "about_reference": {k: v.tolist() for k, v in kept.items()}},
        hashes={f"mission {m.name}": m.sha256 for m in missions.values()} | {"vehicle ts100": vehicle.sha256},
    )


def _mean_and_spread(values: Array) -> tuple[list[float], list[float]]:
    return values.mean(axis=0).tolist(), values.std(axis=0).tolist()


def _by_the_cell(runs: dict[str, list[Result]]) -> str:
    """What the depth goal would be with the depth cell's own noise in it."""
    rows = {
        s: [about_mean(segments(samples(run))[HOVER]["depth"]) for run in flown] for s, flown in runs.items()
    }
    change = {label: float(np.mean(values) / np.mean(rows["S1"]) - 1.0) for label, values in rows.items()}
    return (
        f"Taken from the depth cell itself, its noise included, hover depth RMS changes by {_both(change)}."
    )


def _both(change: dict[str, float]) -> str:
    return f"{_percent(change['S2'])} / {_percent(change['S3'])}"


def _percent(change: float) -> str:
    return f"{100 * change:+.0f} %".replace("-", "−")


def _goal_table(a5: dict[str, Array]) -> Grid:
    printed, rows = published()["tableA5_tank"], []
    for k, name in enumerate(printed["columns"]):
        one, two, three = (float(a5[label][:, k].mean()) for label in ("S1", "S2", "S3"))
        paper = [printed[label][k] for label in ("S1", "S2", "S3")]
        rows.append(
            [name, *(_change(paper[0], p) for p in paper[1:]), _change(one, two), _change(one, three)]
        )
    return Grid(
        "tank_reductions",
        "Change against S1",
        "Negative is better but for mean speed and steps, which are what they are.",
        ["", "paper S2", "paper S3", "ours S2", "ours S3"],
        rows,
    )


def _change(base: float, value: float) -> str:
    return _percent(value / base - 1) if base else "–"


def _figures(runs: dict[str, Result]) -> list[Figure]:
    last = list(runs.values())[-1]
    return [
        track_figure("tank_track", "Tracks in the basin", "Figures 20 and 21 of the paper.", runs),
        pose_figure("tank_pose", "Depth and attitude", "Figure 22. Shaded: the modes of S3.", runs),
        command_figure("tank_thrusters", "Thrusters", "Figure 23.", runs, "thruster"),
        command_figure("tank_fins", "Rudders", "Figure 24.", runs, "fin"),
        wrench_figure("tank_wrench", "Wrench of S3", "Figures 25 to 27, all actuators together.", last),
    ]
