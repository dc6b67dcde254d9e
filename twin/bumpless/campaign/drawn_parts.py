"""Parts of a drawn mission that came with the harder sea: turbidity, wake, sensors' errors, a moving dock.

Each takes a part of the mission and gives it with what was drawn; a part of
which nothing was drawn stays the same object.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from bumpless.config.mission.dock import Motion
from bumpless.config.mission.model import Environment, Target
from bumpless.config.mission.sea import Shelter
from bumpless.config.mission.sensing import Detection, DvlChange, DvlOutage, InsChange, Sensors

Values = Mapping[str, Any]
_SHELTER = Shelter(width_m=1.0)
_STILL = Motion(amplitude_ned_m=(0.0, 0.0, 0.0), period_s=8.0)


def filled(part: Any, values: Values, **names: str) -> Any:
    """The part with its fields from the draw; the same object when none is drawn."""
    found = {field: values[name] for field, name in names.items() if name in values}
    return replace(part, **found) if found else part


def drawn_water(sea: Environment, values: Values) -> Environment:
    """Turbidity, depth of the bottom and the wake of the dock."""
    sea = filled(sea, values, beam_attenuation_per_m="attenuation_per_m", water_depth_m="water_depth_m")
    names = {"width_m": "shelter_width_m", "turbulence": "shelter_turbulence"}
    shelter = filled(sea.shelter or _SHELTER, values, **names)
    return sea if shelter is (sea.shelter or _SHELTER) else replace(sea, shelter=shelter)


def drawn_errors(sensors: Sensors, values: Values) -> Sensors:
    """Errors of camera, inertial navigation and Doppler log, and a time without the bottom."""
    parts: dict[str, tuple[type, dict[str, str]]] = {
        "detection": (
            Detection,
            {"latency_s": "detection_latency_s", "outlier_probability": "detection_outliers",
             "marker_angle_max_deg": "marker_angle_deg"},
        ),
        "ins": (
            InsChange,
            {"heading_drift_degprth": "heading_drift_degprth", "roll_pitch_bias_deg": "roll_pitch_bias_deg"},
        ),
        "dvl": (
            DvlChange,
            {"scale_error": "dvl_scale_error", "water_bias_mps": "dvl_water_bias_mps",
             "dropout_probability": "dvl_dropout"},
        ),
    }  # fmt: skip
    for name, (kind, names) in parts.items():
        before = getattr(sensors, name) or kind()
        part = filled(before, values, **names)
        sensors = sensors if part is before else replace(sensors, **{name: part})
    if values.get("dvl_outage_length_s", 0.0) > 0.0:
        begin, length = values["dvl_outage_at_s"], values["dvl_outage_length_s"]
        sensors = replace(sensors, dvl_outages=(*sensors.dvl_outages, DvlOutage(begin, begin + length)))
    return sensors


def drawn_motion(target: Target, values: Values) -> Target:
    """Heave, and sway across the approach heading, of a hung dock."""
    before = target.motion or _STILL
    motion = filled(before, values, period_s="dock_period_s", phase_deg="dock_phase_deg")
    north, east, down = motion.amplitude_ned_m
    if "dock_sway_m" in values:
        heading = math.radians(target.heading_deg)
        north, east = -values["dock_sway_m"] * math.sin(heading), values["dock_sway_m"] * math.cos(heading)
    down = values.get("dock_heave_m", down)
    motion = replace(motion, amplitude_ned_m=(north, east, down))
    return target if motion == before else replace(target, motion=motion)
