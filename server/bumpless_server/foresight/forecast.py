"""The nominal flight of a plan as it is told: its way, its switches, how it ends and what it costs."""

import hashlib
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

import bumpless
from bumpless.chart import Floor, floor_of
from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import HOVER
from bumpless.contract.modes import MODE_LETTERS
from bumpless.contract.units import EDGE_PER_SI
from bumpless.metrics import Columns
from bumpless.metrics.floor import floor_clearance, least_clearance
from bumpless_server.foresight.margin import margins
from bumpless_server.foresight.plan import Plan
from bumpless_server.foresight.told import (
    ForesightNominal,
    ForesightOutcome,
    ForesightSwitch,
    ForesightTrack,
)

MOST_POINTS = 600
NOT_OF_THE_FLIGHT = "solve_time"  # measured on the machine, another every time
Floats = npt.NDArray[np.float64]


def nominal(plan: Plan, request_id: int, elapsed_ms: float = 0.0) -> ForesightNominal:
    """Fly the plan as `bumpless run` flies it, and tell it."""
    mission = plan.mission
    run = bumpless.fly(mission, plan.vehicle, seed=mission.seed, parameters=plan.parameters, started_ns=0)
    metrics, columns = run.metrics, run.columns
    hover, floor = np.flatnonzero(columns.mode == HOVER), floor_of(mission)
    return ForesightNominal(
        id=request_id,
        track=track_of(columns, plan.vehicle, floor),
        switches=switches_of(columns),
        outcome=ForesightOutcome.model_validate(run.outcome.as_dict()),
        arrival_s=float(columns.time[hover[0]]) if len(hover) else None,
        energy_j=metrics.shaft_energy_j,
        length_m=float(np.linalg.norm(np.diff(columns.eta[:, :3], axis=0), axis=1).sum()),
        least_clearance_m=least_clearance(columns.eta, plan.vehicle, floor),
        sha256=mission.sha256,
        seed=mission.seed,
        tuned=plan.tuned,
        digest=digest_of(columns),
        elapsed_ms=elapsed_ms,
    )


def digest_of(columns: Columns) -> str:
    """SHA-256 of every column of a run but the measured solve times: equal for flights equal to the bit."""
    found = hashlib.sha256()
    for name, values in _named(columns, ""):
        if name != NOT_OF_THE_FLIGHT:
            found.update(f"{name} {values.dtype.str} {values.shape}".encode())
            found.update(np.ascontiguousarray(values).tobytes())
    return found.hexdigest()


def _named(columns: Any, within: str) -> Iterator[tuple[str, npt.NDArray[Any]]]:
    """Every array of a record of columns with its name, those of the records in it among them."""
    for field in fields(columns):
        value, name = getattr(columns, field.name), within + field.name
        if is_dataclass(value):
            yield from _named(value, f"{name}.")
        elif isinstance(value, np.ndarray):
            yield name, value
        elif isinstance(value, bool):
            if value:  # as a rule it is not, and says nothing
                yield name, np.array(value)
        elif value is not None:
            raise TypeError(f"{name} is no column")


def track_of(columns: Columns, vehicle: Vehicle, floor: Floor | None = None) -> ForesightTrack:
    """At most 600 cycles: evenly spread, first and last among them."""
    rows = shown_rows(len(columns))
    eta, nu = columns.eta[rows], columns.nu[rows]
    share, worst = saturation(columns.u[rows], vehicle)
    return ForesightTrack(
        t_s=_short(columns.time[rows], 3),
        north_m=_short(eta[:, 0], 3),
        east_m=_short(eta[:, 1], 3),
        depth_m=_short(eta[:, 2], 3),
        heading_deg=_short((np.degrees(eta[:, 5]) + 180.0) % 360.0 - 180.0, 2),
        mode=[MODE_LETTERS[int(mode)] for mode in columns.mode[rows]],
        speed_m_s=_short(np.linalg.norm(nu[:, :3], axis=1), 3),
        depth_error_m=_short(eta[:, 2] - columns.reference[rows, 2], 3),
        saturation=_short(share, 3),
        worst_actuator=worst,
        margin=_short(margins(columns.tau_d[rows], columns.nu_r_hat[rows, 0], vehicle), 3),
        floor_m=known(floor.depth(eta[:, 0], eta[:, 1])) if floor else [],
        clearance_m=known(floor_clearance(eta, vehicle, floor)) if floor else [],
    )


def known(values: Floats) -> list[float | None]:
    """Rounded for a message; None where it is not known."""
    return [float(value) if np.isfinite(value) else None for value in values.round(2)]


def shown_rows(count: int, most: int = MOST_POINTS) -> npt.NDArray[np.intp]:
    """Which of `count` rows are shown."""
    return np.unique(np.linspace(0, count - 1, min(most, count)).round().astype(np.intp))


def saturation(u: Floats, vehicle: Vehicle) -> tuple[Floats, list[str]]:
    """Of commands (n, n_u) in SI: the largest share of its bound, and the actuator whose that is."""
    scale = np.array([EDGE_PER_SI[command.unit] for command in vehicle.commands])
    upper = np.array([command.upper for command in vehicle.commands]) / scale
    lower = np.array([command.lower for command in vehicle.commands]) / scale
    bound = np.where(u >= 0.0, upper, -lower)
    shares = np.abs(u) / np.where(bound > 0.0, bound, np.inf)
    most = shares.argmax(axis=1)
    names = [command.actuator for command in vehicle.commands]
    return np.minimum(shares[np.arange(len(u)), most], 1.0), [names[int(i)] for i in most]


def switches_of(columns: Columns) -> list[ForesightSwitch]:
    """Every change of mode with its mission time."""
    at = np.flatnonzero(np.diff(columns.mode)) + 1
    return [
        ForesightSwitch(
            **{
                "t_s": float(columns.time[k]),
                "from": MODE_LETTERS[int(columns.mode[k - 1])],
                "to": MODE_LETTERS[int(columns.mode[k])],
            }
        )
        for k in at
    ]


def _short(values: Floats, digits: int) -> list[float]:
    return np.round(values, digits).tolist()
