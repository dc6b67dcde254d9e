"""Where a goal is not met: the curve along which it would have to be bought, and with what.

Each curve moves one parameter of the design through its range and judges its goals at each point, on the
same plants. Scenarios that the parameter does not touch fly once.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from bumpless.config.parameters import Parameters, default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless_paper.study.goals import Goal, goal_named
from bumpless_paper.study.many import fly_rows, plant_rows, share_of
from bumpless_paper.study.plants import draw
from bumpless_paper.study.readings import scenarios_of
from bumpless_paper.study.scenarios import Overrides
from bumpless_paper.study.tables import Progress

FACTORS = (0.01, 0.1, 0.3, 1.0, 3.0, 10.0)
PITCH, YAW = 4, 5  # rows of the wrench
BUMPLESS = ("S4<=S2 e_tau", "d_u,FR S3->S4", "d_u,RH S3->S4")
FAULT = ("pitch S5->S6", "yaw S5->S6", "e_tau S5->S6")


@dataclass(frozen=True)
class Curve:
    """One parameter: the values it takes, what each changes, and the scenarios that notice."""

    id: str
    parameter: str  # with its unit
    about: str
    goals: tuple[str, ...]
    moves: tuple[str, ...]
    values: tuple[float, ...]
    at: Callable[[Parameters, float], Overrides]
    in_use: Callable[[Parameters], float]
    log: bool = True  # whether the parameter is shown on a logarithmic axis


def _price(_: Parameters, value: float) -> Overrides:
    return {"bumpless": {"ramp_increment_price": value}}


def _ramp(_: Parameters, value: float) -> Overrides:
    return {"reverse": {"ramp_cycles": int(value)}}


def _priority(component: int) -> Callable[[Parameters, float], Overrides]:
    def at(p: Parameters, factor: float) -> Overrides:
        weights = [float(w) for w in p.allocation.priority]
        weights[component] *= factor
        return {"allocation": {"priority": weights}}

    return at


def _priorities(p: Parameters, exponent: float) -> Overrides:
    return {"allocation": {"priority": [float(w) ** exponent for w in p.allocation.priority]}}


def _fins(p: Parameters, factor: float) -> Overrides:
    fins = [a.kind == "fin" for a in load_vehicle("ts100").actuators]
    return {
        mode: {"r_diagonal": [float(r) * (factor if fin else 1.0) for r, fin in zip(of, fins, strict=True)]}
        for mode in ("forward", "reverse", "hover")
        for of in (getattr(p, mode).r_diagonal,)
    }


def _one(_: Parameters) -> float:
    return 1.0


CURVES: tuple[Curve, ...] = (
    Curve(
        "price",
        "price of increments while the ramp lasts",
        "Smooth commands at a switch are paid for with wrench error: S4 ≤ S2 in e_τ against d_u.",
        BUMPLESS,
        ("S4",),
        (0.1, 1.0, 3.0, 10.0, 30.0, 100.0),
        _price,
        lambda p: p.bumpless.ramp_increment_price,
    ),
    Curve(
        "ramp",
        "length of the ramp into R (cycles of 0.05 s)",
        "The longer the ramp, the smaller d_u,FR and the later the demand of the new mode is served.",
        BUMPLESS,
        ("S4",),
        (10.0, 20.0, 40.0, 80.0, 160.0),
        _ramp,
        lambda p: float(p.reverse.ramp_cycles),
    ),
    Curve(
        "priorities",
        "exponent on all priorities of S6 (0: all equal, 1: in use)",
        "How much the order of the wrench's components matters after the fault: none, in use, stronger.",
        FAULT,
        ("S6",),
        (0.0, 0.25, 0.5, 0.75, 1.0, 1.25),
        _priorities,
        _one,
        log=False,
    ),
    Curve(
        "pitch_priority",
        "priority of pitch in S6, times the one in use",
        "Pitch against yaw and against the whole wrench after the fault: all three share four fins.",
        FAULT,
        ("S6",),
        FACTORS,
        _priority(PITCH),
        _one,
    ),
    Curve(
        "yaw_priority",
        "priority of yaw in S6, times the one in use",
        "The same from yaw's side.",
        FAULT,
        ("S6",),
        FACTORS,
        _priority(YAW),
        _one,
    ),
    Curve(
        "fins",
        "price of fin deflection in all modes, times the one in use",
        "Fins that S5 leaves idle are what S6 can gain pitch with.",
        FAULT,
        ("S5", "S6"),
        FACTORS[1:],
        _fins,
        _one,
    ),
)


def trade_offs(
    curves: Sequence[Curve] = CURVES,
    n_plants: int = 40,
    progress: Progress = None,
    workers: int | None = None,
) -> dict[str, dict[str, Any]]:
    """By curve: the value in use, and a row per point with each goal's share and median ratio over limit."""
    parameters = default_parameters(load_vehicle("ts100"))
    plants = [draw(i) for i in range(n_plants)]
    rows, goals = [], {}
    for curve in curves:
        goals[curve.id] = [goal_named(name) for name in curve.goals]
        fixed = [name for name in scenarios_of(goals[curve.id], readings=False) if name not in curve.moves]
        rows += plant_rows(plants, fixed)
        for value in curve.values:
            rows += plant_rows(plants, curve.moves, curve.at(parameters, value))
    flown = iter(fly_rows(rows, progress, workers))
    out: dict[str, dict[str, Any]] = {}
    for curve in curves:
        base = [next(flown) for _ in plants]
        points = []
        for value in curve.values:
            mine = [{**row, **next(flown)} for row in base]
            points.append({"value": value, "goals": {g.name: _judged(g, mine) for g in goals[curve.id]}})
        out[curve.id] = {"in_use": curve.in_use(parameters), "points": points}
    return out


def _judged(goal: Goal, flown: Sequence[Any]) -> dict[str, float | None]:
    ratios = np.array([goal.ratio(row) for row in flown])
    kept = ratios[np.isfinite(ratios)]
    return {
        "share": share_of(goal, flown),
        "ratio": float(np.median(kept)) if len(kept) else None,
        "over_limit": float(np.median(kept)) / goal.limit if len(kept) else None,
    }
