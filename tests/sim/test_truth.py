"""The autopilot knows its plan and what it measures, and nothing of what is true besides."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import HOVER, MODES, RUNNING
from bumpless.control.allocation.qp import make_handle
from bumpless.control.autopilot import autopilot_cycle
from bumpless.control.onboard import ONBOARD
from bumpless.control.reset import reset_state
from bumpless.physics.model import build_model
from bumpless.physics.sensors import MEASUREMENT, SENSORS
from bumpless.sim.settings import fill_settings, plan_of, sensors_of
from bumpless.sim.truth import tell
from bumpless.sim.twin import Twin, one, simulate
from bumpless_paper.study.plants import draw

MISSIONS = Path(__file__).parents[2] / "missions"
MOVED = (MISSIONS / "docking_moved_target.yaml").read_text()
HARD = MOVED + (
    "environment:\n"
    "  current_ned_mps: [-0.07, 0.002, 0]\n"
    "  current_variation: {std_mps: 0.01, time_constant_s: 20}\n"
    "  wave: {height_m: 0.05, period_s: 4}\n"
    "  disturbance_body_n_nm: [0, 0, 0.1, 0, 0.05, 0]\n"
    "sensors: {noise_scale: 2, outages: [{from_s: 40, to_s: 41}]}\n"
    "faults: [{actuator: n_p, at_s: 30, effectiveness: 0.9, blend_s: 2}]\n"
)
CYCLES = 2400


def flown(mission, vehicle, parameters):
    """A twin that has been started, its measurements and its commands, cycle by cycle."""
    twin = Twin(vehicle, parameters)
    twin.start(
        mission, seed=3, parameters=parameters, alter=replace(draw(5), current_along=0.0, current_across=0.0)
    )
    heard, said = np.zeros(CYCLES, MEASUREMENT), np.zeros((CYCLES, MAX_ACTUATORS))
    modes = set()
    for k in range(CYCLES):
        row = twin.step()
        heard[k], said[k] = twin.world["measurement"], row["u"]
        modes.add(int(row["mode"]))
    assert modes == set(MODES)
    return twin, heard, said


@pytest.mark.parametrize("fault_tolerant", [False, True])
def test_commands_follow_from_measurements_and_plan_alone(ts100, fault_tolerant):
    """Protects: with no truth at hand, its own model, a plan without what it was not told and sensors of
    which it knows place and rate only, the autopilot gives the very commands of the simulated flight."""
    mission = parse_mission(HARD, "hard.yaml", ts100)
    base = default_parameters(ts100)
    parameters = replace(base, allocation=replace(base.allocation, fault_tolerant=fault_tolerant))
    twin, heard, said = flown(mission, ts100, parameters)

    onboard = one(ONBOARD)[0]
    fill_settings(onboard["settings"], ts100, parameters)
    onboard["plan"] = plan_of(mission, ts100)[0]
    tell(twin.world["truth"], onboard["plan"])
    if not fault_tolerant:
        spoil(onboard["plan"]["faults"])
    sensors = sensors_of(ts100, mission)[0]
    known = {"dvl_period", "camera_period", "camera_position", "camera_pitch", "camera_latency"}
    known |= {"camera_range_std", "camera_bearing_std", "usbl_period"}
    for name in set(SENSORS.names or ()) - known:
        sensors[name] = np.nan if SENSORS[name].base.kind == "f" else 0
    onboard["sensors"], onboard["model"] = sensors, build_model(ts100)
    onboard["model"]["smoothing"] = parameters.allocation.shaft_smoothing
    onboard["model"]["fins_coast"] = not parameters.allocation.fins_brake
    handle = make_handle(parameters.allocation.solver)
    reset_state(onboard["settings"], onboard["plan"], onboard["state"])
    onboard["orders"]["phase"] = RUNNING
    for k in range(CYCLES):
        autopilot_cycle(handle, onboard, heard[k])
        assert np.array_equal(onboard["state"]["allocation"]["u"], said[k]), k
    assert np.isfinite(said).all()


@pytest.mark.parametrize("name", ["docking_current", "s7_fault_estimated"])
def test_what_is_no_state_has_no_memory(name):
    """Protects: linearisation, reset and pause take `state` for all that a cycle leaves to the next: whatever
    else is written over between cycles, paused ones too, the flight is the same."""
    text = (MISSIONS / f"{name}.yaml").read_text()
    mission = parse_mission(text, f"{name}.yaml")
    plain, spoilt = (Twin(load_vehicle(mission.vehicle)) for _ in range(2))
    plain.start(mission)
    spoilt.start(mission)
    for k in range(CYCLES):
        if k in (300, 420):
            for twin in (plain, spoilt):
                twin.pause() if k == 300 else twin.resume()
        spoil(spoilt.onboard["output"])
        spoil(spoilt.onboard["scratch"])
        row, other = plain.step(), spoilt.step()
        row["solve_time"] = other["solve_time"] = 0.0
        assert row.tobytes() == other.tobytes(), k
    assert len(set(MODES) & {int(row["mode"]), int(row["previous_mode"])}) == 2


def spoil(record):
    """Overwrite every number of a nested record with one that would be noticed."""
    for name in record.dtype.names:
        if record.dtype[name].names:
            spoil(record[name])
        else:
            record[name] = np.nan if record.dtype[name].base.kind == "f" else -1_000_000


@pytest.mark.parametrize("offset", ["[1.0, 1.5, 0.2]", "[-1.0, 1.0, 0.1]", "[2.0, -2.0, -0.3]"])
@pytest.mark.parametrize("seed", [1, 2])
def test_docks_at_a_target_off_its_planned_place(ts100, offset, seed):
    """Protects: what the camera sees moves the estimate, the path and the hover point to the true target."""
    mission = parse_mission(
        MOVED.replace("[1.0, 1.5, 0.2]", offset).replace("duration_s: 240", "duration_s: 300"),
        "moved.yaml",
        ts100,
    )
    log = simulate(mission, ts100, seed=seed).log
    first = int(np.argmax(log["detected_raw"]))
    planned = np.array(mission.target.position_ned_m)
    assert np.array_equal(log["target"][:first, :3], np.tile(planned, (first, 1)))
    assert log["target_true"][0] == pytest.approx(mission.target.true_position_ned_m)
    assert np.linalg.norm(log["target"][-1, :3] - log["target_true"][-1]) < 0.3
    assert log["mode"][-1] == HOVER
    assert log["range_true"][-200:].max() < 0.3
    assert np.abs(log["eta"][-200:, 2] - log["target_true"][-200:, 2]).max() < 0.1


def test_an_unseen_target_is_looked_for_where_the_plan_has_it(ts100):
    """Protects: the planned place and only that leads the vehicle until the camera has found the target."""
    blind = MOVED + "sensors: {outages: [{from_s: 0, to_s: 240}]}\n"
    flights = [
        simulate(parse_mission(text, "blind.yaml", ts100), ts100)
        for text in (blind, blind.replace("[1.0, 1.5, 0.2]", "[0, 0, 0]"))
    ]
    assert np.array_equal(flights[0].log["u"], flights[1].log["u"])
    assert np.array_equal(flights[0].log["target"], flights[1].log["target"])
    assert not np.array_equal(flights[0].log["range_true"], flights[1].log["range_true"])
