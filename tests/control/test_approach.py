"""Losing the target: what the published supervisor and guidance make of it, on whole flights."""

import pytest

from bumpless.config.mission import parse_mission
from bumpless.contract.enums import HOVER
from bumpless.sim.twin import simulate


def with_outage(published, vehicle, from_s, to_s, duration_s):
    text = published.text.replace("duration_s: 90", f"duration_s: {duration_s}")
    text += f"\nsensors:\n  outages:\n    - {{from_s: {from_s}, to_s: {to_s}}}\n"
    return parse_mission(text, "lost.yaml", vehicle)


def modes(result):
    return [event.details["to"] for event in result.events if event.code == "mode_switch"]


def test_a_short_loss_is_bridged_by_the_filter(published, ts100):
    """Protects: one second without the target in the approach changes no mode."""
    result = simulate(with_outage(published, ts100, 30, 30.9, 90), ts100)
    assert modes(result) == ["reverse", "hover"]


def test_a_lost_target_sends_the_vehicle_forward_and_a_found_one_back(published, ts100):
    """Protects: R to F on loss and F to R on return, ending in hover at the target."""
    result = simulate(with_outage(published, ts100, 26, 32, 120), ts100)
    assert modes(result) == ["reverse", "forward", "reverse", "hover"]
    assert result.log["range_true"][-1] < 0.3


@pytest.mark.parametrize("seed", [1, 4])
def test_a_missed_approach_is_flown_again(published, ts100, seed):
    """Protects: a target that is gone for longer than the vehicle needs to pass it: it goes back, aligns
    on the last leg without taking a glimpse for an approach, and docks."""
    result = simulate(with_outage(published, ts100, 26, 60, 260), ts100, seed=seed)
    assert modes(result) == ["reverse", "forward", "reverse", "hover"]
    log = result.log
    assert log["leg"].max() == log["leg_count"][0]  # the way back was flown
    told = [event.code for event in result.events if event.code.startswith("approach_")]
    assert told == ["approach_missed", "approach_repeated"]
    assert log["mode"][-1] == HOVER and log["range_true"][-1] < 0.4
