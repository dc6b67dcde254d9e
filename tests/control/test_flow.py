"""What the allocator is told of the water, and what the operator is shown of it."""

import numpy as np
import pytest

from bumpless import records
from bumpless.config.mission import Mission
from bumpless.config.parameters import with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.control.autopilot import smooth_flow
from bumpless.sim.twin import parameters_for, simulate

DRIFTING = np.array([0.4, 0.03, -0.02, 0.01, 0.02, -0.03])


def seen(drift: float, rates: float) -> np.ndarray:
    settings, a = np.zeros(1, records.SETTINGS)[0], np.zeros(1, records.AUTOPILOT)[0]
    settings["dt"], settings["flow_drift"], settings["flow_rates"] = 0.05, drift, rates
    a["nu_r"] = DRIFTING
    smooth_flow(settings, a)
    assert a["flow"] == pytest.approx(DRIFTING)
    return a["nu_r"].copy()


def test_shares_of_drift_and_turning_are_left_out():
    """Protects: surge is always seen, sway and heave by one share, turning rates by the other."""
    assert seen(1.0, 1.0) == pytest.approx(DRIFTING)
    assert seen(0.0, 1.0) == pytest.approx(DRIFTING * [1, 0, 0, 1, 1, 1])
    assert seen(0.5, 0.0) == pytest.approx(DRIFTING * [1, 0.5, 0.5, 0, 0, 0])


def test_without_either_the_map_is_the_published_one(model):
    """Protects: alpha = delta, so that fins amidships in a drifting hull owe the demand nothing."""
    tau, jacobian = np.zeros(6), np.zeros((6, records.MAX_ACTUATORS))
    still, healthy = np.zeros(records.MAX_ACTUATORS), np.ones(records.MAX_ACTUATORS)
    wrench_map(model, still, still, healthy, DRIFTING, tau, jacobian)
    assert np.abs(tau[4:]).min() > 0.01
    wrench_map(model, still, still, healthy, seen(0.0, 0.0), tau, jacobian)
    assert tau[1:] == pytest.approx(np.zeros(5), abs=1e-12)


def test_the_operator_still_sees_drift(docking: Mission, ts100: Vehicle):
    """Protects: telemetry shows the velocity through water, not the part that the allocator works with."""
    parameters = with_overrides(parameters_for(ts100, docking), {"guidance": {"flow_drift": 0.0}})
    log = simulate(docking, ts100, parameters).log
    assert np.abs(log["nu_r_hat"][:, 2]).max() > 0.01
