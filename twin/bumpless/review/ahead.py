"""What if, live: a draft of parameters flown ahead from where a vehicle is now, beside what it flies with."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from google.protobuf.message import Message

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import (
    ParameterError,
    Parameters,
    check,
    default_parameters,
    from_message,
    with_overrides,
)
from bumpless.config.vehicle import Vehicle, parse_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.modes import MODE_LETTERS
from bumpless.contract.units import DEG, EDGE_PER_SI
from bumpless.sim.present import PresentTwin, Said

LONGEST_S = 600.0
MOST_POINTS = 400
AXES = "XYZKMN"


@dataclass(frozen=True)
class Present:
    """What a vehicle said last: itself, its plan, what it flies with, and its state."""

    vehicle: Vehicle
    mission: Mission
    parameters: Parameters
    said: Said

    @classmethod
    def of(cls, latest: Mapping[str, Message]) -> "Present":
        """From the newest messages by topic's name. Raises ValueError where one lacks or can't be read."""
        found: dict[str, Any] = {}
        for name in ("description", "plan", "parameters", *Said.__dataclass_fields__):
            if name not in latest:
                raise ValueError(f"the vehicle has not told its {name} yet")
            found[name] = latest[name]
        vehicle = parse_vehicle(found["description"].vehicle_toml, "vehicle.toml")
        plan = found["plan"]
        mission = parse_mission(
            plan.mission_yaml, plan.file_name or "mission.yaml", vehicle, any_vehicle=True
        )
        base = with_overrides(default_parameters(vehicle), mission.parameters)
        said = Said(**{name: found[name] for name in Said.__dataclass_fields__})
        return cls(vehicle, mission, from_message(found["parameters"].active, base), said)

    def drafted(self, draft: pb.Parameters) -> Parameters:
        """What is flown with, with the draft in place. Raises ParameterError."""
        changed = from_message(draft, self.parameters)
        problems = check(changed, self.vehicle)
        if problems:
            raise ParameterError(problems)
        return changed


def ahead(present: Present, draft: Parameters | None, horizon_s: float) -> dict[str, Any]:
    """Fly on for so long with what is in force, or with a draft that is adopted at once, through its ramp.

    Columns are named as in the console's plots: degrees and the commands' units. Raises ValueError.
    """
    twin = PresentTwin(present.vehicle, present.mission, present.parameters, present.said)
    if draft is not None:
        twin.set_parameters(draft)
    log = twin.ahead(max(2, round(min(horizon_s, LONGEST_S) / twin.period_s)))
    if not np.isfinite(log["eta"]).all():
        raise ValueError("the flight ahead does not stay finite")
    rows = log[np.unique(np.linspace(0, len(log) - 1, min(MOST_POINTS, len(log))).round().astype(int))]
    return {
        "time_s": _short(rows["time"], 3),
        "columns": {name: _short(values, 4) for name, values in _columns(rows, present.vehicle)},
        "mode": [MODE_LETTERS[int(mode)] for mode in rows["mode"]],
        "switches": _switches(log),
        "figures": _figures(log, present.vehicle),
    }


def _columns(rows: np.ndarray, vehicle: Vehicle) -> Any:
    eta, reference = rows["eta"], rows["reference"]
    yield "north", eta[:, 0]
    yield "east", eta[:, 1]
    yield "depth", eta[:, 2]
    yield "speed", rows["nu"][:, 0]
    for k, name in enumerate(("roll", "pitch", "yaw")):
        yield name, np.unwrap(eta[:, 3 + k]) * DEG
    yield "depth_reference", reference[:, 2]
    yield "speed_reference", reference[:, 0]
    yield "cross_track", rows["cross_track"]
    yield "range", rows["range"]
    yield "kappa", rows["kappa"]
    yield "residual", rows["residual_norm"]
    for k, axis in enumerate(AXES):
        yield f"demanded_{axis}", rows["tau_d"][:, k]
        yield f"achieved_{axis}", rows["tau_c"][:, k]
    for i, command in enumerate(vehicle.commands):
        scale = EDGE_PER_SI[command.unit]
        yield f"command_{command.actuator}", rows["u"][:, i] * scale
        yield f"feedback_{command.actuator}", rows["u_feedback"][:, i] * scale


def _switches(log: np.ndarray) -> list[dict[str, Any]]:
    at = np.flatnonzero(np.diff(log["mode"])) + 1
    return [
        {
            "time_s": round(float(log["time"][k]), 3),
            "from": MODE_LETTERS[int(log["mode"][k - 1])],
            "to": MODE_LETTERS[int(log["mode"][k])],
        }
        for k in at
    ]


def _figures(log: np.ndarray, vehicle: Vehicle) -> dict[str, float]:
    """What two flights ahead are compared by; less of each is better, but for the range at the end."""
    n = len(vehicle.commands)
    scale = np.array([EDGE_PER_SI[command.unit] for command in vehicle.commands])
    bound = np.array([max(abs(c.lower), abs(c.upper)) for c in vehicle.commands]) / scale
    share = log["u"][:, :n] / bound
    unmet = np.linalg.norm(log["tau_d"] - log["tau_c"], axis=1)
    return {
        "depth_error_max_m": _most(log["eta"][:, 2] - log["reference"][:, 2]),
        "cross_track_max_m": _most(log["cross_track"]),
        "residual_rms": round(float(np.sqrt(np.mean(unmet**2))), 5),
        "command_step_max": _most(np.linalg.norm(np.diff(share, axis=0), axis=1)),
        "saturated_share": round(float((np.abs(share) > 0.999).any(axis=1).mean()), 4),
        "range_end_m": round(float(log["range"][-1]), 4),
    }


def _most(values: np.ndarray) -> float:
    return round(float(np.abs(values).max()), 4)


def _short(values: np.ndarray, digits: int) -> list[float | None]:
    return [value if np.isfinite(value) else None for value in np.round(values, digits).tolist()]
