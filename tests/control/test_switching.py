"""Proposition 1 on random missions, seeds, gains and switches, and the three mechanisms each alone."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.contract.enums import COMPLETED, HOVER, RUNNING
from bumpless.sim.log import LOG
from bumpless.sim.twin import Twin, simulate


def assert_proposition_1(log, model, ramps_only=True):
    """Every increment within its bound; every step of tau_d within what one cycle of the ramp allows."""
    n = int(model["n_u"])
    du = np.abs(np.diff(log["u"][:, :n], axis=0))
    assert (du <= log["du_max"][1:, :n] * (1 + 1e-9) + 1e-12).all()
    low, high = model["command_min"][:n], model["command_max"][:n]
    assert (log["u"][:, :n] >= low - 1e-12).all() and (log["u"][:, :n] <= high + 1e-12).all()
    kappa = log["kappa"]
    step = np.abs(np.diff(log["tau_d"], axis=0))
    ramp = np.abs(np.diff(kappa))[:, None] * np.abs(log["tau_plus"][1:] - log["tau_minus"][1:])
    new_ramp = np.diff(kappa) < 0
    change = kappa[1:, None] * np.abs(np.diff(log["tau_plus"], axis=0))
    # in the first cycle of a ramp tau_d is frozen: no step at all
    allowed = np.where(
        new_ramp[:, None], kappa[1:, None] * np.abs(log["tau_plus"][1:] - log["tau_minus"][1:]), ramp + change
    )
    if ramps_only:
        assert (step <= allowed + 1e-9).all()


random_parameters = st.fixed_dictionaries(
    {
        "scale": st.floats(0.2, 4.0),
        "lam": st.floats(1e-6, 0.1),
        "ramp": st.integers(1, 120),
        "q": st.floats(0.05, 50.0),
        "align": st.booleans(),
        "project": st.booleans(),
        "fr": st.floats(4.0, 10.0),
        "dwell": st.integers(0, 80),
        "seed": st.integers(0, 2**31),
        "current": st.tuples(st.floats(-0.15, 0.15), st.floats(-0.1, 0.1)),
        "outage": st.floats(15.0, 50.0),
    }
)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(random_parameters)
def test_commands_and_demand_never_jump(ts100, model, docking, x):
    """Protects: Proposition 1 of Gao et al. 2026, whatever the tuning, the sea and the order of switches."""
    base = default_parameters(ts100)
    changed = [
        replace(
            mode,
            kp=tuple(x["scale"] * g for g in mode.kp),
            kd=tuple(x["scale"] * g for g in mode.kd),
            q_diagonal=tuple(x["q"] * q for q in mode.q_diagonal),
            lambda_=x["lam"],
            ramp_cycles=x["ramp"],
        )
        for mode in base.modes
    ]
    parameters = replace(
        base,
        forward=changed[0],
        reverse=changed[1],
        hover=changed[2],
        supervisor=replace(base.supervisor, range_fr_lower_m=x["fr"], dwell_cycles=x["dwell"]),
        bumpless=replace(base.bumpless, integrator_alignment=x["align"], warm_start_projection=x["project"]),
    )
    text = docking.text.replace("seed: 1", f"seed: {x['seed']}") + (
        f"\nenvironment:\n  current_ned_mps: [{x['current'][0]}, {x['current'][1]}, 0.0]\n"
        f"sensors:\n  outages:\n    - {{from_s: {x['outage']}, to_s: {x['outage'] + 6}}}\n"
    )
    mission = parse_mission(text, "random.yaml", ts100)
    assert_proposition_1(simulate(mission, ts100, parameters).log, model)


def test_parameters_changed_in_flight_are_blended_in(ts100, model, docking):
    """Protects: an operator's new weights and gains enter over the ramp, not as a step."""
    twin = Twin(ts100)
    twin.start(docking, seed=3)
    rows = [twin.step().copy() for _ in range(300)]
    base = twin.parameters
    bold = replace(
        base.forward,
        kp=tuple(3 * g for g in base.forward.kp),
        q_diagonal=(9.0, 0.0, 9.0, 9.0, 9.0, 9.0),
        lambda_=0.05,
    )
    twin.set_parameters(replace(base, forward=bold))
    rows += [twin.step().copy() for _ in range(120)]
    log = np.array(rows, dtype=LOG)
    assert log["kappa"][300] == 0.0 and log["kappa"][-1] == 1.0
    assert_proposition_1(log, model)


def test_pause_holds_and_resume_goes_on(ts100, model, docking):
    """Protects: a paused vehicle holds station with the supervisor frozen, and finishes after resuming."""
    twin = Twin(ts100)
    twin.start(docking, seed=3)
    for _ in range(200):
        twin.step()
    twin.pause()
    held = np.array([twin.step().copy() for _ in range(1200)])
    assert (held["mode"] == held["mode"][0]).all()
    spread = np.linalg.norm(held["eta"][-200:, :2] - held["eta"][-1, :2], axis=1)
    assert spread.max() < 0.3
    twin.resume()
    rest = np.array([twin.step().copy() for _ in range(1400)])
    assert rest["mode"][-1] == HOVER
    assert_proposition_1(np.concatenate([held, rest]), model)


def test_abort_brings_every_actuator_to_rest_within_its_bounds(ts100, model, docking):
    """Protects: an abort is fast but never violates an increment bound."""
    twin = Twin(ts100)
    twin.start(docking, seed=3)
    rows = [twin.step().copy() for _ in range(400)]
    twin.abort("test")
    rows += [twin.step().copy() for _ in range(100)]
    log = np.array(rows, dtype=LOG)
    assert_proposition_1(log, model, ramps_only=False)
    assert not log["u"][-1].any()


def test_the_published_flight_switches_where_the_paper_does(published, ts100):
    """Protects: F to R near 24 s and R to H near 46 s, ending at the observation point."""
    flight = simulate(published, ts100)
    switches = {e.details["to"]: e.time_s for e in flight.events if e.code == "mode_switch"}
    assert switches["reverse"] == pytest.approx(24.0, abs=1.5)
    assert switches["hover"] == pytest.approx(46.0, abs=2.5)
    assert flight.log["range_true"][-1] < 0.3
    assert abs(flight.log["eta"][-1, 2] - 2.3) < 0.15


def test_same_seed_same_bytes_and_live_equals_batch(ts100, docking, flight):
    """Protects: a seed fixes a run to the bit, whatever was flown before it, and the live node flies what
    the batch flies."""
    twin = Twin(ts100)
    twin.start(docking, seed=9)
    for _ in range(600):
        twin.step()
    twin.abort("another run is to follow")
    twin.step()
    twin.start(docking)
    for k in range(len(flight.log)):
        row, want = twin.step().copy(), flight.log[k].copy()
        row["solve_time"] = want["solve_time"] = 0.0
        assert row.tobytes() == want.tobytes(), f"cycle {k}"
    assert flight.events[-1].code == "mission_completed"
    again = simulate(docking, ts100)
    for name in LOG.names or ():
        if name != "solve_time":
            assert again.log[name].tobytes() == flight.log[name].tobytes(), name


def test_a_pause_does_not_use_up_the_mission(ts100, docking):
    """Protects: a mission paused for longer than its duration goes on after it, for the rest of its time."""
    twin = Twin(ts100)
    twin.start(docking)
    for _ in range(100):
        twin.step()
    twin.pause()
    for _ in range(2000):
        twin.step()
    twin.resume()
    for _ in range(1600):
        twin.step()
    assert twin.phase == RUNNING
    for _ in range(110):
        twin.step()
    told = [event.code for event in twin.drain_events()]
    assert twin.phase == COMPLETED and told[-2:] == ["mission_completed", "holding_station"]


def test_the_autopilot_sees_measurements_only(ts100, docking, flight):
    """Protects: no shortcut through truth: with noise the estimate differs from it in every channel."""
    log = flight.log[50:]
    assert (np.abs(log["eta_hat"] - log["eta"]).max(axis=0) > 0).all()
    assert (np.abs(log["nu_hat"] - log["nu"]).max(axis=0) > 0).all()
