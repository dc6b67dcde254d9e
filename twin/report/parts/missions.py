"""Missions that ship with Bumpless: in the repository, or inside the installed package."""

from importlib import resources
from pathlib import Path

from twin.mission import Mission, parse_mission


def shipped_mission(name: str) -> Mission:
    """The mission of that name; FileNotFoundError when none ships."""
    here = Path(str(resources.files("twin"))).parent
    for folder in (here / "missions", here / "server" / "missions"):
        path = folder / f"{name}.yaml"
        if path.is_file():
            return parse_mission(path.read_text(encoding="utf-8"), path.name)
    raise FileNotFoundError(f"no mission {name}")
