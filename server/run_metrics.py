"""The metrics of a recorded run, from its MCAP file: what is shown is what the file says."""

import logging
from pathlib import Path

from server.run_reader import read_run
from twin.contract import bumpless_pb2 as pb
from twin.metrics import metrics_of

log = logging.getLogger(__name__)


def metrics_of_file(path: Path, run_id: str) -> pb.Metrics | None:
    """Figures of merit of the run, also of an unfinished file; None when nothing was flown in it."""
    try:
        found = read_run(path)
        return None if found is None else metrics_of(*found, run_id)
    except Exception:  # a run is worth keeping without its figures
        log.exception("the metrics of %s could not be computed", path)
        return None
