"""When a mission is complete: after its duration to the cycle, or after a hold that nothing interrupted."""

import pytest

from bumpless.config.mission import parse_mission
from bumpless.contract.enums import COMPLETED, HOVER, REVERSE, RUNNING
from bumpless.sim.twin import Twin, simulate


@pytest.mark.parametrize("seconds", [1.0, 5.2, 5.3, 6.0, 20.0, 33.35])
def test_a_live_mission_lasts_its_duration_to_the_cycle(ts100, docking, seconds):
    """Protects: the sum of many periods misses the duration by rounding, and by a cycle."""
    text = docking.text.replace("duration_s: 90", f"duration_s: {seconds}")
    mission = parse_mission(text, "short.yaml", ts100)
    twin = Twin(ts100)
    twin.start(mission)
    steps = 0
    while twin.phase == RUNNING:
        twin.step()
        steps += 1
    assert steps == len(simulate(mission, ts100).log) == round(seconds / 0.05)


def test_a_hold_starts_again_after_the_vehicle_was_out_of_range(ts100, published):
    """Protects: "docked for 5 s" means five seconds on end: a vehicle that drifts out of range and back has
    not held its place, even when the dwell time kept it in hover meanwhile."""
    mission = parse_mission(published.text + "\nend: {hover_hold_s: 5}\n", "hold.yaml", ts100)
    twin = Twin(ts100)
    twin.start(mission)
    in_range, held, breaks = twin.parameters.supervisor.range_rh_upper_m, 0, 0
    for _ in range(1800):
        row = twin.step()
        in_place = row["mode"] == HOVER and row["range"] <= in_range
        breaks += held > 0 and not in_place
        held = held + 1 if in_place else 0
        if row["mode"] == HOVER and held == 20 and breaks == 0:
            twin.onboard["state"]["navigation"]["eta"][0] -= (
                2.5  # the estimate jumps; the camera soon brings the target along
            )
        if twin.phase == COMPLETED:
            break
    assert twin.phase == COMPLETED
    assert breaks == 1 and held == 100
    assert row["mode"] == HOVER and row["previous_mode"] == REVERSE


def test_a_pause_ends_a_hold(ts100, docking):
    """Protects: holding station elsewhere during a pause is no part of the hold at the target."""
    mission = parse_mission(docking.text + "\nend: {hover_hold_s: 5}\n", "hold.yaml", ts100)
    twin = Twin(ts100)
    twin.start(mission)
    while twin.onboard["state"]["supervisor"]["hover_cycles"] < 60:
        twin.step()
    twin.pause()
    for _ in range(60):
        twin.step()
    twin.resume()
    steps = 0
    while twin.phase == RUNNING:
        twin.step()
        steps += 1
    assert steps == 100
