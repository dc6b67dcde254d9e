"""A mission file: read it, or say all that is wrong with it; its published schema."""

from bumpless.config.mission.model import (
    End,
    Environment,
    Leg,
    Mission,
    MissionError,
    Sensors,
    Start,
    Target,
)
from bumpless.config.mission.read import parse_mission
from bumpless.config.mission.schema import mission_json_schema
from bumpless.config.mission.shipped import missions_folder, shipped_mission

__all__ = [
    "End",
    "Environment",
    "Leg",
    "Mission",
    "MissionError",
    "Sensors",
    "Start",
    "Target",
    "mission_json_schema",
    "missions_folder",
    "parse_mission",
    "shipped_mission",
]
