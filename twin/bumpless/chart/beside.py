"""A mission's depth grid in the folder of its file."""

from pathlib import Path

from bumpless.chart.esri import read_esri
from bumpless.chart.floor import with_floor
from bumpless.chart.grid import DepthGrid, NotAGrid
from bumpless.config.mission import Mission

LARGEST = 64_000_000  # bytes
ENDINGS = ("", ".asc")


def beside(mission: Mission, folder: Path) -> Mission:
    """The mission with the ESRI ASCII grid of the name that it gives, where it lies in the folder.

    x and y are longitude and latitude where the mission has an origin, else m east and north.
    Raises NotAGrid when there is a file of that name that can't be used.
    """
    path = path_beside(mission, folder, *ENDINGS)
    if path is None:
        return mission
    return with_floor(mission, _read(path, mission.origin is not None))


def path_beside(mission: Mission, folder: Path, *endings: str) -> Path | None:
    """The file in the folder that a mission names as its depth grid, with one of these endings or none."""
    said = mission.sea_floor
    if said is None or not said.grid or mission.depth_grid is not None:
        return None
    return next((path for end in endings if (path := folder / (said.grid + end)).is_file()), None)


def _read(path: Path, geographic: bool) -> DepthGrid:
    try:
        if path.stat().st_size > LARGEST:
            raise NotAGrid(f"has more than {LARGEST} bytes")
        return read_esri(path.read_text(encoding="utf-8-sig"), geographic)
    except (OSError, ValueError) as error:
        raise NotAGrid(f"{path.name} {error}") from error
