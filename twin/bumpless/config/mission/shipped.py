"""Missions that ship with Bumpless: beside the sources of a checkout, or inside the installed package."""

from pathlib import Path

from bumpless.config.mission.model import Mission
from bumpless.config.mission.read import parse_mission

PACKAGE = Path(__file__).parents[2]


def missions_folder() -> Path:
    """The folder of the missions that ship."""
    inside = PACKAGE / "missions"
    return inside if inside.is_dir() else PACKAGE.parents[1] / "missions"


def shipped_mission(name: str) -> Mission:
    """The mission of that name; FileNotFoundError when none ships."""
    path = missions_folder() / f"{name}.yaml"
    if not path.is_file():
        raise FileNotFoundError(f"no mission {name}")
    return parse_mission(path.read_bytes(), path.name)
