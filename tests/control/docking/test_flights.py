"""Docking on whole flights: drawn missions, steps, hover, weight, and a dock that nothing runs through."""

from dataclasses import replace

import numpy as np
import pytest

from bumpless.config.mission import missions_folder, parse_mission
from bumpless.config.mission.model import Target
from bumpless.contract.enums import APPROACH, BACK, COMPLETED, ENTRY, HOLD, HOVER, RUNNING
from bumpless.sim.log import LOG
from bumpless.sim.twin import Twin, simulate
from bumpless_paper.study.docks import draw_case, fly_case, judge
from bumpless_paper.study.docks.judge import hits, inside_dock
from bumpless_paper.study.docks.response import FAR_SIGHTED, STRAIGHT, depth_step


@pytest.mark.parametrize(
    ("kind", "heading", "numbers"), [("normal", "into", range(6)), ("still", "", range(4))]
)
def test_drawn_missions_dock(kind, heading, numbers) -> None:
    """Protects: into a current from any side, and in still water on any heading, drawn plants dock."""
    for number in numbers:
        case = draw_case(number, kind, heading)
        assert judge(case, fly_case(case)).outcome == "docked", number


def test_a_turn_on_to_the_line_is_no_weak_brake() -> None:
    """Protects: no vehicle gives up for a brake that works; this one came out of its turn fast."""
    case = draw_case(302610, "normal", "into")
    assert judge(case, fly_case(case)).outcome == "docked"


def test_a_way_back_against_a_current_stays_clear_of_the_dock() -> None:
    """Protects: waved off without having tried its brake, this one wandered back into the dock."""
    case = draw_case(360236, "normal", "some")
    assert judge(case, fly_case(case, {"docking": {"try_brake_m": 0.0}})).outcome in ("docked", "waved_off")


@pytest.mark.parametrize("kind", ["camera_dead", "lost", "fault", "any"])
def test_nothing_runs_through_the_dock(kind) -> None:
    """Protects: with the target never seen or lost, with a fault, in any current, the dock stays whole."""
    for number in range(40, 45):
        case = draw_case(number, kind)
        assert judge(case, fly_case(case)).outcome != "collided", number


def test_the_same_number_is_the_same_case() -> None:
    """Protects: a case can be flown again from its number."""
    a, b = draw_case(7, "any"), draw_case(7, "any")
    assert a == b and a != draw_case(8, "any")
    assert judge(a, fly_case(a)) == judge(b, fly_case(b))


def test_a_hull_in_the_dock_is_seen() -> None:
    """Protects: the judge: a nose past the marker's plane is in the dock, beside or above it is not."""
    log = np.zeros(4, LOG)
    log["eta"][:, 0] = (-0.9, -1.5, -0.9, -0.9)
    log["eta"][2, 1], log["eta"][3, 2] = 1.6, -1.3
    target = Target((0.0, 0.0, 0.0), 0.0, 1.5)
    assert inside_dock(log, np.zeros(4), target).tolist() == [True, False, False, False]


def flown(twin: Twin, cycles: int) -> np.ndarray:
    """Rows of so many cycles."""
    return np.array([twin.step().copy() for _ in range(cycles)], LOG)


def smooth(x: np.ndarray, n: int = 20) -> np.ndarray:
    """A second's mean."""
    return np.convolve(np.pad(x, (n // 2, n - 1 - n // 2), "edge"), np.ones(n) / n, "valid")


def settled_s(step: np.ndarray) -> float:
    """Time after which a step response from 0 to 1 stays within 5 %, s."""
    out = np.flatnonzero(np.abs(step - 1.0) > 0.05)
    return 0.05 * (int(out[-1]) + 1) if len(out) else 0.0


def test_depth_follows_a_step_in_forward(ts100) -> None:
    """Protects: 0.5 m of depth in F settles within 15 s and overshoots less than 5 %."""
    twin = Twin(ts100)
    twin.start(parse_mission(STRAIGHT, "far.yaml", ts100))
    before = flown(twin, 600)["eta"][-100:, 2].mean()
    twin.onboard["plan"]["waypoint"][:2, 2] = 2.5
    twin.onboard["plan"]["target"][2] = twin.onboard["state"]["navigation"]["target"][2] = 2.5
    depth = flown(twin, 800)["eta"][:, 2]
    step = (smooth(depth) - before) / (depth[-100:].mean() - before)
    assert depth[-100:].mean() == pytest.approx(2.5, abs=0.05)
    assert settled_s(step) < 15.0 and step.max() < 1.05


@pytest.mark.parametrize("number", [0, 29, 168, 246])
def test_depth_settles_on_noisy_plants_too(number) -> None:
    """Protects: pitch forgets a dive at once. On these plants a tail of 5 % once lasted for 18 to 21 s."""
    step = depth_step(number)
    assert step.settled_s < 13.0 and step.overshoot < 0.05


def test_heading_follows_a_step_in_forward(ts100) -> None:
    """Protects: 20 deg of heading in F settle within 15 s and overshoot less than 10 %."""
    text = STRAIGHT + FAR_SIGHTED
    twin = Twin(ts100)
    twin.start(parse_mission(text, "far.yaml", ts100))
    flown(twin, 400)
    plan, turn = twin.onboard["plan"], np.radians(20.0)
    here = twin.onboard["state"]["navigation"]["eta"][:2].copy()
    ahead = np.array([np.cos(turn), np.sin(turn)])
    plan["waypoint"][0, :2], plan["waypoint"][1, :2] = here, here + 200.0 * ahead
    plan["target"][:2] = twin.onboard["state"]["navigation"]["target"][:2] = here + 201.5 * ahead
    plan["target"][3] = twin.onboard["state"]["docking"]["heading"] = turn
    psi = flown(twin, 800)["eta"][:, 5]
    step = smooth(psi) / psi[-100:].mean()
    assert psi[-100:].mean() == pytest.approx(turn, abs=0.02)
    assert settled_s(step) < 15.0 and step.max() < 1.10


def test_speed_does_not_dip_at_the_start(ts100) -> None:
    """Protects: a vehicle that begins at speed begins with turning screws and references as it is found."""
    log = simulate(parse_mission(STRAIGHT.replace("400", "15"), "far.yaml", ts100), ts100).log
    assert np.abs(log["nu"][:, 0] - log["nu"][0, 0]).max() < 0.03


def test_ten_minutes_in_hover(ts100, docking) -> None:
    """Protects: in a head current station is held as long as asked, the heading within 1 deg RMS."""
    text = docking.text.replace("duration_s: 90", "duration_s: 700")
    text += "environment: {current_ned_mps: [-0.1, 0, 0]}\n"
    log = simulate(parse_mission(text, "hover.yaml", ts100), ts100).log
    held = log[log["time"] > 95.0]
    assert (held["mode"] == HOVER).all() and (held["stage"] == APPROACH).all()
    assert held["range_true"].max() < 0.2
    assert np.degrees(np.std(held["eta"][:, 5])) < 1.0


@pytest.mark.parametrize("across", [0.01, -0.01])
def test_a_drift_that_nothing_can_undo_at_rest_docks_at_the_first_try(ts100, docking, across) -> None:
    """Protects: on a fixed heading without flow the vehicle comes to rest upstream and drifts through."""
    text = docking.text.replace("[-0.10, 0, 0]", f"[0, {across}, 0]") + "end: {hover_hold_s: 15}\n"
    log = simulate(parse_mission(text, "drift.yaml", ts100), ts100).log
    assert log["held"][-1] >= 15.0 and log["tried"][-1] == 1


def test_the_line_is_joined_at_once_and_turns_into_the_current_on_the_way(ts100) -> None:
    """Protects: a few degrees of turn into the current cost no way round of a minute."""
    text = (missions_folder() / "docking_current.yaml").read_text()
    text = text.replace("[-0.08, 0.01, 0]", "[-0.07, 0.022, 0]")
    log = simulate(parse_mission(text, "joined.yaml", ts100), ts100).log
    assert not (log["stage"] == ENTRY).any() and log["held"][-1] >= 20.0
    assert np.degrees(log["approach"][-1]) < -10.0


@pytest.mark.parametrize("load", [1.0, -1.0])
def test_a_newton_too_light_or_heavy_docks(load) -> None:
    """Protects: net buoyancy of 1 N either way, near all that the verticals give."""
    case = draw_case(2, "still")
    case = replace(case, plant=replace(case.plant, net_buoyancy=load, thrust=1.0))
    assert judge(case, fly_case(case)).outcome == "docked"


def test_a_lost_target_is_backed_away_from_and_docked_at_on_the_second_try(ts100, docking) -> None:
    """Protects: the story of a wave-off, as it is told: begun, waved off, begun again, gate passed, held."""
    text = docking.text.replace("duration_s: 90", "duration_s: 200")
    text += "sensors: {outages: [{from_s: 26, to_s: 50}]}\nend: {hover_hold_s: 15}\n"
    result = simulate(parse_mission(text, "lost.yaml", ts100), ts100)
    story = ("approach_begun", "waved_off", "gate_passed", "station_held", "mission_completed")
    told = [event.code for event in result.events if event.code in story]
    assert told == ["approach_begun", "waved_off", "approach_begun", "gate_passed", "station_held", story[-1]]
    back = result.log[result.log["stage"] == BACK]
    assert back["along_track"].min() > 3.0  # braking costs some way; the dock is far
    assert not hits(result.log, docking.target).any()


@pytest.mark.parametrize(
    ("number", "kind", "heading"),
    [
        (22020, "fault", "fixed"),
        (710032, "fault", "fixed"),
        (720632, "fault", "into"),
        (720632, "fault", "some"),
        (710133, "any", "some"),  # with a current from astern
        (750231, "any", ""),
    ],
)
def test_a_screw_with_a_fifth_of_its_thrust_still_stops_before_the_dock(number, kind, heading) -> None:
    """Protects: a weak brake is seen while there is way left to stop in; these draws once ran through."""
    case = draw_case(number, kind, heading)
    result = fly_case(case)
    assert not hits(result.log, case.mission.target).any()
    assert judge(case, result).why == "too slow"


def test_a_way_round_from_the_hold_point_does_not_lead_over_the_dock() -> None:
    """Protects: half a screw, a current from astern and a turn across the dock: this draw once ran in."""
    case = draw_case(710000, "any", "some")
    assert not hits(fly_case(case).log, case.mission.target).any()


def test_what_cannot_be_held_is_given_up_and_held_clear_of(ts100, docking) -> None:
    """Protects: after the end the vehicle stays clear of the dock instead of drifting into it."""
    text = docking.text + "environment: {current_ned_mps: [0, 0.1, 0]}\n"
    twin = Twin(ts100)
    twin.start(parse_mission(text, "abeam.yaml", ts100))
    while twin.phase == RUNNING:
        twin.step()
    events = [event for event in twin.drain_events() if event.code == "docking_ended"]
    assert len(events) == 1 and "current" in events[0].text
    log = flown(twin, 2400)
    assert twin.phase == COMPLETED and (log["stage"] == HOLD).all()
    assert not hits(log, docking.target).any()
    assert log["along_track"].min() > 6.0


def test_when_time_is_over_the_vehicle_holds_clear_of_the_dock(ts100, docking) -> None:
    """Protects: a mission that ends on its way does not fly on into the dock."""
    twin = Twin(ts100)
    twin.start(parse_mission(docking.text.replace("duration_s: 90", "duration_s: 30"), "short.yaml", ts100))
    while twin.phase == RUNNING:
        twin.step()
    log = flown(twin, 2400)
    assert (log["stage"] == HOLD).all() and log["along_track"][-1] > 5.0
    assert not hits(log, docking.target).any()
