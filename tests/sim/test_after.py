"""After its mission a vehicle holds station and says so, until it is told to stop; then nothing moves."""

import numpy as np
import pytest

from bumpless.config.mission import parse_mission
from bumpless.contract.enums import ABORTED, COMPLETED, HOVER
from bumpless.sim.twin import Twin


def flown(vehicle, text: str, seconds: float) -> Twin:
    """A twin whose mission of `text` is over after `seconds`."""
    mission = parse_mission(text.replace("duration_s: 90", f"duration_s: {seconds}"), "short.yaml", vehicle)
    twin = Twin(vehicle)
    twin.start(mission)
    while twin.phase != COMPLETED:
        twin.step()
    return twin


def test_a_vehicle_whose_time_is_over_on_its_way_stops_and_holds_there(ts100, published):
    """Protects: after "Completed" it flew on along its path and past the dock, without a mode's name."""
    twin = flown(ts100, published.text, 10.0)
    rows = [twin.step().copy() for _ in range(1200)]
    assert {int(row["flown"]) for row in rows} == {HOVER}
    assert {int(row["phase"]) for row in rows} == {COMPLETED}
    late = np.array([row["eta"][:2] for row in rows[-400:]])
    assert np.ptp(late, axis=0).max() < 1.0, "it holds its place"
    assert [event.code for event in twin.drain_events()][-2:] == ["mission_completed", "holding_station"]


@pytest.mark.parametrize("after_s", [0.0, 3.0])
def test_abort_stops_what_holds_after_its_mission(ts100, published, after_s):
    """Protects: abort was refused while thrusters ran."""
    twin = flown(ts100, published.text, 10.0)
    for _ in range(round(after_s / 0.05)):
        twin.step()
    twin.abort("aborted by the operator")
    for _ in range(200):
        row = twin.step()
    assert twin.phase == ABORTED and int(row["flown"]) == 0
    assert np.abs(row["u"][:7]).max() < 1e-6
    assert twin.drain_events()[-1].text == "Actuators stopped: aborted by the operator."
