"""What Dask runs as it starts one of our worker processes."""

import signal
from typing import Any


def dask_setup(worker: Any) -> None:
    """Leave Ctrl-C, which a terminal sends to every process, to the one that started the workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
