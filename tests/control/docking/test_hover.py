"""Holding station: in gusts, on a heading that follows the hull, stern to a weak current, with quiet fins."""

import numpy as np
import pytest

from bumpless.contract.enums import APPROACH, REVERSE
from bumpless_paper.study.docks import draw_case, fly_case, judge
from bumpless_paper.study.docks.hover import against, hover
from bumpless_paper.study.docks.response import depth_step, stay


@pytest.mark.parametrize("current_mps", [0.08, 0.12])
@pytest.mark.parametrize("number", [101, 104])
def test_ten_minutes_in_gusts(number, current_mps) -> None:
    """Protects: with its heading free a drawn vehicle holds ten minutes in gusts, without a wave-off, and its
    bow wanders less than 1 deg RMS about the heading that it follows."""
    seen = hover(against(number, current_mps))
    assert seen.held and seen.share == 1.0 and seen.wander_deg < 1.0


@pytest.mark.parametrize("number", [8, 33])
def test_what_is_accepted_for_ten_minutes_is_held(number) -> None:
    """Protects: the check's word on a long hover, with a free heading (8), a fixed one (33)."""
    seen = stay(number)
    assert seen.accepted and seen.held and seen.within > 0.95 and seen.wander_deg < 2.0


@pytest.mark.parametrize("number", [1, 3])
def test_a_dive_leaves_no_load_behind(number) -> None:
    """Protects: what the verticals carry is not learnt on the way down; it kept pushing after."""
    step = depth_step(number)
    assert step.settled_s < 15.0 and step.overshoot < 0.05


@pytest.mark.parametrize("number", [2253, 2278])
def test_stern_to_a_weak_current_where_the_bow_cannot_turn_into_it(number) -> None:
    """Protects: a tolerance that does not reach into the current may reach away from it, and that docks."""
    case = draw_case(number, "normal", "some")
    judged = judge(case, fly_case(case))
    assert judged.outcome == "docked" and judged.along_mps > 0.05


@pytest.mark.parametrize("number", [400, 412])
def test_fins_do_not_slam(number) -> None:
    """Protects: in R and H no fin moves more than 6 deg in half a second; these two did, backing off and
    braking."""
    case = draw_case(number, "normal", "into")
    result = fly_case(case)
    near = result.log["mode"] >= REVERSE
    fins = np.degrees(result.log["u"][:, :4])
    moved = np.abs(fins[10:] - fins[:-10]).max(axis=1)[near[10:] & near[:-10]]
    assert moved.max() < 6.0 and judge(case, result).outcome == "docked"


def test_depth_is_held_while_braking() -> None:
    """Protects: over drawn plants the depth error about its reference in R is below 0.03 m RMS."""
    errors = []
    for number in range(500, 510):
        log = fly_case(draw_case(number, "normal", "into")).log
        brakes = log[(log["mode"] == REVERSE) & (log["stage"] == APPROACH)]
        errors.append(np.sqrt(np.mean((brakes["eta"][:, 2] - brakes["reference"][:, 2]) ** 2)))
    assert np.mean(errors) < 0.03
