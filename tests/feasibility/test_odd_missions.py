"""Odd missions: what is found before the start is what becomes of them in flight."""

import math

import pytest

import bumpless
from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.config.vehicle import load_vehicle
from bumpless.feasibility.path import time_there

ODD = """
version: 1
name: odd
vehicle: ts100
duration_s: {duration}
seed: 1
start: {{position_ned_m: {start}, heading_deg: {heading}, speed_mps: {speed}}}
legs:
{legs}
target: {{position_ned_m: [40, 0, 2.3], heading_deg: 0, standoff_m: {standoff}, {target}}}
environment: {{current_ned_mps: {current}, beam_attenuation_per_m: {murk}}}
end: {{hover_hold_s: {hold}}}
"""


def odd(*legs: str, leg_speed: float = 0.7, **given: object) -> bumpless.Mission:
    """A mission to a dock at 40 m north; the last leg to the observation point is added."""
    ends = [*legs, given.pop("last", "[38.5, 0, 2.3]")]
    text = "\n".join(f"  - {{to_ned_m: {end}, speed_mps: {leg_speed}}}" for end in ends)
    usual = {
        "duration": 700, "start": "[0, 0, 2.0]", "heading": 0, "speed": 0.7, "standoff": 1.5, "hold": 12,
        "target": "approach: into_current", "current": "[0, 0, 0]", "murk": 0,
    }  # fmt: skip
    return parse_mission(ODD.format(legs=text, **usual | given), "odd.yaml")


def codes(mission: bumpless.Mission) -> list[str]:
    """Of the findings, hard ones with an exclamation mark."""
    return [("!" if one.blocks else "") + one.code for one in bumpless.check(mission)]


def mended(mission: bumpless.Mission, path: str, value: object) -> bumpless.Mission:
    """The mission with the one number changed that a mend names."""
    before = {"target.standoff_m": "standoff_m: 10.0", "legs[0].speed_mps": "speed_mps: 0.7}\ntarget"}[path]
    after = before.replace("10.0", str(value)).replace("0.7}", f"{value}}}")
    return parse_mission(mission.text.replace(before, after), "odd.yaml")


@pytest.mark.parametrize(("off", "heading"), [(4.0, 0.0), (3.0, 0.0), (2.5, 10.0)])
@pytest.mark.parametrize("target", ["approach: into_current", "dock_width_m: 2"])
def test_a_start_with_the_bow_to_a_near_dock_is_refused_and_its_mends_dock(off, heading, target) -> None:
    """Protects: F can't stop: such starts ran into the dock, and nothing was said."""
    start = f"[{40.0 - off}, 0, 2.3]"
    mission = odd(start=start, heading=heading, target=target)
    (refused,) = [one for one in bumpless.check(mission) if one.blocks]
    assert refused.code == "starts_too_near" and refused.mends
    assert bumpless.fly(mission).outcome.ending == "collided"
    for mend in refused.mends:
        changed = {"heading": heading, "start": start}
        if mend.path == "start.heading_deg":
            changed["heading"] = mend.value
        else:
            assert isinstance(mend.value, tuple)
            changed["start"] = str(list(mend.value))
        better = odd(target=target, **changed)
        assert not {"!starts_too_near", "starts_near"} & set(codes(better))
        assert bumpless.fly(better).outcome.ending == "docked"


def test_a_start_that_may_go_well_is_warned_of_and_not_refused() -> None:
    """Protects: a third of the refused starts could have been flown; what may end either way is said so."""
    mission = odd(start="[35, 0, 2.3]", target="dock_width_m: 2")
    (near,) = [one for one in bumpless.check(mission) if one.code == "starts_near"]
    assert not near.blocks and "trial flights" in near.text and near.mends
    assert {bumpless.fly(mission, seed=seed).outcome.ending for seed in (2, 3)} == {"docked", "collided"}


@pytest.mark.parametrize(
    "given",
    [
        {"start": "[36, 0, 2.3]", "heading": 20, "target": "dock_width_m: 2"},
        {"start": "[36.5, 3, 2.3]", "heading": 10},
        {"start": "[38, 2.5, 2.3]", "heading": 150, "target": "dock_width_m: 1"},
    ],
)
def test_a_start_beside_the_dock_that_can_be_flown_is_not_refused(given) -> None:
    """Protects: 13 of 21 drawn starts that a rule of geometry refused docked without a touch."""
    mission = odd(**given)
    assert not [code for code in codes(mission) if code.startswith("!")]
    assert bumpless.fly(mission).outcome.ending == "docked"


def test_a_start_in_a_dock_that_turns_is_in_it() -> None:
    """Protects: a dock without a heading of its own is no less a body."""
    assert "!starts_in_dock" in codes(odd(start="[40.5, 1.5, 2.3]", heading=90, speed=0))


@pytest.mark.parametrize(("off", "heading"), [(8.0, 0.0), (5.0, 90.0), (4.0, 180.0)])
def test_a_start_that_turns_away_in_time_is_not_refused(off, heading) -> None:
    """Protects: no refusal of what can be flown."""
    mission = odd(start=f"[{40.0 - off}, 0, 2.3]", heading=heading)
    assert codes(mission) == []
    assert bumpless.fly(mission).outcome.ending == "docked"


@pytest.mark.parametrize("east", [0.25, 0.3])
def test_a_current_from_abeam_that_legs_are_kept_in_is_not_refused(east) -> None:
    """Protects: legs were refused at half the crab that path following makes good."""
    mission = odd(current=f"[0, {east}, 0]")
    assert codes(mission) == []
    assert bumpless.fly(mission).outcome.ending == "docked"


@pytest.mark.parametrize(("north", "speed", "said"), [(-0.4, 0.7, False), (-0.5, 0.7, True)])
def test_an_approach_against_too_much_current_is_warned_of(north, speed, said) -> None:
    """Protects: "too slow" in flight is said before it, with the speed that does."""
    mission = odd(current=f"[{north}, 0, 0]", leg_speed=speed)
    assert ("approach_too_slow" in codes(mission)) == said
    assert bumpless.fly(mission).outcome.why == ("too slow" if said else "held within the limits")


@pytest.mark.parametrize(
    ("speed", "said", "ending"), [(0.9, "leg_too_fast", "docked"), (1.2, "!leg_too_fast", "waved_off")]
)
def test_a_leg_too_fast_is_refused_only_where_the_vehicle_would_give_up(speed, said, ending) -> None:
    """Protects: 35 of 41 missions that were refused for a leg a little too fast docked."""
    mission = odd("[10, 0, 2]", leg_speed=speed)
    assert said in codes(mission)
    assert bumpless.fly(mission).outcome.ending == ending


@pytest.mark.parametrize(
    ("standoff", "said"), [(1.1, ["!standoff_too_short"]), (1.25, ["standoff_too_short"]), (1.4, [])]
)
def test_a_standoff_is_refused_only_where_the_nose_guard_would_wave_off(standoff, said) -> None:
    """Protects: 12 of 62 refused standoffs docked."""
    mission = odd(standoff=standoff, last=f"[{40.0 - standoff}, 0, 2.3]")
    assert codes(mission) == said
    assert (bumpless.fly(mission).outcome.ending == "docked") == (not said or said[0][0] != "!")


def test_a_target_free_to_turn_in_still_water_may_take_a_way_round() -> None:
    """Protects: a faint current turned the approach, the way round took the time, without a word."""
    assert "short_of_time" in codes(odd(duration=140))
    assert "short_of_time" not in codes(odd(duration=140, current="[-0.08, 0, 0]"))
    assert "short_of_time" not in codes(odd(duration=240))


def test_legs_that_lead_straight_on_are_not_said_to_see_the_target_early() -> None:
    """Protects: the planner's own first mission was warned of waypoints on the way to its dock."""
    assert "seen_early" not in codes(odd("[28, 0, 2.3]"))
    assert "seen_early" in codes(odd("[30, 1, 2.3]", "[30, 20, 2.3]"))


def test_a_hover_too_short_to_have_docked_is_warned_of() -> None:
    """Protects: docked means ten seconds in place; a mission that ends before can't end so."""
    assert "hold_too_short" in codes(odd(hold=3))
    assert bumpless.fly(odd(hold=3)).outcome.ending == "held"
    assert codes(odd(hold=10)) == []


def test_a_target_that_is_never_seen_is_refused() -> None:
    """Protects: no break-off is late enough for a marker that the camera never sees."""
    assert "!never_seen" in codes(odd(standoff=14.0, last="[26, 0, 2.3]"))
    assert "!never_seen" in codes(odd(murk=3.0))
    late = odd(standoff=10.0, last="[30, 0, 2.3]")
    (finding,) = [one for one in bumpless.check(late) if one.code == "seen_too_late"]
    better = mended(late, finding.mends[0].path, finding.mends[0].value)
    again = [one for one in bumpless.check(better) if one.code == "seen_too_late"]
    assert not again or again[0].mends[0].path == "parameters.docking.break_off_m"


def test_a_dock_too_large_to_be_passed_is_warned_of() -> None:
    """Protects: an approach line that begins inside what is kept clear is never reached."""
    huge = odd(start="[-60, 0, 2.0]", target="approach: into_current, dock_width_m: 20, dock_length_m: 20")
    assert "line_in_keep_out" in codes(huge)


@pytest.mark.parametrize(
    ("legs", "given"),
    [
        ([], {}),
        ([], {"heading": 180}),
        ([], {"heading": 90}),
        (["[10, 0, 2]"], {"target": "heading_tolerance_deg: 0", "current": "[0, 0, 0]"}),
        (["[30, 20, 2]", "[0, 20, 2]"], {}),
        ([], {"start": "[60, 0, 2.0]", "heading": 180}),
        ([], {"current": "[0, 0.1, 0]"}),
        ([], {"last": "[20, 0, 2.0]"}),
    ],
)
def test_the_time_that_a_mission_is_said_to_take_is_about_what_it_takes(ts100, legs, given) -> None:
    """Protects: turns on to legs and the way round count; missions ran out of time without a word."""
    mission = odd(*legs, **given)
    parameters = with_overrides(default_parameters(ts100), mission.parameters)
    said, taken = (
        time_there(mission, load_vehicle("ts100"), parameters),
        bumpless.fly(mission).metrics.duration_s,
    )
    assert math.isfinite(said)
    assert 0.85 * taken < said + 12.0 < 1.35 * taken
