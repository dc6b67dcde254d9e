"""What a mission file means, and that one text always gives one mission."""

import hashlib
import pickle
from pathlib import Path

import pytest

from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import Vehicle

MISSIONS = sorted((Path(__file__).parents[3] / "missions").glob("*.yaml"))


def test_a_mission_says_what_its_file_says(good: str, ts100: Vehicle) -> None:
    """Every number lands in its field; what is left out has its documented default."""
    mission = parse_mission(good, "short.yaml", ts100)
    assert (mission.name, mission.vehicle, mission.duration_s, mission.seed) == ("short", "ts100", 60.0, 0)
    assert mission.path_ned_m == ((0.0, 0.0, 2.0), (20.0, 0.0, 2.5))
    assert mission.legs[0].speed_mps == 0.7
    assert mission.environment.current_ned_mps == (0.0, 0.0, 0.0)
    assert mission.environment.wave is None
    assert mission.end.hover_hold_s is None
    assert mission.source == "short.yaml"
    assert mission.sha256 == hashlib.sha256(good.encode()).hexdigest()


def test_the_observation_point_lies_before_the_target(good: str, ts100: Vehicle) -> None:
    """The vehicle hovers `standoff_m` short of the target on the approach heading (90 deg: east)."""
    n, e, d = parse_mission(good, vehicle=ts100).target.observation_point_ned_m
    assert (round(n, 12), round(e, 12), d) == (22.0, -1.5, 2.5)


def test_the_true_target_lies_off_the_planned_one(good: str, ts100: Vehicle) -> None:
    """Plan and observation point keep the planned place; only the simulator uses the offset."""
    assert parse_mission(good, vehicle=ts100).target.true_position_ned_m == (22.0, 0.0, 2.5)
    text = good.replace("standoff_m: 1.5", "standoff_m: 1.5, true_offset_ned_m: [1, -2, 0.5]")
    target = parse_mission(text, vehicle=ts100).target
    assert target.position_ned_m == (22.0, 0.0, 2.5)
    assert target.true_position_ned_m == (23.0, -2.0, 3.0)
    assert target.observation_point_ned_m[2] == 2.5


def test_everything_optional_can_be_given(good: str, ts100: Vehicle) -> None:
    """Environment, sensors, faults, parameters and end are read, in flow and in block style."""
    actuator = ts100.actuators[4].name
    text = good + (
        "seed: 7\n"
        "environment:\n"
        "  current_ned_mps: [-0.1, 0, 0]\n"
        "  current_variation: {std_mps: 0.01, time_constant_s: 30}\n"
        "  wave: {height_m: 0.1, period_s: 4}\n"
        "  disturbance_body_n_nm: [0, 0.5, 0, 0, 0, 0.1]\n"
        "sensors:\n"
        "  noise_scale: 2\n"
        "  detection: {range_max_m: 9}\n"
        "  outages: [{from_s: 10, to_s: 12}]\n"
        f"faults: [{{actuator: {actuator}, at_s: 30, effectiveness: 0.4, blend_s: 2}}]\n"
        "parameters: {hover: {lambda: 0.01}, bumpless: {ramp: false}}\n"
        "end: {hover_hold_s: 10}\n"
    )
    mission = parse_mission(text, vehicle=ts100)
    assert mission.environment.current_variation is not None
    assert mission.environment.wave is not None
    assert mission.environment.wave.direction_deg == 0.0
    assert mission.sensors.detection is not None
    assert mission.sensors.detection.range_max_m == 9.0
    assert mission.sensors.detection.dropout_probability is None
    assert mission.sensors.outages[0].to_s == 12.0
    assert mission.faults[0].effectiveness == 0.4
    assert mission.parameters == {"hover": {"lambda": 0.01}, "bumpless": {"ramp": False}}
    assert mission.end.hover_hold_s == 10.0


def test_null_means_left_out(good: str, ts100: Vehicle) -> None:
    """`wave: null` switches a part off that has no other off."""
    assert parse_mission(good + "environment: {wave: null}\n", vehicle=ts100).environment.wave is None


def test_a_mission_travels_between_processes(good: str, ts100: Vehicle) -> None:
    """Studies send missions to workers: they pickle and stay equal."""
    mission = parse_mission(good, vehicle=ts100)
    assert pickle.loads(pickle.dumps(mission)) == mission


@pytest.mark.parametrize("path", MISSIONS, ids=lambda path: path.stem)
def test_shipped_missions_are_fit_to_fly(path: Path) -> None:
    """Every mission in missions/ passes its own validation and is named like its file."""
    mission = parse_mission(path.read_text(encoding="utf-8"), path.name)
    assert mission.name == path.stem
    assert mission.title
    assert mission.summary
