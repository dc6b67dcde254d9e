"""Runs made up cycle by cycle, so that every figure can be worked out by hand."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.contract.enums import FORWARD, SOLVED
from bumpless.metrics import Columns

N_U = 7


@pytest.fixture(scope="session")
def ts100() -> Vehicle:
    """Four fins (15 deg), one propeller and two verticals (200 rpm), 20 Hz."""
    return load_vehicle("ts100")


def quiet(n: int, **columns: Any) -> Columns:
    """n cycles in F in which nothing happens, with some columns replaced."""
    base: dict[str, Any] = {
        "time": 0.05 * np.arange(n),
        "cycle": np.arange(100, 100 + n),
        "mode": np.full(n, FORWARD),
        "kappa": np.ones(n),
        "range": np.linspace(10.0, 1.0, n),
        "depth": np.full(n, 2.0),
        "status": np.full(n, SOLVED),
        "solve_time": np.full(n, 20e-6),
    }
    base |= {name: np.zeros((n, 6)) for name in ("eta_hat", "nu_hat", "tau_d", "tau_plus", "tau_minus")}
    base |= {name: np.zeros(n, np.int64) for name in ("stage", "tried", "reason")}
    base |= {"nu_r_hat": np.zeros((n, 3)), "reference": np.zeros((n, 6))}
    base |= {"cross_track": np.zeros(n), "approach": np.zeros(n)}
    base |= {name: np.zeros((n, 6)) for name in ("tau_c", "tau", "eta", "nu")}
    base |= {
        "observation_point": np.zeros((n, 3)),
        "target": np.zeros((n, 4)),
        "target_true": np.zeros((n, 3)),
    }
    base |= {"u": np.zeros((n, N_U)), "u_feedback": np.zeros((n, N_U)), "du_max": np.full((n, N_U), 0.02)}
    return Columns(**(base | columns))


@pytest.fixture
def make_run() -> Callable[..., Columns]:
    """See `quiet`."""
    return quiet
