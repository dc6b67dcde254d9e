"""Ballast and trim: the true vehicle floats otherwise than its file and its autopilot think."""

import numpy as np
import pytest

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.mission.trim import Trim, Weight
from bumpless.physics.model import skew
from bumpless.sim.trim import load
from bumpless.sim.twin import Twin


def test_a_moved_weight_moves_the_centre_and_changes_the_inertia(model) -> None:
    """Protects: 1 % of the mass moved 5 cm leaves mass and weight, moves the centre by 0.5 mm, and M_RB is
    that of the masses."""
    heavy = model.copy()
    m, old, new = 0.6, (0.30, 0.0, 0.05), (0.35, 0.0, 0.05)
    load(heavy, Trim(0.0, (Weight(m, old, new),)))
    assert heavy["weight"] == pytest.approx(model["weight"]) and heavy["M_RB"][0, 0] == pytest.approx(60.0)
    np.testing.assert_allclose(heavy["r_g"] - model["r_g"], [0.0005, 0.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(heavy["M_RB"][:3, 3:], -60.0 * skew(heavy["r_g"]), atol=1e-9)
    about = m * (skew(old) @ skew(old) - skew(new) @ skew(new))
    np.testing.assert_allclose(heavy["M_RB"][3:, 3:] - model["M_RB"][3:, 3:], about, atol=1e-9)
    np.testing.assert_allclose(heavy["M_inv"] @ (heavy["M_RB"] + heavy["M_A"]), np.eye(6), atol=1e-9)


def test_a_weight_put_on_and_taken_off_again_is_none(model) -> None:
    """Protects: the bookkeeping of masses: on, off, and lift beside."""
    same = model.copy()
    load(same, Trim(1.5, (Weight(0.6, None, (0.2, 0.1, 0.0)),)))
    assert same["weight"] - model["weight"] == pytest.approx(0.6 * 9.81)
    assert same["buoyancy"] - model["buoyancy"] == pytest.approx(1.5)
    load(same, Trim(-1.5, (Weight(0.6, (0.2, 0.1, 0.0), None),)))
    for name in ("weight", "buoyancy", "r_g", "M_RB", "M_inv"):
        np.testing.assert_allclose(same[name], model[name], atol=1e-9)


def test_only_the_true_vehicle_is_trimmed(ts100, docking) -> None:
    """Protects: nobody on board knows of the trim; at rest the true vehicle goes nose down with the weight
    that moved forward, by the angle of its moment over its stiffness."""
    text = (
        docking.text + "trim: {weights: [{mass_kg: 0.6, from_m: [0.30, 0, 0.05], to_m: [0.35, 0, 0.05]}]}\n"
    )
    twin = Twin(ts100)
    twin.start(parse_mission(text, "trim.yaml", ts100))
    world, onboard = twin.world["model"], twin.onboard["model"]
    assert onboard["r_g"][0] == 0.0 and world["r_g"][0] == pytest.approx(0.0005)
    twin.start(docking)
    assert world["r_g"][0] == 0.0


@pytest.mark.parametrize(
    ("line", "field", "rule"),
    [
        ("trim: {weights: [{mass_kg: 1}]}", "trim.weights[0]", "needs from_m, to_m or both"),
        ("trim: {weights: [{mass_kg: -1, to_m: [0, 0, 0]}]}",
         "trim.weights[0].mass_kg", "between 0.001 and 1000 in kg"),
        ("environment: {current_profile: [{depth_m: 3, current_ned_mps: [0, 0, 0]}, "
         "{depth_m: 3, current_ned_mps: [0, 0, 0]}]}",
         "environment.current_profile[1].depth_m", "deeper than the entry before"),
        ("environment: {water_depth_m: 2}", "environment.water_depth_m", "deepest point (2.3 m)"),
        ("sensors: {dvl_outages: [{from_s: 5, to_s: 5}]}", "sensors.dvl_outages[0].to_s", "must be after"),
    ],
)  # fmt: skip
def test_a_sea_or_trim_that_cannot_be_is_refused(ts100, docking, line: str, field: str, rule: str) -> None:
    """Protects: rules between the fields of sea, sensors and trim, with the place."""
    with pytest.raises(MissionError) as caught:
        parse_mission(docking.text + line + "\n", "bad.yaml", ts100)
    (problem,) = caught.value.problems
    assert problem.field == field and rule in problem.rule and problem.line
