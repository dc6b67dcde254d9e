"""What the allocator is told of the water, and what the operator is shown of it."""

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.mission import Mission
from bumpless.config.parameters import with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.control.flow import see_flow, smooth_flow
from bumpless.control.guidance.record import GUIDANCE_SETTINGS
from bumpless.sim.twin import parameters_for, simulate

DRIFTING = np.array([0.4, 0.03, -0.02, 0.01, 0.02, -0.03])


def seen(drift: float, rates: float) -> np.ndarray:
    settings = np.zeros(1, GUIDANCE_SETTINGS)[0]
    settings["flow_drift"], settings["flow_rates"] = drift, rates
    smooth, nu_flow = np.zeros(6), np.zeros(6)
    smooth_flow(0.05, settings, True, DRIFTING, smooth)
    assert smooth == pytest.approx(DRIFTING)
    see_flow(settings, smooth, nu_flow)
    return nu_flow


def test_shares_of_drift_and_turning_are_left_out():
    """Protects: surge is always seen, sway and heave by one share, turning rates by the other."""
    assert seen(1.0, 1.0) == pytest.approx(DRIFTING)
    assert seen(0.0, 1.0) == pytest.approx(DRIFTING * [1, 0, 0, 1, 1, 1])
    assert seen(0.5, 0.0) == pytest.approx(DRIFTING * [1, 0.5, 0.5, 0, 0, 0])


def test_without_either_the_map_is_the_published_one(model):
    """Protects: alpha = delta, so that fins amidships in a drifting hull owe the demand nothing."""
    tau, jacobian = np.zeros(6), np.zeros((6, MAX_ACTUATORS))
    still, healthy = np.zeros(MAX_ACTUATORS), np.ones(MAX_ACTUATORS)
    wrench_map(model, still, still, healthy, DRIFTING, tau, jacobian)
    assert np.abs(tau[4:]).min() > 0.01
    wrench_map(model, still, still, healthy, seen(0.0, 0.0), tau, jacobian)
    assert tau[1:] == pytest.approx(np.zeros(5), abs=1e-12)


def test_the_operator_still_sees_drift(docking: Mission, ts100: Vehicle):
    """Protects: telemetry shows the velocity through water, not the part that the allocator works with."""
    parameters = with_overrides(parameters_for(ts100, docking), {"guidance": {"flow_drift": 0.0}})
    log = simulate(docking, ts100, parameters).log
    assert np.abs(log["nu_r_hat"][:, 2]).max() > 0.01
