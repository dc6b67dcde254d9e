"""A mission that is flown live over a stored depth grid is recorded with it."""

from collections.abc import Callable

import numpy as np

from bumpless.chart import DepthGrid, from_bytes
from bumpless.config.mission import missions_folder
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.console import Console
from bumpless_server.plan.charts.content import Said
from bumpless_server.settings import Settings

GRID = b"ncols 2\nnrows 2\nxllcorner -100\nyllcorner -100\ncellsize 200\nnodata_value -9999\n9 9\n9 9\n"


def test_the_recorder_finds_the_grid_that_the_plan_names(make_settings: Callable[..., Settings]) -> None:
    """Protects: the grid as it is stored as the mission begins; one without, or junk, costs no run."""
    console = Console(make_settings(manage_node=False))
    console.data.open()
    try:
        console.charts.put("shoal", GRID, "shoal.asc", Said(local=True))
        text = (missions_folder() / "docking.yaml").read_text()
        over = text + "\nsea_floor: {grid: shoal, clearance_m: 1}\n"

        def depths(yaml: str) -> bytes | None:
            return console._depths_of(pb.Plan(file_name="docking.yaml", mission_yaml=yaml))

        found = depths(over)
        assert found is not None and isinstance(grid := from_bytes(found), DepthGrid)
        assert grid.at(np.array([0.0]), np.array([0.0])) == 9.0
        assert depths(text) is None and depths("nonsense") is None
        assert depths(over.replace("shoal", "elsewhere")) is None
    finally:
        console.data.close()
