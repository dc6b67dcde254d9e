"""Figures of a flown mission: track, depth and attitude, thrusters, wrench, fins."""

import itertools
from collections.abc import Mapping, Sequence

import numpy as np

from bumpless.contract.units import DEG, EDGE_PER_SI, WRENCH, WRENCH_UNITS
from bumpless.sim.twin import Result
from bumpless_paper.report.content import Figure, Panel, Series

TIME = "time (s)"


def spans_of(log: np.ndarray) -> list[tuple[float, float, int]]:
    """(from, to, mode) of every stay in a mode."""
    edges = [0, *(np.flatnonzero(np.diff(log["mode"])) + 1).tolist(), len(log)]
    return [
        (float(log["time"][a]), float(log["time"][b - 1]), int(log["mode"][a]))
        for a, b in itertools.pairwise(edges)
    ]


def track_figure(id: str, title: str, caption: str, runs: Mapping[str, Result]) -> Figure:
    """Tracks over ground and range to the observation point of several runs."""
    plan, range_ = [], []
    for k, (name, run) in enumerate(runs.items()):
        log = run.log
        plan.append(Series(name, log["eta"][:, 0], log["eta"][:, 1], k))
        range_.append(Series(name, log["time"], log["range_true"], k))
    first = next(iter(runs.values()))
    path = np.array(first.mission.path_ned_m)
    plan.append(Series("planned", path[:, 0], path[:, 1], 5, "dash"))
    return Figure(
        id,
        title,
        caption,
        [
            Panel("north (m)", "east (m)", plan),
            Panel(TIME, "range (m)", range_, spans_of(first.log)),
        ],
        2,
    )


def pose_figure(id: str, title: str, caption: str, runs: Mapping[str, Result]) -> Figure:
    """Depth, roll, pitch, heading and surge speed over time."""
    rows: Sequence[tuple[str, str, int, float]] = (
        ("depth (m)", "eta", 2, 1.0),
        ("roll (°)", "eta", 3, DEG),
        ("pitch (°)", "eta", 4, DEG),
        ("yaw (°)", "eta", 5, DEG),
        ("surge (m/s)", "nu", 0, 1.0),
    )
    last = list(runs.values())[-1]
    panels = []
    for label, column, axis, scale in rows:
        series = [
            Series(name, run.log["time"], _unwrapped(run.log[column][:, axis], column, axis) * scale, k)
            for k, (name, run) in enumerate(runs.items())
        ]
        wanted = _unwrapped(last.log["reference"][:, axis], column, axis) * scale
        series.append(Series("reference", last.log["time"], wanted, 5, "dash"))
        panels.append(Panel(TIME, label, series, spans_of(last.log)))
    return Figure(id, title, caption, panels)


def _unwrapped(values: np.ndarray, column: str, axis: int) -> np.ndarray:
    return np.unwrap(values) if column == "eta" and axis > 2 else values


def command_figure(id: str, title: str, caption: str, runs: Mapping[str, Result], kind: str) -> Figure:
    """Commands of all actuators of a kind ("fin", "thruster") over time, deg or rpm."""
    last = list(runs.values())[-1]
    panels = []
    for i in last.vehicle.slots(kind):
        command = last.vehicle.commands[i]
        unit, scale = "°" if command.unit == "deg" else command.unit, EDGE_PER_SI[command.unit]
        series = [
            Series(name, run.log["time"], run.log["u"][:, i] * scale, k, "steps")
            for k, (name, run) in enumerate(runs.items())
        ]
        panels.append(Panel(TIME, f"{command.name} ({unit})", series, spans_of(last.log)))
    return Figure(id, title, caption, panels, 1 if len(panels) < 4 else 2)


def wrench_figure(id: str, title: str, caption: str, run: Result) -> Figure:
    """Demanded and true wrench of one run, controllable components only."""
    panels = []
    for k, (name, unit) in enumerate(zip(WRENCH, WRENCH_UNITS, strict=True)):
        if name in run.vehicle.controllable:
            series = [
                Series("demanded", run.log["time"], run.log["tau_d"][:, k], 1),
                Series("the plant's", run.log["time"], run.log["tau"][:, k], 0),
            ]
            panels.append(Panel(TIME, f"{name} ({unit})", series, spans_of(run.log)))
    return Figure(id, title, caption, panels, 2)


def runtime_figure(id: str, title: str, caption: str, runs: Mapping[str, Result]) -> Figure:
    """Distribution of the allocator's time per cycle: share of cycles that took longer."""
    series = []
    for k, (name, run) in enumerate(runs.items()):
        micros = np.sort(run.log["solve_time"] * 1e6)
        share = 1.0 - np.arange(len(micros)) / len(micros)
        series.append(Series(name, np.maximum(micros, 0.05), share, k))
    panel = Panel(
        "allocation per cycle (µs)", "share of cycles that took longer", series, log_x=True, log_y=True
    )
    return Figure(id, title, caption, [panel])
