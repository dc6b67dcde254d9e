"""Open a flight from the files that it was recorded in."""

from collections.abc import Sequence
from pathlib import Path

from bumpless.runs.flight import open_run
from bumpless.runs.joined import Joined
from bumpless.runs.read import check_log
from bumpless.runs.run import Run


def open_flight(paths: Sequence[Path]) -> Run:
    """The run of a flight that was recorded in pieces, given in order; of one alone it is `open_run`.

    Raises ValueError when a file is no MCAP, OSError when one cannot be read.
    """
    if len(paths) == 1:
        return open_run(paths[0])
    for path in paths:
        check_log(path)
    return Run(Joined(tuple(paths)))
