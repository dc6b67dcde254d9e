"""The vehicle and the missions that a campaign names, with what is wrong with them told at its own lines."""

from pathlib import Path
from typing import Any

from bumpless.campaign.mission_text import as_yaml
from bumpless.chart import NotAGrid
from bumpless.chart.beside import beside
from bumpless.config.mission import Mission, MissionError, missions_folder, parse_mission
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.config.yaml_text import YamlText


def vehicle_named(file: YamlText, named: str, folder: Path) -> Vehicle | None:
    """A vehicle by its id, or in a file beside the campaign."""
    beside = folder / named
    try:
        return load_vehicle(str(beside) if beside.suffix == ".toml" else named)
    except (ProblemsError, OSError) as error:
        reason = str(error.problems[0]) if isinstance(error, ProblemsError) else "cannot be read"
        file.refuse("vehicle", named, reason)
        return None


def mission_named(
    file: YamlText, place: str, named: str | dict[str, Any], vehicle: Vehicle | None, folder: Path
) -> Mission | None:
    """A mission written out, in a file beside the campaign, or shipped."""
    if isinstance(named, dict):
        return _written_out(file, place, named, vehicle)
    options = (folder / named, missions_folder() / f"{named}.yaml")
    path = next((path for path in options if path.is_file()), None)
    if path is None:
        file.refuse(place, named, "no such file beside the campaign, and no mission of that name ships")
        return None
    try:
        return beside(parse_mission(path.read_bytes(), path.name, vehicle, any_vehicle=True), path.parent)
    except NotAGrid as error:
        file.refuse(place, named, str(error))
    except OSError:
        file.refuse(place, named, "cannot be read")
    except MissionError as error:
        for problem in error.problems:
            file.refuse(place, named, str(problem))
    return None


def _written_out(
    file: YamlText, place: str, table: dict[str, Any], vehicle: Vehicle | None
) -> Mission | None:
    try:
        return parse_mission(as_yaml(table), file.source, vehicle, any_vehicle=True)
    except MissionError as error:
        for problem in error.problems:
            file.refuse(f"{place}.{problem.field}".rstrip("."), problem.value, problem.rule)
    return None
