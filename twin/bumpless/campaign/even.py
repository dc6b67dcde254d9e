"""Shares spread evenly: any run of flights fills the space of what is drawn better than chance would.

The share that docks is then known better from as many flights, and an interval made for draws at random
holds more often than it says. Source: Owen 1998, scrambled Sobol' points, by SciPy.
"""

from functools import lru_cache

import numpy as np
import numpy.typing as npt

BLOCK = 1024


def even_shares(seed: int, number: int, quantities: int) -> npt.NDArray[np.float64]:
    """(quantities,) shares in [0, 1) of flight `number`, the same whenever it is asked for."""
    return _block(seed, quantities, number // BLOCK)[number % BLOCK]


@lru_cache(maxsize=8)
def _block(seed: int, quantities: int, block: int) -> npt.NDArray[np.float64]:
    from scipy.stats import qmc

    points = qmc.Sobol(quantities, scramble=True, rng=np.random.default_rng([seed, quantities]))
    if block:
        points.fast_forward(block * BLOCK)
    return np.minimum(points.random(BLOCK), 1.0 - 2.0**-53)
