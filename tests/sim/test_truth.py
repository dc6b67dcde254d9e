"""The autopilot knows its plan and what it measures, and nothing of what is true besides."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from bumpless import records
from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.control.allocation.qp import make_handle
from bumpless.control.autopilot import autopilot_step, reset_autopilot
from bumpless.physics.model import build_model
from bumpless.physics.plant import new_work
from bumpless.sim.settings import fill_settings, mode_controls, plan_of, sensors_of
from bumpless.sim.truth import TOLD_OF_FAULTS, tell
from bumpless.sim.twin import Twin, one, simulate
from bumpless_paper.study.plants import draw

MOVED = (Path(__file__).parents[2] / "missions" / "docking_moved_target.yaml").read_text()
HARD = MOVED + (
    "environment:\n"
    "  current_ned_mps: [-0.05, 0.03, 0]\n"
    "  current_variation: {std_mps: 0.01, time_constant_s: 20}\n"
    "  wave: {height_m: 0.05, period_s: 4}\n"
    "  disturbance_body_n_nm: [0, 0, 0.1, 0, 0.05, 0]\n"
    "sensors: {noise_scale: 2, outages: [{from_s: 40, to_s: 41}]}\n"
    "faults: [{actuator: n_p, at_s: 30, effectiveness: 0.5, blend_s: 2}]\n"
)
CYCLES = 1400


def flown(mission, vehicle, parameters):
    """A twin that has been started, its measurements and its commands, cycle by cycle."""
    twin = Twin(vehicle, parameters)
    twin.start(mission, seed=3, parameters=parameters, alter=draw(5))
    heard, said = np.zeros(CYCLES, records.MEASUREMENT), np.zeros((CYCLES, records.MAX_ACTUATORS))
    modes = set()
    for k in range(CYCLES):
        row = twin.step()
        heard[k], said[k] = twin._m[0], row["u"]
        modes.add(int(row["mode"]))
    assert modes == {0, 1, 2}
    return twin, heard, said


@pytest.mark.parametrize("fault_tolerant", [False, True])
def test_commands_follow_from_measurements_and_plan_alone(ts100, fault_tolerant):
    """Protects: with no truth at hand, its own model, a plan without what it was not told and sensors of
    which it knows place and rate only, the autopilot gives the very commands of the simulated flight."""
    mission = parse_mission(HARD, "hard.yaml", ts100)
    base = default_parameters(ts100)
    parameters = replace(base, allocation=replace(base.allocation, fault_tolerant=fault_tolerant))
    twin, heard, said = flown(mission, ts100, parameters)

    settings, modes = one(records.SETTINGS), mode_controls(parameters)
    plan = plan_of(mission, ts100.control_period_s)
    fill_settings(settings, ts100, parameters)
    tell(twin._truth, plan)
    if not fault_tolerant:
        for name in TOLD_OF_FAULTS:
            plan[0][name] = np.nan if plan[name].dtype.kind == "f" else -1_000_000
    sensors = sensors_of(ts100, mission)
    known = ("dvl_period", "camera_period", "camera_position", "camera_pitch")
    for name in set(records.SENSORS.names or ()) - set(known):
        sensors[0][name] = np.nan
    model = build_model(ts100)
    model["smoothing"] = parameters.allocation.shaft_smoothing
    a, w, work = one(records.AUTOPILOT), one(records.ALLOCATION_WORK), new_work()
    handle = make_handle(parameters.allocation.solver)
    reset_autopilot(modes, plan[0], model, a[0])
    for k in range(CYCLES):
        autopilot_step(handle, settings[0], modes, sensors[0], plan[0], model, heard[k], a[0], w[0], 0, work)
        assert np.array_equal(a[0]["u"], said[k]), k
    assert np.isfinite(said).all()


@pytest.mark.parametrize("offset", ["[1.0, 1.5, 0.2]", "[-1.0, 1.0, 0.1]", "[2.0, -2.0, -0.3]"])
@pytest.mark.parametrize("seed", [1, 2])
def test_docks_at_a_target_off_its_planned_place(ts100, offset, seed):
    """Protects: what the camera sees moves the estimate, the path and the hover point to the true target."""
    mission = parse_mission(MOVED.replace("[1.0, 1.5, 0.2]", offset), "moved.yaml", ts100)
    log = simulate(mission, ts100, seed=seed).log
    first = int(np.argmax(log["detected_raw"]))
    planned = np.array(mission.target.position_ned_m)
    assert np.array_equal(log["target"][:first, :3], np.tile(planned, (first, 1)))
    assert log["target_true"][0] == pytest.approx(mission.target.true_position_ned_m)
    assert np.linalg.norm(log["target"][-1, :3] - log["target_true"][-1]) < 0.3
    assert log["mode"][-1] == records.HOVER
    assert log["range_true"][-200:].max() < 0.3
    assert np.abs(log["eta"][-200:, 2] - log["target_true"][-200:, 2]).max() < 0.1


def test_an_unseen_target_is_looked_for_where_the_plan_has_it(ts100):
    """Protects: the planned place and only that leads the vehicle until the camera has found the target."""
    blind = MOVED + "sensors: {outages: [{from_s: 0, to_s: 100}]}\n"
    flights = [
        simulate(parse_mission(text, "blind.yaml", ts100), ts100)
        for text in (blind, blind.replace("[1.0, 1.5, 0.2]", "[0, 0, 0]"))
    ]
    assert np.array_equal(flights[0].log["u"], flights[1].log["u"])
    assert np.array_equal(flights[0].log["target"], flights[1].log["target"])
    assert not np.array_equal(flights[0].log["range_true"], flights[1].log["range_true"])
