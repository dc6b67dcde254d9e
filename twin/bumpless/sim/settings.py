"""Parameters, mission and sensors as the records that compiled code reads: degrees become radians here."""

from dataclasses import replace
from math import radians
from statistics import NormalDist

import numpy as np

from bumpless.config.declare.record import fill_record
from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.sensors import Camera
from bumpless.control.plan import PLAN
from bumpless.physics.sensors import SENSORS


def fill_settings(out: np.void, vehicle: Vehicle, parameters: Parameters) -> None:
    """Fill a SETTINGS record, section by section."""
    out["dt"] = vehicle.control_period_s
    for section in ("supervisor", "bumpless", "allocation", "guidance", "docking"):
        fill_record(getattr(parameters, section), out[section])
    for i, mode in enumerate(parameters.modes):
        fill_record(mode, out["modes"][i])


def plan_of(mission: Mission, period_s: float) -> np.ndarray:
    """PLAN record of a mission, shape (1,), but for what `sim.truth.tell` adds: the start and the faults.

    Durations become counts of control periods: sums of period_s miss them by rounding.
    """
    out = np.zeros(1, PLAN)
    p = out[0]
    path = mission.path_ned_m
    p["n_legs"] = len(mission.legs)
    p["waypoint"][: len(path)] = path
    p["speed"][: len(mission.legs)] = [leg.speed_mps for leg in mission.legs]
    p["target"] = [*mission.target.position_ned_m, radians(mission.target.heading_deg)]
    p["standoff"] = mission.target.standoff_m
    p["heading_tolerance"] = radians(mission.target.turn_deg)
    p["cycles"] = round(mission.duration_s / period_s)
    hold_s = mission.end.hover_hold_s
    p["hold_cycles"] = 0 if hold_s is None else max(1, round(hold_s / period_s))
    return out


def _score(probability: float) -> float:
    """z below which a standard normal sample falls with this probability."""
    if probability <= 0.0:
        return -np.inf
    return np.inf if probability >= 1.0 else NormalDist().inv_cdf(probability)


def sensors_of(vehicle: Vehicle, mission: Mission) -> np.ndarray:
    """SENSORS record of a vehicle with a mission's changes, shape (1,)."""
    out = np.zeros(1, SENSORS)
    s, v, rate = out[0], vehicle.sensors, 1.0 / vehicle.control_period_s
    camera = _changed(v.camera, mission)
    for part in (v.ins, v.dvl, v.depth, camera):
        fill_record(part, s)
    s["dvl_period"], s["camera_period"] = (
        max(1, round(rate / v.dvl.rate_hz)),
        max(1, round(rate / camera.rate_hz)),
    )
    s["dvl_dropout"], s["camera_dropout"] = (
        _score(v.dvl.dropout_probability),
        _score(camera.dropout_probability),
    )
    return out


def _changed(camera: Camera, mission: Mission) -> Camera:
    """The camera with what the mission says of it."""
    said = vars(mission.sensors.detection) if mission.sensors.detection else {}
    return replace(camera, **{name: value for name, value in said.items() if value is not None})
