"""A dock to enter in the plant: closed forms of the impact, whole flights into it, and what ends them."""

from pathlib import Path

import numpy as np
import pytest

from bumpless.campaign.page.capture import picture_of
from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import BACK, CAPTURED, CREEP, OFF_HEADING, OFF_LINE
from bumpless.jit import jit
from bumpless.metrics.capture import capture_of
from bumpless.metrics.columns import Columns
from bumpless.metrics.outcome import Ending, outcome_of
from bumpless.physics.faults import FAULTS
from bumpless.physics.model import build_model
from bumpless.physics.plant import PLANT, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.sim.capture_map import capture_map
from bumpless.sim.truth import truth_of
from bumpless.sim.twin import simulate
from bumpless_paper.study.docks.hung import row

TS100 = load_vehicle("ts100")
TEXT = (Path(__file__).parents[2] / "missions" / "docking_funnel.yaml").read_text()


def mission(*changes: tuple[str, str]):
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return parse_mission(text, "docking_funnel.yaml", TS100)


@pytest.fixture(scope="module")
def flown():
    return simulate(mission(), TS100)


def free_hull():
    """TS-100 without drag, a hull of mass m_11 on a line."""
    model = build_model(TS100)
    for name in ("D_linear", "D_quadratic", "D_lift", "C_D0", "T_nv", "Q_nv"):
        model[name] = 0.0
    return model


def sea(damping=0.0, friction=0.0, captured=0):
    truth = truth_of(mission(), TS100)[0]
    environment = np.zeros(1, truth.dtype["environment"])[0]
    dock = truth["environment"]["dock"]
    dock["damping"], dock["friction"], dock["period"], dock["captured"] = damping, friction, 0.0, captured
    environment["dock"] = dock
    return environment


@jit
def coast(model, environment, faults, plant, dt, substeps, steps, noise, out):
    """Fill out (steps, 3): nose depth, surge, peak force of each step."""
    for i in range(steps):
        step_plant(model, environment, faults, plant, noise, dt, substeps, noise)
        out[i, 0], out[i, 1] = environment.dock.felt.nose_depth, plant.nu[0]
        out[i, 2] = environment.dock.felt.peak


def run_in(environment, speed: float, nose_depth: float, steps=200, dt=0.05, substeps=2) -> np.ndarray:
    model, plant = free_hull(), np.zeros(1, PLANT)[0]
    plant["eta"][:3] = environment["dock"]["entry"]
    plant["eta"][0] += nose_depth - model["rings"]["x"][0]
    plant["nu"][0], plant["effectiveness"] = speed, 1.0
    out = np.zeros((steps, 3))
    coast(model, environment, np.zeros(1, FAULTS)[0], plant, dt, substeps, steps, np.zeros(N_NOISE), out)
    return out


def test_stop_throws_a_hull_back_with_the_speed_and_the_force_of_a_spring():
    """Protects: the plant feels contact at its own step: peak v sqrt(k m), energy back to 2 %."""
    environment = sea()
    environment["dock"]["capture_depth"] = 9.0  # no latch
    out, model = run_in(environment, 0.2, 0.9), free_hull()
    m = float(model["M_RB"][0, 0] + model["M_A"][0, 0])
    assert out[:, 2].max() == pytest.approx(0.2 * np.sqrt(5000.0 * m), rel=0.03)
    assert out[-1, 1] == pytest.approx(-0.2, rel=0.02)


def test_latch_holds_what_the_stop_throws_back():
    """Protects: a captured hull stays: between latch and stop it swings without gaining energy, and comes to
    rest with damping."""
    swinging, damped = run_in(sea(captured=1), 0.1, 0.9, 800), run_in(sea(damping=1.5), 0.1, 0.8, 2000)
    assert np.abs(swinging[:, 1]).max() <= 0.1 * 1.02
    assert 0.85 - 0.02 < swinging[:, 0].min() and swinging[:, 0].max() < 1.0 + 0.02
    assert damped[-1, 0] > 0.8 and np.abs(damped[-200:, 1]).max() < 0.03


def test_flight_is_captured_by_the_moving_dock(flown):
    """Protects: hover, creep, capture: the whole way in, softly, with actuators at rest at the end."""
    log = flown.log
    outcome = outcome_of(Columns.from_log(log, 7), TS100, "completed")
    assert outcome.ending is Ending.DOCKED and "captured" in outcome.reason
    stages = [int(s) for s in log["stage"][np.flatnonzero(np.diff(log["stage"], prepend=-1))]]
    assert stages[-2:] == [CREEP, CAPTURED]
    capture = capture_of(Columns.from_log(log, 7))
    assert capture and 0.0 < capture.force_max_n < 100.0 and 5.0 < capture.seat_time_s < 15.0
    assert not log["u"][-1].any() and log["nose_depth"][-1] > 0.84
    assert np.ptp(log["target_true"][:, 2]) == pytest.approx(0.08, abs=0.002)  # it heaves
    assert [e.code for e in flown.events].count("captured") == 1


def test_harder_than_they_bear_is_a_collision(flown):
    """Protects: a capture that breaks the dock is none."""
    columns = Columns.from_log(flown.log, 7)
    assert columns.dock
    columns.dock.contact_most[:] = 5.0
    outcome = outcome_of(columns, TS100, "completed")
    assert outcome.ending is Ending.COLLIDED and "5 N" in outcome.reason


def test_hover_before_a_dock_is_not_docked():
    """Protects: once there is a dock to enter, standing before it is not enough."""
    waits = ("end:\n  hover_hold_s: 5", "parameters: {docking: {creep_after_s: 900}}")
    log = simulate(mission(waits), TS100).log
    assert log["stage"].max() < CREEP
    assert outcome_of(Columns.from_log(log, 7), TS100, "completed").ending is Ending.HELD


@pytest.mark.parametrize(
    ("gate", "reason"),
    [("creep_lateral_m: 0.001", OFF_LINE), ("creep_heading_deg: 0.1", OFF_HEADING)],
)
def test_gates_of_the_way_in_wave_off(gate, reason):
    """Protects: off the axis or askew before the entry the vehicle backs out and the dock is not touched."""
    end = ("end:\n  hover_hold_s: 5", f"parameters: {{docking: {{tries: 1, {gate}}}}}")
    log = simulate(mission(end), TS100).log
    assert CREEP in log["stage"] and log["reason"][-1] == reason and BACK in log["stage"]
    assert not log["captured"].any() and not log["contact_force"].any()


def test_map_takes_what_the_cone_takes():
    """Protects: the funnel forgives small offsets and angles and not those beyond its mouth."""
    found = capture_map(mission(), TS100, [0.0, 0.15, 0.45], [-5.0, 0.0, 80.0])
    assert found.captured[0, 1] and found.captured[1, 1] and found.captured[1, 0]
    assert not found.captured[2].any() and not found.captured[:, 2].any()
    assert found.force_max_n[:2, :2].max() < 100.0
    picture = picture_of(found)
    assert picture.startswith("<svg") and "largest force, N" in picture
    with pytest.raises(ValueError, match="no dock"):
        capture_map(parse_mission((Path(__file__).parents[2] / "missions/docking.yaml").read_text(), "d"),
                    TS100, [0.0], [0.0])  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "field"),
    [
        ("tube_radius_m: 0.13", "tube_radius_m: 0.09", "target.dock.tube_radius_m"),
        ("entry_radius_m: 0.4", "entry_radius_m: 0.1", "target.dock.entry_radius_m"),
        ("capture_depth_m: 0.85", "capture_depth_m: 0.5", "target.dock.capture_depth_m"),
        ("entry_before_marker_m: 1.4", "entry_before_marker_m: 0.9", "target.dock.entry_before_marker_m"),
        ("standoff_m: 3.0", "standoff_m: 2.0", "target.standoff_m"),
        (
            "capture_depth_m: 0.85",
            "capture_depth_m: 0.85\n    slip_speed_mps: 0.001\n    friction: 2",
            "target.dock",
        ),
        (
            "  current_ned",
            "  wave: {height_m: 0.23, period_s: 1}\n  current_ned",
            "environment.wave.height_m",
        ),
        ("standoff_m: 3.0", "standoff_m: 3.0\n  heading_tolerance_deg: 10", "target.dock"),
    ],
)
def test_impossible_docks_are_refused(old, new, field):
    """Protects: a dock that can't work is found before the start."""
    with pytest.raises(MissionError) as error:
        mission((old, new))
    assert field in [problem.field for problem in error.value.problems]


def test_a_box_has_no_nose_for_a_tube():
    """Protects: a hull whose shape is not known is not let into a tube."""
    rov = TEXT.replace("vehicle: ts100", "vehicle: bluerov2_heavy")
    with pytest.raises(MissionError) as error:
        parse_mission(rov, "x.yaml")
    assert "target.dock" in [problem.field for problem in error.value.problems]


def test_a_dock_that_swings_too_far_is_not_touched():
    """Protects: what is said of hung docks: entered while they swing a little, else let alone."""
    numbers = range(4300004, 4300006)
    assert "2 docked" in row(mission(), TS100, numbers, 0.02, 0.04)
    assert row(mission(), TS100, numbers, 0.1, 0.2).endswith("2 held; median force 0 N, most 0 N")
