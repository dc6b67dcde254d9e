"""The metrics of a recorded run, from its MCAP file."""

from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import metrics_of
from bumpless_server.runs.run_data import read_run


def metrics_of_file(path: Path, run_id: str) -> pb.Metrics | None:
    """Metrics of a log, also of one that is still being written (flush it first) or was cut.

    None when the file holds no cycle of a mission or no usable vehicle description.
    Raises ValueError when it is not MCAP.
    """
    data = read_run(path)
    if data.vehicle is None or len(data.run) == 0:
        return None
    return metrics_of(data.run, data.vehicle, run_id)
