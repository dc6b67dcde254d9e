"""How well the references were followed: errors about the reference, not about a stay's own mean."""

from dataclasses import dataclass

import numpy as np

from bumpless.metrics.columns import Columns, Floats
from bumpless.metrics.errors import wrapped_deg


@dataclass(frozen=True)
class Tracking:
    """RMS about zero and largest magnitude of (depth m, cross-track m, heading deg, surge speed m/s)."""

    rms: Floats  # (4,)
    largest: Floats  # (4,)


def tracking(run: Columns, rows: np.ndarray | slice) -> Tracking:
    """Over these rows; as believed, for that is what the loop can answer for. Surge is over ground."""
    error = np.stack(
        [
            run.eta_hat[rows, 2] - run.reference[rows, 2],
            run.cross_track[rows],
            wrapped_deg(run.eta_hat[rows, 5] - run.reference[rows, 5]),
            run.nu_hat[rows, 0] - run.reference[rows, 0],
        ],
        axis=1,
    )
    return Tracking(np.sqrt(np.mean(error**2, axis=0)), np.abs(error).max(axis=0))
