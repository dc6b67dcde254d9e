"""Flights for the small 3-D view of reports, thinned and rounded, each with a hull; its script and hash."""

import base64
import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from bumpless.config.vehicle import Vehicle
from bumpless.contract.modes import LOOKS, MODE_LETTERS
from bumpless.contract.units import DEG
from bumpless.runs.run import Run

MOST_ROWS = 900  # of a flight
COLOURS = ("#0369a1", "#b45309", "#7c3aed", "#047857", "#b91c1c", "#0f1b2a")
LOOK: dict[str, Any] = {
    "ground": "#eef2f7",
    "grid": "#c3cfdc",
    "ink": "#0f1b2a",
    "faint": "#aebccb",
    "path": "#7b8aa0",
    "target": "#7c3aed",
    "hull": "#f2c14e",
    "font": "12px system-ui, sans-serif",
    "modes": {look.letter: look.colour for look in LOOKS.values()},
}
Hull = Mapping[str, Sequence[Sequence[float]]]  # vertices in body axes, m, and faces
MakeHull = Callable[[Vehicle], Hull]


def scene(runs: Sequence[Run], zeros: Sequence[float], make_hull: MakeHull | None = None) -> dict[str, Any]:
    """What the view shows: flights, each from its moment `zeros`, s; plan and target are the first's."""
    first = runs[0]
    told: dict[str, Any] = {
        "flights": [_flight(run, k, len(runs), zero, make_hull) for k, (run, zero) in enumerate(
            zip(runs, zeros, strict=True))],
        "look": LOOK,
    }  # fmt: skip
    mission, columns = first.mission, first.columns
    if mission is not None:
        told["path"] = [list(point) for point in mission.path_ned_m]
    told["target"] = {
        "position": _row(columns.target[-1, :3]),
        "heading": round(float(columns.target[-1, 3]) * DEG, 2),
        "station": _row(columns.observation_point[-1]),
    }
    ends = [(run.columns.time[[0, -1]] - zero) for run, zero in zip(runs, zeros, strict=True)]
    told["from_s"] = round(float(min(end[0] for end in ends)), 2)
    told["to_s"] = round(float(max(end[1] for end in ends)), 2)
    return told


def _flight(run: Run, index: int, count: int, zero: float, make_hull: MakeHull | None) -> dict[str, Any]:
    columns = run.columns
    eta = columns.eta if np.isfinite(columns.eta).all() else columns.eta_hat
    rows = np.unique(np.linspace(0, len(eta) - 1, min(MOST_ROWS, len(eta))).round().astype(int))
    told: dict[str, Any] = {
        "time": np.round(columns.time[rows], 2).tolist(),
        "position": np.round(np.nan_to_num(eta[rows, :3]), 3).tolist(),
        "attitude": np.round(np.nan_to_num(eta[rows, 3:]) * DEG, 1).tolist(),
        "mode": [MODE_LETTERS.get(int(mode), "") for mode in columns.mode[rows]],
        "zero": round(zero, 3),
        "name": chr(65 + index) if count > 1 else "",
    }
    if count > 1:
        told["colour"] = COLOURS[index % len(COLOURS)]
    if run.vehicle is not None:
        told["hull"] = (make_hull or plain_hull)(run.vehicle)
    return told


def plain_hull(vehicle: Vehicle) -> Hull:
    """A spindle of the vehicle's length, for whoever has no better picture of it."""

    fore, aft = vehicle.ends_m
    radius, sides = 0.09 * (fore - aft), 10
    ring = [(np.cos(a), np.sin(a)) for a in np.linspace(0.0, 2.0 * np.pi, sides, endpoint=False)]
    stations = [(fore - 0.2 * (fore - aft), radius), (aft + 0.3 * (fore - aft), radius)]
    vertices = [[fore, 0.0, 0.0], *([x, r * c, r * s] for x, r in stations for c, s in ring), [aft, 0.0, 0.0]]
    last, faces = len(vertices) - 1, list[list[int]]()
    for k in range(sides):
        a, b = 1 + k, 1 + (k + 1) % sides
        faces += [[0, a, b], [a, a + sides, b], [b, a + sides, b + sides], [a + sides, last, b + sides]]
    return {"vertices": [[round(float(v), 3) for v in row] for row in vertices], "faces": faces}


def _row(values: np.ndarray) -> list[float]:
    return np.round(np.nan_to_num(values), 3).tolist()


def as_json(told: Mapping[str, Any]) -> str:
    """To stand in a page's script element: no text in it can end that element."""
    return json.dumps(told, separators=(",", ":")).replace("<", "\\u003c")


@cache
def script() -> str:
    """The view and its use, as one module."""
    folder = resources.files("bumpless.review")
    return "".join(
        (folder / name).read_text(encoding="utf-8") for name in ("replay3d.js", "replay3d_page.js")
    )


@cache
def script_hash() -> str:
    """As a content security policy names it: no other script runs in a report."""
    return f"sha256-{base64.b64encode(hashlib.sha256(script().encode()).digest()).decode()}"
