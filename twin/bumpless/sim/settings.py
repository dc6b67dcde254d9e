"""Parameters, mission and sensors as the records that compiled code reads: degrees become radians here."""

from dataclasses import replace
from math import radians, sqrt
from statistics import NormalDist
from typing import Any

import numpy as np

from bumpless.config.capacity import MAX_FRAMES
from bumpless.config.declare.record import fill_record
from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.control.plan import PLAN
from bumpless.physics.sensors import SENSORS
from bumpless.sim.approach import turn_used_deg

_HOUR_S = 3600.0


def fill_settings(out: np.void, vehicle: Vehicle, parameters: Parameters) -> None:
    """Fill a SETTINGS record, section by section."""
    out["dt"] = vehicle.control_period_s
    for section in ("supervisor", "bumpless", "allocation", "guidance", "docking", "navigation"):
        fill_record(getattr(parameters, section), out[section])
    for i, mode in enumerate(parameters.modes):
        fill_record(mode, out["modes"][i])


def plan_of(mission: Mission, vehicle: Vehicle) -> np.ndarray:
    """PLAN record of a mission, shape (1,), but for what `sim.truth.tell` adds: the start and the faults.

    Durations become counts of control periods: sums of them miss by rounding.
    """
    out, period_s, target = np.zeros(1, PLAN), vehicle.control_period_s, mission.target
    p = out[0]
    path = mission.path_ned_m
    p["n_legs"] = len(mission.legs)
    p["waypoint"][: len(path)] = path
    p["speed"][: len(mission.legs)] = [leg.speed_mps for leg in mission.legs]
    p["target"] = [*target.position_ned_m, radians(target.heading_deg)]
    p["standoff"] = target.standoff_m
    p["heading_tolerance"] = radians(turn_used_deg(target, vehicle))
    p["dock_turns"], p["nose"] = target.turns, vehicle.ends_m[0]
    p["dock_half"], p["dock_radius"] = 0.5 * target.dock_width_m, target.dock_radius_m
    if target.dock:
        dock = target.dock
        p["dock"], p["dock_entry"] = 1, dock.entry_before_marker_m
        p["dock_depth"], p["dock_end"] = dock.capture_depth_m, dock.length_m
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
    s, v, said, period_s = out[0], vehicle.sensors, mission.sensors, vehicle.control_period_s
    ins, dvl, camera = (
        _changed(v.ins, said.ins),
        _changed(v.dvl, said.dvl),
        _changed(v.camera, said.detection),
    )
    near, usbl = said.near_camera or v.near_camera, said.usbl or v.usbl
    for part in (ins, dvl, v.depth, camera, near, usbl):
        if part is not None:
            fill_record(part, s)
    s["n_cameras"] = 1 if near is None else 2
    s["heading_walk"] = radians(ins.heading_drift_degprth) * sqrt(period_s / _HOUR_S)
    s["dvl_period"], s["camera_period"] = (cycles(period_s, x.rate_hz) for x in (dvl, camera))
    s["usbl_period"] = 0 if usbl is None else cycles(period_s, usbl.rate_hz)
    s["camera_latency"] = min(round(camera.latency_s / period_s), (MAX_FRAMES - 1) * int(s["camera_period"]))
    s["dvl_dropout"], s["camera_dropout"] = (
        _score(dvl.dropout_probability),
        _score(camera.dropout_probability),
    )
    return out


def cycles(period_s: float, rate_hz: float) -> int:
    """Control cycles from one measurement to the next."""
    return max(1, round(1.0 / period_s / rate_hz))


def _changed(part: Any, changes: object) -> Any:
    """A part of the vehicle's sensors with what the mission says of it."""
    said = vars(changes) if changes else {}
    return replace(part, **{name: value for name, value in said.items() if value is not None})
