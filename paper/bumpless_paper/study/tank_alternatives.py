"""The tank study with one choice made otherwise at a time: what its goals owe to each, how far they carry.

Choices of the design first, then of the mission, which the paper does not print.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from bumpless.config.mission import Mission
from bumpless.config.parameters import with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless.sim.twin import parameters_for, simulate
from bumpless_paper.study.scenarios import Overrides, merged
from bumpless_paper.study.tank import GOALS, about_reference, hover_row


def _as_it_is(mission: Mission) -> Mission:
    return mission


@dataclass(frozen=True)
class Alternative:
    """What is changed in all three scenarios, what only the allocators of S2 and S3 can use, the mission."""

    name: str
    shared: Overrides = field(default_factory=dict)
    allocators: Overrides = field(default_factory=dict)
    mission: Callable[[Mission], Mission] = _as_it_is


def _from_depth(metres: float) -> Callable[[Mission], Mission]:
    def changed(mission: Mission) -> Mission:
        north, east, _ = mission.start.position_ned_m
        return replace(mission, start=replace(mission.start, position_ned_m=(north, east, metres)))

    return changed


def _current(speed: float) -> Callable[[Mission], Mission]:
    def changed(mission: Mission) -> Mission:
        return replace(mission, environment=replace(mission.environment, current_ned_mps=(speed, 0.0, 0.0)))

    return changed


def _noise(scale: float) -> Callable[[Mission], Mission]:
    return lambda mission: replace(mission, sensors=replace(mission.sensors, noise_scale=scale))


_OWN_DEPTH_GAINS: Overrides = {
    "forward": {
        "kp": [20.0, 0.0, 1.5, 0.5, 25.0, 25.0],
        "ki": [2.0, 0.0, 0.05, 0.1, 4.0, 4.0],
        "kd": [0.0, 0.0, 0.0, 0.2, 50.0, 50.0],
    },
    "reverse": {
        "kp": [20.0, 0.0, 4.0, 0.5, 40.0, 40.0],
        "ki": [0.8, 0.0, 0.1, 0.1, 10.0, 10.0],
        "kd": [0.0, 0.0, 10.0, 0.2, 70.0, 70.0],
    },
}
_FAST = {"reverse_speed_slope_per_s": 0.07, "reverse_speed_offset_mps": 0.07}
_TOLD: Overrides = {"allocation": {"fault_tolerant": True, "priority": [1.0] * 6, "slack_price": [0.0] * 6}}

_NO_ROLL: Overrides = {
    "hover": {
        "kp": [30.0, 0.0, 8.0, 0.0, 40.0, 40.0],
        "ki": [2.0, 0.0, 0.25, 0.0, 4.0, 4.0],
        "kd": [0.0, 0.0, 30.0, 0.0, 70.0, 70.0],
    }
}


def _fins(price: float) -> Overrides:
    return {"hover": {"r_diagonal": [price] * 4 + [0.02, 0.05, 0.05]}}


FIGURES = (*GOALS, "yaw_about_reference_deg")  # what heading costs that is held by keeping still
AS_FLOWN = Alternative("as flown")
ALTERNATIVES: tuple[Alternative, ...] = (
    AS_FLOWN,
    Alternative("the allocator's map takes in sway and heave", {"guidance": {"flow_drift": 1.0}}),
    Alternative("arriving at 0.11 m/s instead of 0.07 m/s", {"guidance": _FAST}),
    Alternative(
        "integrals drained by what is not delivered, 1 /s", {"allocation": {"anti_windup_per_s": 1.0}}
    ),
    Alternative("integrals drained at 0.2 /s", {"allocation": {"anti_windup_per_s": 0.2}}),
    Alternative("a ramp of 12 s into hover instead of 4 s", {"hover": {"ramp_cycles": 240}}),
    Alternative("fins at the vehicle's price in hover, R = 1 instead of 0.3", _fins(1.0)),
    Alternative("fins at R = 0.1 in hover", _fins(0.1)),
    Alternative("no roll gains in hover, where S1 has only its fins for them", _NO_ROLL),
    Alternative("small depth gains in F and R, which let the descent lag", _OWN_DEPTH_GAINS),
    Alternative("hovering along the estimated current", {"guidance": {"crab_gain": 1.0}}),
    Alternative("the allocator told of the worn actuators", allocators=_TOLD),
    Alternative("healthy actuators", mission=lambda mission: replace(mission, faults=())),
    Alternative("still water but for the gusts", mission=_current(0.0)),
    Alternative("twice the current", mission=_current(-0.06)),
    Alternative("no descent", mission=_from_depth(1.8)),
    Alternative("a steeper descent, from 0.9 m", mission=_from_depth(0.9)),
    Alternative("half the noise", mission=_noise(1.0)),
    Alternative("twice the noise", mission=_noise(4.0)),
)


def hover_figures(
    alternative: Alternative, missions: Mapping[str, Mission], vehicle: Vehicle, seeds: Sequence[int]
) -> dict[str, NDArray[np.float64]]:
    """By scenario: rows of FIGURES, one a seed."""
    out = {}
    for label, mission in missions.items():
        changed = alternative.mission(mission)
        extra = merged(alternative.shared, alternative.allocators if label != "S1" else {})
        parameters = with_overrides(parameters_for(vehicle, changed), extra)
        runs = [simulate(changed, vehicle, parameters, seed=seed) for seed in seeds]
        rows = [[hover_row(run)[k] for k in GOALS.values()] + [about_reference(run)[3]] for run in runs]
        out[label] = np.array(rows)
    return out


def changes(figures: Mapping[str, NDArray[np.float64]]) -> dict[str, dict[str, float]]:
    """Figure -> scenario -> mean over the seeds against S1's, minus 1."""
    base = figures["S1"].mean(axis=0)
    return {
        goal: {
            label: float(rows[:, k].mean() / base[k] - 1.0)
            for label, rows in figures.items()
            if label != "S1"
        }
        for k, goal in enumerate(FIGURES)
    }
