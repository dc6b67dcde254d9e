"""One flight of a campaign as a mission of its own: the declared mission with a draw's values in it."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from bumpless.campaign.drawn_parts import drawn_errors, drawn_motion, drawn_water, filled
from bumpless.config.mission import Mission
from bumpless.config.mission.model import Environment, Fault
from bumpless.config.mission.sea import CurrentVariation, Wave
from bumpless.config.mission.sensing import Detection, Outage
from bumpless.config.vehicle import Vehicle

Values = Mapping[str, Any]
_VARIATION = CurrentVariation(std_mps=0.0, time_constant_s=30.0)
_WAVE = Wave(height_m=0.0, period_s=6.0)
OF_SENSORS = ("heading_bias_std_deg", "depth_bias_std_m")  # of the vehicle's, not of a mission's
_FAULT = ("fault_actuator", "fault_at_s", "fault_effectiveness")


def drawn_mission(mission: Mission, values: Values) -> Mission:
    """The mission that this draw flies. Raises ValueError when it would be none."""
    mission = replace(mission, target=_target(mission, values), start=_start(mission, values))
    return replace(
        mission,
        environment=drawn_water(_environment(mission, values), values),
        sensors=drawn_errors(_sensors(mission, values), values),
        faults=_faults(mission, values),
        actuator_flow=values["actuator_flow"] > 0.0 if "actuator_flow" in values else mission.actuator_flow,
    )


def drawn_vehicle(vehicle: Vehicle, values: Values) -> Vehicle:
    """The vehicle with the drawn deviations of its sensors' biases; the same object when none is drawn."""
    sensors, before = vehicle.sensors, vehicle.sensors
    heading, depth = (values.get(name) for name in OF_SENSORS)
    if heading is not None:
        sensors = replace(sensors, ins=replace(sensors.ins, heading_bias_deg=heading))
    if depth is not None:
        sensors = replace(sensors, depth=replace(sensors.depth, depth_bias_m=depth))
    return vehicle if sensors is before else replace(vehicle, sensors=sensors)


def relative_current(mission: Mission) -> tuple[float, float]:
    """(speed m/s, where it flows to from the approach heading, deg, 0 to 360) of a drawn mission."""
    north, east, _ = mission.environment.current_ned_mps
    toward = math.degrees(math.atan2(east, north)) - mission.target.heading_deg
    return math.hypot(north, east), toward % 360.0


def _ned(along: float, across: float, heading_deg: float) -> tuple[float, float]:
    c, s = math.cos(math.radians(heading_deg)), math.sin(math.radians(heading_deg))
    return along * c - across * s, along * s + across * c


def _environment(mission: Mission, values: Values) -> Environment:
    sea, heading = mission.environment, mission.target.heading_deg
    north, east, down = sea.current_ned_mps
    if "current_speed_mps" in values:
        north, east = _ned(values["current_speed_mps"], 0.0, heading + values["current_relative_deg"])
    more = _ned(values.get("current_along_mps", 0.0), values.get("current_across_mps", 0.0), heading)
    sea = replace(sea, current_ned_mps=(north + more[0], east + more[1], down))
    variation = filled(
        sea.current_variation or _VARIATION,
        values,
        std_mps="current_variation_mps",
        time_constant_s="current_variation_time_s",
    )
    wave = filled(sea.wave or _WAVE, values, height_m="wave_height_m", period_s="wave_period_s")
    if "wave_relative_deg" in values:
        wave = replace(wave, direction_deg=(heading + values["wave_relative_deg"]) % 360.0)
    return replace(
        sea,
        current_variation=variation if variation is not _VARIATION else sea.current_variation,
        wave=wave if wave is not _WAVE else sea.wave,
    )


def _target(mission: Mission, values: Values) -> Any:
    target = mission.target
    if "target_turn_deg" in values:
        target = replace(target, heading_deg=(target.heading_deg + values["target_turn_deg"]) % 360.0)
    along, across, down = (values.get(f"target_{axis}", 0.0) for axis in ("along_m", "across_m", "down_m"))
    north, east = _ned(along, across, target.heading_deg)
    n, e, d = target.true_offset_ned_m
    return drawn_motion(replace(target, true_offset_ned_m=(n + north, e + east, d + down)), values)


def _start(mission: Mission, values: Values) -> Any:
    start = mission.start
    north, east = _ned(values.get("start_ahead_m", 0.0), values.get("start_abeam_m", 0.0), start.heading_deg)
    n, e, d = start.position_ned_m
    heading = start.heading_deg + values.get("start_turn_deg", 0.0)
    return replace(
        start,
        position_ned_m=(n + north, e + east, d + values.get("start_down_m", 0.0)),
        heading_deg=(heading + 180.0) % 360.0 - 180.0,
        speed_mps=values.get("start_speed_mps", start.speed_mps),
    )


def _sensors(mission: Mission, values: Values) -> Any:
    sensors = mission.sensors
    detection = filled(
        sensors.detection or Detection(),
        values,
        range_max_m="detection_range_m",
        dropout_probability="detection_dropout",
    )
    outages = sensors.outages
    if values.get("outage_length_s", 0.0) > 0.0:
        outages += (Outage(values["outage_at_s"], values["outage_at_s"] + values["outage_length_s"]),)
    return replace(
        sensors,
        noise_scale=sensors.noise_scale * values.get("noise", 1.0),
        detection=detection if detection != Detection() else sensors.detection,
        outages=outages,
    )


def _faults(mission: Mission, values: Values) -> tuple[Fault, ...]:
    names = {"actuator": "fault_actuator", "at_s": "fault_at_s", "effectiveness": "fault_effectiveness"}
    names["blend_s"] = "fault_blend_s"
    if not any(name in values for name in names.values()):
        return mission.faults
    if mission.faults:
        return (filled(mission.faults[0], values, **names), *mission.faults[1:])
    missing = [name for name in _FAULT if name not in values]
    if missing:
        raise ValueError(f"a mission without a fault needs all of {', '.join(_FAULT)}")
    return (Fault(**{field: values[name] for field, name in names.items() if name in values}),)
