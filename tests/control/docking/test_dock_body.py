"""The dock is a body: legs, go-arounds and turned approaches keep clear of it."""

from dataclasses import replace

import numpy as np
import pytest

import bumpless
from bumpless.config.mission import parse_mission
from bumpless.contract.enums import FORWARD
from bumpless.sim.approach import turn_limit_deg, turn_used_deg
from bumpless.sim.twin import simulate
from bumpless_paper.study.docks import draw_case, fly_case, judge
from bumpless_paper.study.docks.judge import hits

LEGS = """
version: 1
name: legs
vehicle: ts100
duration_s: 200
seed: 1
start: {{position_ned_m: {start}, heading_deg: {course}, speed_mps: 0.7}}
legs:
  - {{to_ned_m: {turn}, speed_mps: 0.7}}
  - {{to_ned_m: [24.5, 0, 2.3], speed_mps: 0.7}}
target: {{position_ned_m: [26, 0, 2.3], heading_deg: 0, standoff_m: 1.5, dock_width_m: {width}}}
end: {{hover_hold_s: 10}}
"""
# a leg through the dock from behind, one that ends in it, one that grazes it from the side, a there and back
PLANS = [
    ("[50, 0, 2.0]", 180, "[8, 0, 2.0]", 2),
    ("[0, 0, 2.0]", 0, "[27, 0.3, 2.3]", 2),
    ("[27, -25, 2.0]", 90, "[27, 20, 2.0]", 2),
    ("[0, 0, 2.0]", 0, "[25, 0, 2.0]", 4),
]


@pytest.mark.parametrize(("start", "course", "turn", "width"), PLANS)
def test_planned_legs_lead_round_the_dock(ts100, start, course, turn, width) -> None:
    """Protects: whatever legs a plan has, nothing but an approach comes near the dock; a wider dock is
    passed farther off; and it is said before the start."""
    mission = parse_mission(LEGS.format(start=start, course=course, turn=turn, width=width), "legs.yaml")
    log = simulate(mission, ts100).log
    assert not hits(log, mission.target).any()
    transit = log[(log["stage"] == 1) & (log["leg"] == 0)]
    off = np.hypot(transit["eta"][:, 0] - 26.0, transit["eta"][:, 1])
    assert off.min() > 3.9 + mission.target.dock_radius_m
    assert "leg_near_dock" in [one.code for one in bumpless.check(mission)]


# corners before, behind and beside the dock, after which the short turn sweeps the bow over it
CORNERS = [
    ("[32.92, -6.52, 3.42]", 221, ["[11.98, -8.17, 1.93]", "[4.91, -2.44, 2.3]", "[23.94, -1.63, 1.84]"]),
    ("[11.05, -19.03, 2.47]", 353, ["[4.09, -2.7, 2.24]", "[32.86, -11.18, 2.76]"]),
    ("[10.04, 21.67, 2.8]", 98, ["[9.5, 20.0, 1.96]", "[8.51, -18.97, 3.23]", "[17.46, -4.1, 2.37]"]),
    ("[-6.84, 0.49, 2.0]", 336, ["[8.03, 2.0, 3.21]", "[0.28, -10.26, 1.72]", "[-1.28, -14.26, 3.4]"]),
    ("[15.65, -9.99, 2.3]", 43, []),
]


@pytest.mark.parametrize(("start", "course", "corners"), CORNERS)
@pytest.mark.parametrize("approach", ["", ", approach: into_current"])
def test_no_turn_near_the_dock_leads_through_it(ts100, start, course, corners, approach) -> None:
    """Protects: a heading clear of the dock may lie on its other side; six of 150 odd plans turned to it
    through the dock."""
    ends = [*corners, "[24.5, 0, 2.3]"]
    legs = "\n".join(f"  - {{to_ned_m: {end}, speed_mps: 0.7}}" for end in ends)
    text = LEGS.split("legs:\n")[0].format(start=start, course=course).replace("200", "500")
    target = f"position_ned_m: [26, 0, 2.3], heading_deg: 0, standoff_m: 1.5{approach}"
    text += f"legs:\n{legs}\ntarget: {{{target}}}\nend: {{hover_hold_s: 12}}\n"
    mission = parse_mission(text, "corners.yaml", ts100)
    run = bumpless.fly(mission)
    assert run.outcome.ending == "docked"
    in_f = run.columns.mode == FORWARD
    off = np.hypot(run.columns.eta[in_f, 0] - 26.0, run.columns.eta[in_f, 1])
    assert off.min() > 1.0 + mission.target.dock_radius_m


def test_a_leg_far_above_the_dock_is_flown_as_it_is(ts100) -> None:
    """Protects: a dock at another depth is no obstacle."""
    text = LEGS.format(start="[0, -25, 12]", course=90, turn="[0, 25, 12]", width=2)
    deep = parse_mission(text.replace("[26, 0, 2.3]", "[0, 0, 2.3]").replace("24.5", "-1.5"), "deep.yaml")
    log = simulate(replace(deep, duration_s=60.0), ts100).log
    assert np.abs(log["eta"][:, 0]).max() < 0.5
    assert "leg_near_dock" not in [one.code for one in bumpless.check(deep)]


def test_without_the_automaton_a_leg_through_the_dock_is_refused() -> None:
    """Protects: the published guidance leads nothing round a dock, so such a plan does not start."""
    text = LEGS.format(start="[50, 0, 2.0]", course=180, turn="[8, 0, 2.0]", width=2)
    text += "parameters: {docking: {enabled: false}}\n"
    (found,) = [
        one for one in bumpless.check(parse_mission(text, "l.yaml")) if one.code == "leg_through_dock"
    ]
    assert found.blocks and found.field == "legs[0].to_ned_m"


def test_an_approach_turns_no_farther_than_its_nose_has_room(ts100, docking) -> None:
    """Protects: off the dock's axis the nose stands nearer to its face; one that turns has no such limit."""
    wide = replace(docking.target, heading_tolerance_deg=60.0)
    limit = turn_limit_deg(wide, ts100)
    assert 35.0 < limit < 50.0 and turn_used_deg(wide, ts100) == limit
    assert turn_limit_deg(replace(wide, standoff_m=2.0), ts100) > limit
    assert turn_limit_deg(replace(wide, standoff_m=1.2), ts100) == 0.0
    assert turn_used_deg(replace(wide, approach="into_current"), ts100) == 180.0


@pytest.mark.parametrize("number", [20])
def test_a_turned_approach_does_not_touch_the_docks_corner(number) -> None:
    """Protects: cases that touched it before the limit, with a fault, a lost target and a wide tolerance."""
    case = draw_case(number, "any", "some")
    assert judge(case, fly_case(case)).outcome != "collided"
