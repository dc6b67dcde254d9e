"""The tank study: three scenarios with noise, dropouts and weak actuators, in the format of tables A5, A6.

Source: Gao et al. 2026, section 4.3, tables A5 and A6. As there, figures come from samples at 1 Hz: RMS about
the segment's mean, peak-to-peak, mean speed; command RMS without removing the mean; largest step between
adjacent samples within 2 s of a switch.
"""

import itertools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from twin.records import FIN, FORWARD, HOVER, REVERSE, THRUSTER
from twin.report.content import Comparison, Figure, Grid, Part
from twin.report.parts import Progress
from twin.report.parts.flights import command_figure, pose_figure, track_figure, wrench_figure
from twin.report.parts.missions import shipped_mission
from twin.report.published import published
from twin.simulation import Result, simulate
from twin.vehicle import load_vehicle

Array = NDArray[np.float64]
RATE_HZ, WINDOW_S = 1.0, 2.0
MODES = "FRH"
SEEDS = (1, 2, 3, 4, 5)
MISSIONS = {"S1": "tank1", "S2": "tank2", "S3": "tank3"}
GOALS = ("depth_rms_m", "roll_rms_deg", "pitch_rms_deg", "yaw_rms_deg")


def samples(run: Result) -> np.ndarray:
    """LOG rows at 1 Hz."""
    return run.log[:: round(1.0 / (RATE_HZ * run.vehicle.control_period_s))]


def segments(rows: np.ndarray) -> dict[int, np.ndarray]:
    """Rows of the last stay in each mode, by mode."""
    edges = [0, *(np.flatnonzero(np.diff(rows["mode"])) + 1).tolist(), len(rows)]
    return {int(rows["mode"][a]): rows[a:b] for a, b in itertools.pairwise(edges)}


def rms(values: Array) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def about_mean(values: Array) -> float:
    """RMS about the mean."""
    return rms(values - values.mean())


def _kind(run: Result, kind: str) -> list[int]:
    return [i for i, actuator in enumerate(run.vehicle.actuators) if actuator.kind == kind]


def per_mode(run: Result) -> dict[str, list[float]]:
    """Table A6: mode -> duration, N, depth RMS and peak-to-peak, attitude RMS, speed, commands' RMS."""
    out = {}
    for mode, stay in sorted(segments(samples(run)).items()):
        angles = np.degrees(np.unwrap(stay["eta_hat"][:, 3:6], axis=0))
        fins = np.degrees(stay["u"][:, _kind(run, "fin")])
        out[MODES[mode]] = [
            float(stay["time"][-1] - stay["time"][0]) + 1.0 / RATE_HZ,
            float(len(stay)),
            about_mean(stay["depth"]),
            float(np.ptp(stay["depth"])),
            *(about_mean(angles[:, k]) for k in range(3)),
            float(stay["nu_hat"][:, 0].mean()),
            *(rms(60.0 * stay["u"][:, i]) for i in _kind(run, "thruster")),
            rms(fins),
        ]
    return out


def steps(run: Result, before: int, after: int) -> list[float]:
    """Largest step between adjacent 1 Hz samples near the last switch: propeller rpm, fins deg, roll deg."""
    rows, mode = samples(run), run.log["mode"]
    at = np.flatnonzero((mode[:-1] == before) & (mode[1:] == after)) + 1
    if len(at) == 0:
        return [float("nan")] * 3
    near = rows[np.abs(rows["time"] - run.log["time"][at[-1]]) <= WINDOW_S + 0.5 / RATE_HZ]
    screw = 60.0 * near["u"][:, _kind(run, "thruster")[0]]
    fins = np.degrees(near["u"][:, _kind(run, "fin")])
    roll = np.degrees(near["eta_hat"][:, 3])
    return [float(np.abs(np.diff(values, axis=0)).max()) for values in (screw, fins, roll)]


def hover_row(run: Result) -> list[float]:
    """Table A5: hover's RMS and the steps around both switches."""
    hover = per_mode(run).get("H", [float("nan")] * 12)
    return [*hover[2:8], *steps(run, FORWARD, REVERSE), *steps(run, REVERSE, HOVER)]


def about_reference(run: Result) -> list[float]:
    """RMS in H of depth (m), roll, pitch and yaw (deg) about what was asked for, every cycle."""
    stay = segments(run.log)[HOVER]
    errors = stay["reference"][:, 2:6] - stay["eta"][:, 2:6]
    errors[:, 1:] = np.degrees((errors[:, 1:] + np.pi) % (2 * np.pi) - np.pi)
    return [rms(errors[:, k]) for k in range(4)]


def part(progress: Progress) -> Part:
    """Fly the three scenarios with five seeds each."""
    vehicle = load_vehicle("ts100")
    missions = {label: shipped_mission(name) for label, name in MISSIONS.items()}
    runs: dict[str, list[Result]] = {}
    for k, (label, mission) in enumerate(missions.items()):
        runs[label] = [simulate(mission, vehicle, seed=seed) for seed in SEEDS]
        progress((k + 1) / 4)
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
        }
        for name, k in zip(GOALS, (0, 2, 3, 4), strict=True)
    }
    progress(1.0)
    tables = [
        Comparison(
            "tableA5",
            "Table A5: hover and the switching windows",
            f"Mean and standard deviation over {len(SEEDS)} seeds. 1 Hz samples, RMS about the mean, largest "
            "adjacent step within ±2 s of a switch. The paper ran each scenario once.",
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
            "RMS about the mean forgives a steady error; this does not. True state, every cycle, five seeds.",
            ["scenario", "depth (m)", "roll (°)", "pitch (°)", "yaw (°)"],
            [[label, *(float(v) for v in values)] for label, values in kept.items()],
        ),
        _goal_table(a5),
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
        numbers={"goals": goals, "about_reference": {k: v.tolist() for k, v in kept.items()}},
        hashes={f"mission {m.name}": m.sha256 for m in missions.values()} | {"vehicle ts100": vehicle.sha256},
    )


def _mean_and_spread(values: Array) -> tuple[list[float], list[float]]:
    return values.mean(axis=0).tolist(), values.std(axis=0).tolist()


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
    return f"{100 * (value / base - 1):+.0f} %".replace("-", "−") if base else "–"


def _figures(runs: dict[str, Result]) -> list[Figure]:
    last = list(runs.values())[-1]
    return [
        track_figure("tank_track", "Tracks in the basin", "Figures 20 and 21 of the paper.", runs),
        pose_figure("tank_pose", "Depth and attitude", "Figure 22. Shaded: the modes of S3.", runs),
        command_figure("tank_thrusters", "Thrusters", "Figure 23.", runs, THRUSTER),
        command_figure("tank_fins", "Rudders", "Figure 24.", runs, FIN),
        wrench_figure("tank_wrench", "Wrench of S3", "Figures 25 to 27, all actuators together.", last),
    ]
