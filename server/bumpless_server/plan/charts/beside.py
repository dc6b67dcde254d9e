"""A mission's depth grid for the command line: beside the mission's file, or in a folder of charts."""

from pathlib import Path

from bumpless.chart import DepthGrid, with_floor
from bumpless.chart.beside import LARGEST, path_beside
from bumpless.config.mission import Mission
from bumpless_server.plan.charts.content import NotAChart, Said
from bumpless_server.plan.charts.read import read_chart
from bumpless_server.plan.charts.store import Charts

ENDINGS = ("", ".asc", ".tif", ".tiff")


def laid(mission: Mission, beside: Path, charts: Path | None = None) -> Mission:
    """The mission with its depth grid: the chart of that name, or a file beside it of any kind that is read.

    Raises NotAChart when there is a file of that name that can't be used.
    """
    if charts is not None:
        mission = Charts(charts).laid(mission)
    for folder in (beside, charts):
        path = path_beside(mission, folder, *ENDINGS) if folder is not None else None
        if path is not None:
            return with_floor(mission, _grid(path, mission.origin is None))
    return mission


def _grid(path: Path, local: bool) -> DepthGrid:
    try:
        if path.stat().st_size > LARGEST:
            raise NotAChart(f"has more than {LARGEST} bytes")
        content = read_chart(path.read_bytes(), Said(local=local))
    except OSError as error:
        raise NotAChart(f"{path.name} cannot be read: {error.strerror}") from error
    except NotAChart as error:
        raise NotAChart(f"{path.name} {error}") from None
    if content.grid is None:
        raise NotAChart(f"{path.name} is {content.format}, not a depth grid")
    return content.grid
