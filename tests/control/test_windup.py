"""Integral action: drained only where a bound keeps the wrench from being delivered, aligned to the cycle."""

from dataclasses import replace

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.contract.enums import FORWARD
from bumpless.control.allocation.bounds import command_bounds, limited_channels
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.control.pid import ERRORS, PID_STATE, demand, note_unmet
from bumpless.control.schedule import GAINS, schedule_gains
from bumpless.control.settings import SETTINGS
from bumpless.sim.twin import parameters_for, simulate

N = MAX_ACTUATORS
SURGE, HEAVE, ROLL, PITCH, YAW = 0, 2, 3, 4, 5
PROPELLER, FINS = 4, range(4)


def limited_by(model, at_bound):
    """Channels that are limited at 0.5 m/s when these actuators are at their increment bound."""
    flow, jacobian, limited = np.array([0.5, 0, 0, 0, 0, 0.0]), np.zeros((6, N)), np.zeros(6, np.int64)
    wrench_map(model, np.zeros(N), np.zeros(N), np.ones(N), flow, np.zeros(6), jacobian)
    u, lower, upper = np.zeros(N), np.zeros(N), np.zeros(N)
    command_bounds(model, u, 0.05, lower, upper, np.zeros(N))
    for i in at_bound:
        u[i] = upper[i]
    limited_channels(model, u, lower, upper, jacobian, limited)
    return set(np.flatnonzero(limited).tolist())


def test_a_bound_limits_the_channels_on_which_its_actuator_has_authority(model):
    """Protects: a propeller at full thrust says nothing about yaw, nor a fin at its rate about surge."""
    assert limited_by(model, ()) == set()
    assert limited_by(model, (PROPELLER,)) == {SURGE, ROLL}  # roll by its shaft's torque
    by_fins = limited_by(model, FINS)
    assert {ROLL, PITCH, YAW} <= by_fins and SURGE not in by_fins


def test_only_a_limited_channel_is_drained(model):
    """Protects: back-calculation of one channel leaves the integrals of the others to their errors."""
    s, pid, gains, errors = (np.zeros(1, d)[0] for d in (SETTINGS, PID_STATE, GAINS, ERRORS))
    mode, limited = s["modes"][0], np.zeros(6, np.int64)
    s["dt"], s["allocation"]["anti_windup"] = 0.05, 1.0
    mode["K_I"], mode["integral_limit"], mode["demand_limit"] = 1.0, 10.0, 100.0
    pid["integral"] = 2.0
    limited[SURGE] = 1
    note_unmet(np.full(6, 5.0), np.ones(6), limited, pid)
    schedule_gains(s, mode, 1.0, 0.0, 1.0, gains)
    demand(gains, errors, pid, np.zeros(6))
    assert pid["integral"][SURGE] == pytest.approx(2.0 - 0.05 * 4.0)
    assert (pid["integral"][1:] == 2.0).all()


def test_aligned_demand_equals_the_wrench_before_the_switch(ts100, published):
    """Protects: eq. (56) with the gains of the very cycle of the switch, though speed and so the schedule
    have changed since the last; without bleed and anti-windup nothing else moves the aligned channels."""
    base = parameters_for(ts100, published)
    parameters = replace(
        base,
        bumpless=replace(base.bumpless, integrator_alignment=True, align_bleed_s=0.0, scale_integration=True),
        allocation=replace(base.allocation, anti_windup_per_s=0.0),
    )
    log = simulate(published, ts100, parameters).log
    switches = np.flatnonzero(np.diff(log["mode"])) + 1
    assert len(switches) == 2
    for k in switches:
        gains = parameters.modes[log["mode"][k] - FORWARD]
        for i in np.flatnonzero(base.bumpless.align_channels):
            if gains.ki[i] > 0.0 and abs(log["integral"][k, i]) < 0.999 * gains.integral_limit[i]:
                assert log["tau_plus"][k, i] == pytest.approx(log["tau_c"][k - 1, i], abs=1e-9), (k, i)
