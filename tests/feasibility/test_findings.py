"""What can't be flown is said before the start, and what is said is what happens."""

import numpy as np
import pytest

import bumpless
from bumpless.campaign.distributions import Normal
from bumpless.campaign.sketch import foresight_campaign
from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle, vehicle_names
from bumpless.contract.enums import CURRENT, HOLD
from bumpless.feasibility import ACCEPT, REFUSE, WARN, station_keeping
from bumpless.feasibility.holding import OPEN_MPS
from bumpless.feasibility.path import approach_time
from bumpless.feasibility.reach import top_speed
from bumpless.physics.model import build_model
from bumpless.sim.twin import simulate
from tests.flights import MISSIONS

CASE = """
version: 1
name: case
vehicle: ts100
duration_s: 180
seed: 1
start: {position_ned_m: [0, 0, 2.0], heading_deg: 0, speed_mps: 0.7}
legs:
  - {to_ned_m: [10, 0, 2.0], speed_mps: 0.7}
  - {to_ned_m: [24.5, 0, 2.3], speed_mps: 0.7}
target: {position_ned_m: [26, 0, 2.3], heading_deg: 0, standoff_m: 1.5}
"""


IN_STILL_WATER = CASE + "end: {hover_hold_s: 10}\n"
SOUND = IN_STILL_WATER.replace("standoff_m: 1.5", "standoff_m: 1.5, approach: into_current")


def found(text: str) -> list[tuple[str, str]]:
    """(severity, code) of a mission's findings."""
    return [(one.severity, one.code) for one in bumpless.check(parse_mission(text, "case.yaml"))]


def with_current(east: float, north: float = 0.0, text: str = CASE) -> str:
    """The case in a current."""
    return text + f"environment: {{current_ned_mps: [{north}, {east}, 0]}}\n"


def test_a_sound_mission_has_no_findings() -> None:
    """Protects: no false alarms."""
    assert found(SOUND) == []


def ten_minutes(north: float, east: float, gust: float = 0.0, approach: str = "") -> str:
    """Ten minutes of hover in a current, m/s, that comes from ahead where north is negative."""
    sea = f"environment: {{current_ned_mps: [{north}, {east}, 0], current_variation: {{std_mps: {gust}}}}}\n"
    sea = sea.replace("}}", ", time_constant_s: 30}}")
    text = CASE.replace("duration_s: 180", "duration_s: 900") + sea + "end: {hover_hold_s: 600}\n"
    return text.replace("standoff_m: 1.5", f"standoff_m: 1.5, {approach}") if approach else text


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (with_current(0.1), ("hard", "current_not_holdable")),
        (with_current(0.01), ("soft", "current_hard_to_hold")),
        (CASE.replace("[24.5, 0", "[5000, 0").replace("[26, 0", "[5001.5, 0"), ("hard", "too_far")),
        (CASE.replace("[26, 0, 2.3]", "[26, 0, 23]"), ("soft", "target_depth")),
        (CASE.replace("[26, 0, 2.3]", "[26, 40, 2.3]"), ("soft", "target_not_on_path")),
        (CASE.replace("speed_mps: 0.7}\ntarget", "speed_mps: 4.5}\ntarget"), ("hard", "leg_too_fast")),
        (with_current(-0.6), ("hard", "leg_not_flyable")),
        (CASE.replace("[10, 0, 2.0]", "[10, 0, 9.0]"), ("soft", "leg_too_steep")),
        (CASE.replace("duration_s: 180", "duration_s: 40"), ("soft", "short_of_time")),
        (CASE.replace("[10, 0, 2.0]", "[20, 0, 2.0], speed_mps: 0.7}\n  - {to_ned_m: [0, 0, 2.0]"),
         ("soft", "seen_early")),
        (CASE + "end: {hover_hold_s: 100}\n", ("soft", "long_hover")),
        (ten_minutes(0.0, 0.0), ("hard", "long_hover")),
        (ten_minutes(-0.1, 0.01), ("soft", "long_hover")),
        (CASE + "environment: {beam_attenuation_per_m: 0.96}\n", ("soft", "seen_too_late")),
        (CASE, ("soft", "hover_to_the_end")),
        (IN_STILL_WATER, ("soft", "current_may_differ")),
        (with_current(0.0, -0.04), ("soft", "current_may_differ")),
    ],
)  # fmt: skip
def test_each_kind_of_what_cannot_work_is_found(text, wanted) -> None:
    """Protects: every case of issue 9: refused or warned of before it starts, never "completed"."""
    assert wanted in found(text)


@pytest.mark.parametrize(
    "text",
    [
        with_current(0.0, -0.1),
        IN_STILL_WATER.replace("vehicle: ts100", "vehicle: bluerov2_heavy").replace(": 0.7}", ": 0.4}"),
    ],
    ids=["flow from ahead", "sideways thrust"],
)
def test_a_fixed_heading_that_bears_a_little_more_current_is_sound(text) -> None:
    """Protects: who lays the dock against the current, or can push sideways, is warned of nothing."""
    assert found(text) == []


def test_what_a_plan_cannot_know_is_what_foresight_draws() -> None:
    """Protects: the finding explains the chance that stands beside it, drawn by the same numbers."""
    drawn = foresight_campaign().draw["current_across_mps"]
    assert isinstance(drawn, Normal) and pytest.approx(2.0 * drawn.normal[1]) == OPEN_MPS


def test_a_finding_says_why_and_what_would_work() -> None:
    """Protects: the nearest heading that holds is named, and it does hold."""
    (finding,) = bumpless.check(parse_mission(with_current(0.1), "case.yaml"))
    assert "sideways thrust" in finding.text and "Can be held: 2" in finding.change
    assert finding.as_dict()["mends"][0] == {
        "path": "target.approach", "value": "into_current", "words": "Approach into the current"
    }  # fmt: skip
    free = with_current(0.1, text=CASE.replace("standoff_m: 1.5", "standoff_m: 1.5, approach: into_current"))
    assert found(free) == []


@pytest.mark.parametrize("east", [0.0, 0.06, 0.1])
def test_what_is_refused_is_what_the_vehicle_gives_up(ts100, east) -> None:
    """Protects: one rule before the start and in flight."""
    mission = parse_mission(with_current(east), "case.yaml", ts100)
    refused = ("hard", "current_not_holdable") in found(mission.text)
    last = simulate(mission, ts100).log[-1]
    assert refused == (last["stage"] == HOLD and last["reason"] == CURRENT) == (east > 0.0)


def test_the_headings_that_hold_lie_about_the_current(ts100, docking) -> None:
    """Protects: station keeping by heading, its margin and the nearest heading."""
    station = station_keeping(ts100, default_parameters(ts100), (0.0, 0.12, 0.0), docking.target)
    may, sure = (station.heading_deg[station.zone >= zone] for zone in (WARN, ACCEPT))
    assert station.chosen.zone == REFUSE and station.chosen.margin_mps < 0.0
    astern, ahead = may[may < 180.0], may[may > 180.0]
    assert 250.0 < ahead.min() < sure.min() < 270.0 < sure.max() < ahead.max() < 290.0
    assert 75.0 < astern.min() < 90.0 < astern.max() < 105.0  # stern to the current it may, but not surely
    assert station.nearest_deg == sure.max()


@pytest.mark.parametrize("name", ["bluerov2_heavy", "twinpod"])
def test_a_vehicle_with_sideways_thrust_holds_any_heading(name, docking) -> None:
    """Protects: what is asked of a vehicle without sway is not asked of others."""
    vehicle = load_vehicle(name)
    station = station_keeping(vehicle, default_parameters(vehicle), (0.0, 0.05, 0.0), docking.target)
    assert station.chosen.zone == ACCEPT and (station.zone == ACCEPT).all()


def test_a_vehicle_that_cannot_stop_holds_nowhere(docking) -> None:
    """Protects: REMUS passes; it is not said to hold."""
    vehicle = load_vehicle("remus100")
    station = station_keeping(vehicle, default_parameters(vehicle), (0.0, 0.0, 0.0), docking.target)
    assert station.chosen.zone == REFUSE and "slower" in station.chosen.reason


@pytest.mark.parametrize("name", vehicle_names())
def test_top_speed_is_where_thrust_meets_drag(name) -> None:
    """Protects: a plausible top speed for every vehicle."""
    assert 0.5 < top_speed(build_model(load_vehicle(name))) < 5.0


def test_the_approach_takes_as_long_as_it_is_said_to(ts100, docking, flight) -> None:
    """Protects: the time that a mission is told to allow is the time that its flight takes."""
    said = 24.5 / 0.7 + approach_time(default_parameters(ts100), docking)
    arrived = float(flight.log["time"][np.argmax(flight.log["range_true"] < 0.1)])
    assert said == pytest.approx(arrived, abs=12.0)


@pytest.mark.parametrize("path", sorted(MISSIONS.glob("*.yaml")), ids=lambda path: path.stem)
def test_every_example_mission_can_be_flown_or_says_why_not(path) -> None:
    """Protects: an example with an error says in its title that it does not dock."""
    mission = bumpless.load_mission(path)
    errors = [one for one in bumpless.check(mission) if one.blocks]
    assert bool(errors) == ("does not dock" in mission.title)


@pytest.mark.parametrize(
    ("text", "accepted"),
    [
        (ten_minutes(-0.06, 0.0), True),
        (ten_minutes(-0.04, 0.0), False),
        (ten_minutes(-0.1, 0.006), True),
        (ten_minutes(-0.1, 0.006, gust=0.002), False),
        (ten_minutes(-0.1, 0.006, 0.002, "heading_tolerance_deg: 10"), True),
        (ten_minutes(0.0, 0.1, 0.006, "approach: into_current"), True),
        (ten_minutes(0.0, 0.07, 0.006, "approach: into_current"), False),
    ],
)
def test_ten_minutes_are_accepted_only_where_they_are_held(text, accepted) -> None:
    """Protects: a long hover that the gusts or too little flow would break off is never passed over."""
    assert ("long_hover" not in [code for _, code in found(text)]) == accepted
