"""Missions to begin from, for whichever vehicle is wanted."""

import re
from dataclasses import dataclass
from pathlib import Path

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.vehicle import Vehicle

FOLDER = Path(__file__).with_name("template")
_VEHICLE = re.compile(r"^vehicle: .*$", re.MULTILINE)


@dataclass(frozen=True)
class Template:
    """A mission that is whole, to be changed."""

    name: str
    title: str
    summary: str
    vehicle: str
    yaml: str


def templates(vehicle: str = "ts100", known: Vehicle | None = None) -> list[Template]:
    """Every template that this vehicle can read; `known`: the vehicle itself, when no file of ours has it."""
    found = []
    for path in sorted(FOLDER.glob("*.yaml")):
        text = _VEHICLE.sub(f"vehicle: {vehicle}", path.read_text(encoding="utf-8"), count=1)
        try:
            mission = parse_mission(text, path.name, known)
        except MissionError:
            continue
        found.append(Template(path.stem, mission.title, mission.summary, vehicle, text))
    return found
