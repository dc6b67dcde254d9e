"""A brake that does nothing: the vehicle turns away from the dock, for its fins still steer."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from bumpless.config.mission.model import Fault
from bumpless.contract.enums import BACK, HOLD, RUNNING, TOO_SLOW
from bumpless.control.docking.record import DOCKING_SETTINGS, DOCKING_STATE
from bumpless.control.docking.references import note_brake
from bumpless.control.docking.surge import surge_drag, surge_mass
from bumpless.control.docking.swerve import note_shafts, note_stop, swerve_heading, swerves
from bumpless.control.navigation import NAVIGATION_STATE
from bumpless.control.plan import PLAN
from bumpless.physics.model import build_model
from bumpless.sim.twin import Twin, new_log
from bumpless_paper.study.docks import draw_case
from bumpless_paper.study.docks.cases import Case
from bumpless_paper.study.docks.judge import hits

AFTER = 1200  # cycles flown on after the mission is over


def flown(twin: Twin, case: Case, stuck_s: float | None = None) -> np.ndarray:
    """Rows of a case and of a minute after it; from stuck_s on the screw turns as it did then."""
    twin.start(case.mission, alter=case)
    log, n = new_log(twin.cycles + AFTER), 0
    if stuck_s is not None:
        n = twin.fly(log[: round(stuck_s / twin.period_s)])
        screw = [command.actuator for command in twin.vehicle.commands].index("n_p")
        twin.world["model"]["command_rate"][screw] = 0.0
    while twin.phase == RUNNING:
        n += twin.fly(log[n : n + 1000])
    return log[: n + twin.fly(log[n : n + AFTER])]


@pytest.mark.parametrize(
    ("number", "kind", "heading", "at_s", "left"),
    [
        (800002, "normal", "some", 123.83, 0.0),  # with a current from astern
        (800007, "normal", "into", 101.6, 0.0),
        (800013, "normal", "into", 96.96, 0.0),
        (800015, "still", "fixed", 43.75, 0.0),
        (800016, "normal", "into", 109.74, 0.105),
        (800029, "normal", "some", 117.71, 0.17),
        (810000, "still", "into", 23.48, 0.0),  # it pushes no more, long before braking is asked of it
        (810093, "normal", "into", 93.99, 0.0),
        (811110, "still", "into", 109.17, 0.0),  # seen only because the approach tries its brake
        (811154, "normal", "fixed", 33.59, 0.0),
        (811245, "still", "into", 41.04, 0.0),
    ],
)
def test_a_screw_that_dies_near_the_switch_leaves_the_dock_whole(
    ts100, number, kind, heading, at_s, left
) -> None:
    """Protects: without a brake the hull coasts on for 36 m. These draws once ran into the dock."""
    case = draw_case(number, kind, heading)
    case = replace(case, mission=replace(case.mission, faults=(Fault("n_p", at_s, left, 0.5),)))
    log = flown(Twin(ts100), case)
    assert not hits(log, case.mission.target).any()
    assert log["reason"][-1] == TOO_SLOW and log["stage"][-1] in (BACK, HOLD)


@pytest.mark.parametrize(
    ("number", "heading", "at_s"), [(800004, "into", 117.3), (800023, "some", 106.4), (800011, "some", 56.4)]
)
def test_a_screw_that_sticks_is_seen_by_its_shaft(ts100, number, heading, at_s) -> None:
    """Protects: a shaft that turns on as it did is seen within 6 s, still far from the dock."""
    case = draw_case(number, "normal", heading)
    log = flown(Twin(ts100), case, at_s)
    assert not hits(log, case.mission.target).any()
    seen = log["time"][np.flatnonzero(log["reason"] == TOO_SLOW)[0]]
    assert at_s < seen < at_s + 6.0


@pytest.mark.parametrize("order", [Twin.pause, Twin.surface])
def test_an_order_to_hold_station_does_not_end_the_turn_away(ts100, order) -> None:
    """Protects: who sees a screw fail orders a pause or to surface, and neither stops the vehicle."""
    case = draw_case(800002, "normal", "some")
    mission = replace(case.mission, faults=(Fault("n_p", 123.83, 0.0, 0.5),))
    twin = Twin(ts100)
    twin.start(mission, alter=case)
    log = new_log(round(131.0 / twin.period_s) + AFTER)
    n = twin.fly(log[:-AFTER])
    order(twin)
    twin.fly(log[n:])
    assert log["reason"][n - 1] == TOO_SLOW and log["nu"][n - 1, 0] > 0.3
    assert not hits(log, mission.target).any()


def test_a_shaft_that_follows_its_command_is_not_blamed(ts100) -> None:
    """Protects: the watch smooths what a brake's shaft lags behind; no other, and none that is silent."""
    model = build_model(ts100)
    fin, screw, vertical = 0, 4, 5
    for slot, value, expected in (
        (fin, -2.0, 0.0),
        (vertical, -2.0, 0.0),
        (screw, -2.0, -2.0),
        (screw, np.nan, 0),
    ):
        docking, feedback = record(DOCKING_STATE), np.zeros(8)
        feedback[slot] = value
        for _ in range(400):
            note_shafts(0.05, model, feedback, np.zeros(8), docking)
        assert docking["slip"] == pytest.approx(expected, abs=1e-3)


def record(dtype: np.dtype) -> Any:
    """A zeroed record."""
    return np.zeros(1, dtype)[0]


def brake(braked: float, unbraked: float) -> Any:
    """What is remembered of a vehicle that was waved off for its brake."""
    out = record(DOCKING_STATE)
    out["braked"], out["unbraked"], out["reason"], out["stage"] = braked, unbraked, TOO_SLOW, BACK
    return out


def test_the_way_to_rest_is_told_by_what_the_brake_has_done(ts100) -> None:
    """Protects: a brake of which nothing is known counts as none; one that works stops in a metre or two."""
    model = build_model(ts100)
    unknown, weak, sound = brake(0.0, 0.0), brake(0.3, 0.2), brake(0.3, 0.0)
    for docking in (unknown, weak, sound):
        note_stop(model, 0.4, 0.4, docking)
    assert unknown["stops"] > 10.0 > weak["stops"] > 2.0 > sound["stops"] > 0.5
    note_stop(model, -0.1, -0.1, sound)
    assert sound["stops"] == 0.0  # astern it is already


@pytest.mark.parametrize(("works", "seen_s"), [(1.0, None), (0.75, None), (0.0, 5.0)])
def test_a_screw_that_no_longer_pushes_is_seen_by_the_speed(ts100, works, seen_s) -> None:
    """Protects: commands ahead that make no speed are told from drag and thrust that are a little off."""
    model, docking = build_model(ts100), record(DOCKING_STATE)
    u, wanted, seen = 0.5, 0.5, None
    docking["made"] = u
    for k in range(200):
        thrust = 0.83 + 40.0 * (wanted - u)
        note_brake(0.05, model, thrust, u, u, docking)
        if seen is None and docking["unpushed"] > max(0.07, -0.5 * docking["braked"]):
            seen = 0.05 * k
        u += 0.05 * (works * thrust - surge_drag(model, u)) / surge_mass(model)
    assert seen is None if seen_s is None else seen is not None and seen < seen_s


@pytest.mark.parametrize(("across", "side"), [(0.05, 1), (-0.05, -1)])
def test_the_side_is_that_to_which_the_water_flows(across, side) -> None:
    """Protects: head on, the current chooses; once chosen the side is kept until the way is off."""
    settings, plan, navigation = record(DOCKING_SETTINGS), record(PLAN), record(NAVIGATION_STATE)
    settings["keep_out"], plan["dock_radius"], plan["nose"] = 4.2, 1.25, 1.0
    navigation["nu"][0], navigation["target"][0], navigation["current"][1] = 0.4, 5.0, across
    docking = brake(0.0, 0.0)
    docking["stops"] = 10.0
    assert swerves(plan, navigation, docking)
    assert side * swerve_heading(settings, plan, navigation, docking) > 1.5
    navigation["eta"][5], docking["stops"] = -0.3 * side, 2.5
    assert side * swerve_heading(settings, plan, navigation, docking) > 1.5
    assert swerves(plan, navigation, docking)  # it would stop, but not surely
    docking["stops"] = 1.5
    assert not swerves(plan, navigation, docking)
    navigation["nu"][0], docking["stops"] = 0.02, 10.0
    assert not swerves(plan, navigation, docking) and docking["passing"] == 0
