"""Every transition of the docking automaton, one at a time, without a flight."""

from dataclasses import dataclass, field
from math import radians
from typing import Any

import numpy as np
import pytest

from bumpless.config.parameters import default_parameters
from bumpless.config.parameters.records import fill_record
from bumpless.contract import enums as e
from bumpless.control.docking.line import approach_most, back_speed
from bumpless.control.docking.record import DOCKING_OUTPUT, DOCKING_SETTINGS, DOCKING_STATE
from bumpless.control.docking.stages import next_stage, see_line
from bumpless.control.navigation import CLOCK, NAVIGATION_STATE
from bumpless.control.plan import PLAN
from bumpless.control.supervisor import SUPERVISOR_SETTINGS

DT = 0.05


def one(dtype: np.dtype) -> Any:
    """A zeroed record."""
    return np.zeros(1, dtype)[0]


@dataclass
class Dock:
    """A marker at the origin, approached to the north at 3 m depth, and a vehicle somewhere about."""

    settings: Any = field(default_factory=lambda: one(DOCKING_SETTINGS))
    supervisor: Any = field(default_factory=lambda: one(SUPERVISOR_SETTINGS))
    plan: Any = field(default_factory=lambda: one(PLAN))
    navigation: Any = field(default_factory=lambda: one(NAVIGATION_STATE))
    docking: Any = field(default_factory=lambda: one(DOCKING_STATE))
    view: Any = field(default_factory=lambda: one(DOCKING_OUTPUT))
    clock: Any = field(default_factory=lambda: one(CLOCK))
    mode: int = e.FORWARD
    leg: int = 1
    detected: int = 1

    def at(self, left: float, aside: float = 0.0, off_deg: float = 0.0, deep: float = 0.0) -> "Dock":
        """Put the vehicle on the approach line, `left` m before the observation point."""
        heading = float(self.docking["heading"])
        c, s = np.cos(heading), np.sin(heading)
        along = -1.5 - left
        self.navigation["eta"][:3] = (c * along - s * aside, s * along + c * aside, 3.0 + deep)
        self.navigation["eta"][5] = heading + radians(off_deg)
        return self

    def stage(self, stage: int, mode: int, tried: int = 1) -> "Dock":
        """Be in a stage and a mode."""
        self.docking["stage"], self.docking["tried"], self.mode = stage, tried, mode
        return self

    def step(self, times: int = 1) -> int:
        """Decide, and fly on in the mode decided."""
        point = np.zeros(4)
        for _ in range(times):
            see_line(DT, self.plan, self.navigation, self.detected, point, self.docking, self.view)
            self.mode = next_stage(
                self.clock, DT, self.settings, self.supervisor, self.plan, self.navigation, self.leg,
                self.mode, point, self.view, self.docking,
            )  # fmt: skip
            self.clock["cycle"] += 1
            self.clock["time"] += DT
        return self.mode

    @property
    def now(self) -> int:
        """The stage."""
        return int(self.docking["stage"])

    @property
    def reason(self) -> int:
        """Of the last wave-off."""
        return int(self.docking["reason"])


@pytest.fixture
def dock(ts100) -> Dock:
    parameters, made = default_parameters(ts100), Dock()
    fill_record(parameters.docking, made.settings)
    fill_record(parameters.supervisor, made.supervisor)
    made.plan["n_legs"], made.plan["standoff"], made.plan["speed"][:2] = 2, 1.5, 0.7
    made.plan["target"] = made.navigation["target"][2] = 0.0
    made.plan["target"][2] = made.navigation["target"][2] = 3.0
    made.docking["stage"], made.docking["side"] = e.TRANSIT, 1
    made.clock["time"] = 20.0
    return made


def test_far_out_the_legs_are_flown(dock) -> None:
    """Protects: no approach begins on a leg before the last, however near the target is."""
    dock.leg = 0
    assert dock.at(10.0).step() == e.FORWARD and dock.now == e.TRANSIT
    dock.leg = 1
    assert dock.at(60.0).step() == e.FORWARD and dock.now == e.TRANSIT


def test_a_line_that_can_be_joined_is_joined(dock) -> None:
    """Protects: straight before the dock the approach begins at once, and counts as a try."""
    assert dock.at(20.0).step() == e.FORWARD
    assert dock.now == e.APPROACH and dock.docking["tried"] == 1


def test_a_line_that_cannot_be_joined_is_flown_round_to(dock) -> None:
    """Protects: from the side the vehicle flies round first, in F, and approaches once on the line."""
    dock.at(12.0, aside=6.0, off_deg=90.0).step()
    assert dock.now == e.ENTRY and dock.mode == e.FORWARD and dock.docking["tried"] == 0
    dock.at(13.0, aside=0.3).step()
    assert dock.now == e.APPROACH


def test_a_current_that_cannot_be_held_ends_it_before_the_dock(dock) -> None:
    """Protects: without sideways thrust, a current abeam of the only approach is refused far out."""
    dock.navigation["current"][1] = 0.1
    assert dock.at(20.0).step() == e.HOVER
    assert dock.now == e.HOLD and dock.reason == e.CURRENT and dock.docking["back_to"] >= 20.0


def test_a_free_heading_turns_into_the_current(dock) -> None:
    """Protects: within its tolerance the approach heading is straight into the estimated current."""
    dock.navigation["current"][1] = 0.1
    dock.plan["heading_tolerance"] = np.pi
    dock.at(20.0).step()
    assert dock.now == e.ENTRY
    assert dock.docking["heading"] == pytest.approx(-np.pi / 2, abs=0.02)
    dock.plan["heading_tolerance"] = radians(30.0)
    dock.docking["stage"], dock.docking["heading"] = e.TRANSIT, 0.0
    dock.at(20.0).step()
    assert dock.reason == e.CURRENT  # 30 deg are not enough


def test_forward_brakes_in_sight_of_the_target(dock) -> None:
    """Protects: F hands over to R on the line at d_FR^L, and not without the target."""
    dock.stage(e.APPROACH, e.FORWARD)
    assert dock.at(8.0).step() == e.REVERSE and dock.now == e.APPROACH
    dock.stage(e.APPROACH, e.FORWARD).detected = 0
    assert dock.at(8.0).step() == e.FORWARD


@pytest.mark.parametrize(
    ("where", "seen", "why"),
    [((6.4, 0.0), 0, e.NOT_SEEN), ((6.4, 3.0), 1, e.OFF_LINE), ((6.4, 0.0, 0.0, 1.0), 1, e.OFF_DEPTH)],
)
def test_forward_never_goes_on_past_the_last_place_to_break_off(dock, where, seen, why) -> None:
    """Protects: what is not fit to brake leaves F before the dock: F never flies through it."""
    dock.stage(e.APPROACH, e.FORWARD).detected = seen
    assert dock.at(*where).step() == e.REVERSE
    assert dock.now == e.BACK and dock.reason == why


def test_the_gate_lets_pass_what_is_fit(dock) -> None:
    """Protects: H only behind an open gate."""
    dock.stage(e.APPROACH, e.REVERSE)
    dock.at(2.9).step()
    assert dock.docking["cleared"] == 1
    assert dock.at(0.4).step() == e.HOVER
    assert dock.at(1.6).step() == e.REVERSE  # pushed out again


@pytest.mark.parametrize("place", [(2.9, 0.5), (2.9, 0.0, 12.0), (2.9, 0.0, 0.0, 0.3)])
def test_a_gate_that_stays_shut_waves_off(dock, place) -> None:
    """Protects: too far aside, off the heading or the depth: wait at the gate, then go round again."""
    dock.stage(e.APPROACH, e.REVERSE).at(*place)
    dock.step(700)
    assert dock.docking["cleared"] == 0 and dock.now == e.APPROACH
    dock.step(200)
    assert dock.now == e.BACK and dock.reason == e.STUCK_AT_GATE


@pytest.mark.parametrize(
    ("mode", "where", "why"),
    [
        (e.REVERSE, (5.0, 2.0), e.OFF_LINE),
        (e.HOVER, (0.2, 0.5), e.OFF_LINE),
        (e.REVERSE, (5.0, 0.0, 45.0), e.OFF_HEADING),
        (e.HOVER, (0.2, 0.0, 25.0), e.OFF_HEADING),
        (e.HOVER, (0.2, 0.0, 0.0, 0.5), e.OFF_DEPTH),
        (e.HOVER, (-0.3,), e.OVERSHOT),
    ],
)
def test_what_leaves_its_limits_is_waved_off_astern(dock, mode, where, why) -> None:
    """Protects: every limit of the approach has its reason, and the way out is astern, never ahead."""
    dock.stage(e.APPROACH, mode).docking["cleared"] = 1
    assert dock.at(*where).step() == e.REVERSE
    assert dock.now == e.BACK and dock.reason == why


@pytest.mark.parametrize(("left", "patience"), [(5.0, 5.0), (0.3, 20.0)])
def test_a_lost_target_is_waved_off_in_time(dock, left, patience) -> None:
    """Protects: far out soon, close by later: there the last fix and the current carry it for a while."""
    dock.stage(e.APPROACH, e.REVERSE if left > 1 else e.HOVER).docking["cleared"] = 1
    dock.detected, dock.docking["fix_age"] = 0, int((patience - 0.5) / DT)
    dock.at(left).step()
    assert dock.now == e.APPROACH
    dock.docking["fix_age"] = int((patience + 0.5) / DT)
    dock.at(left).step()
    assert dock.now == e.BACK and dock.reason == e.TARGET_LOST


@pytest.mark.parametrize(("left", "lag"), [(5.0, 0.1), (5.0, -0.1), (2.0, -0.05)])
def test_what_does_not_keep_its_speed_is_waved_off_for_good(dock, left, lag) -> None:
    """Protects: a weak screw is noticed before the dock, sooner close by, and no second try is made."""
    dock.stage(e.APPROACH, e.REVERSE).docking["surge_lag"] = lag
    dock.at(left).step()
    assert dock.now == e.BACK and dock.reason == e.TOO_SLOW
    dock.at(9.0).step()
    assert dock.now == e.HOLD and dock.mode == e.HOVER


@pytest.mark.parametrize(("watched", "value"), [("unbraked", 0.05), ("unpushed", 0.08), ("slip", -1.0)])
@pytest.mark.parametrize("mode", [e.FORWARD, e.REVERSE])
def test_a_brake_that_fails_is_seen_in_forward_too(dock, mode, watched, value) -> None:
    """Protects: on the line, before and after the switch, a brake without thrust or that sticks waves off."""
    dock.stage(e.APPROACH, mode).docking[watched] = value
    dock.at(8.7).step()
    assert dock.now == e.BACK and dock.mode == e.REVERSE and dock.reason == e.TOO_SLOW


def test_far_out_a_turn_that_ends_is_no_weak_brake(dock) -> None:
    """Protects: a turn takes off more speed than drag alone; just after it a brake is not judged."""
    dock.stage(e.APPROACH, e.FORWARD).docking["unbraked"] = 0.2
    dock.at(15.0).step()
    assert dock.now == e.APPROACH and dock.mode == e.FORWARD


def test_the_brake_is_tried_while_there_is_room(dock) -> None:
    """Protects: drag alone brakes as planned, so a dead screw showed three metres before the point."""
    assert approach_most(dock.settings, 0.4, 7.0) == 0.4
    assert approach_most(dock.settings, 0.4, 6.0) == 0.28
    dock.settings["try_brake"] = 0.0
    assert approach_most(dock.settings, 0.4, 6.0) == 0.4


@pytest.mark.parametrize(("head", "speed"), [(0.0, 0.15), (0.2, 0.1), (-0.05, 0.1), (-0.12, 0.08)])
def test_a_way_back_makes_way_against_any_current(dock, head, speed) -> None:
    """Protects: at 0.03 m/s against a current from astern it wandered seven metres off the line and back."""
    assert back_speed(dock.settings, head) == pytest.approx(speed)


def test_past_the_dock_a_vehicle_without_a_brake_is_given_up(dock) -> None:
    """Protects: it turned away, has the dock abaft and is clear of it: its mission is over."""
    dock.stage(e.BACK, e.REVERSE).docking["reason"] = e.TOO_SLOW
    dock.docking["passing"], dock.docking["back_to"] = 1, 9.0
    dock.at(5.0, off_deg=60.0).step()
    assert dock.now == e.BACK
    dock.at(-5.0, aside=4.0, off_deg=60.0).step()
    assert dock.now == e.HOLD and dock.mode == e.HOVER and dock.reason == e.TOO_SLOW


def test_the_way_back_ends_in_another_approach(dock) -> None:
    """Protects: from the hold point, in line, the vehicle approaches again and counts it."""
    dock.stage(e.BACK, e.REVERSE).docking["back_to"] = 9.0
    assert dock.at(5.0).step() == e.REVERSE and dock.now == e.BACK
    assert dock.at(9.0).step() == e.REVERSE
    assert dock.now == e.APPROACH and dock.docking["tried"] == 2


def test_a_vehicle_out_of_line_goes_around(dock) -> None:
    """Protects: too far aside at the hold point, it flies round to the beginning of the line."""
    dock.stage(e.BACK, e.REVERSE).docking["back_to"] = 9.0
    assert dock.at(9.0, aside=3.0).step() == e.FORWARD
    assert dock.now == e.ENTRY


def test_a_short_way_back_out_of_line_becomes_a_long_one(dock) -> None:
    """Protects: no turn in F nearer to the dock than the hold point."""
    dock.stage(e.BACK, e.REVERSE).docking["back_to"] = 4.0
    assert dock.at(4.0, aside=2.0).step() == e.REVERSE
    assert dock.now == e.BACK and dock.docking["back_to"] == dock.settings["hold_distance"]


def test_blind_at_the_hold_point_it_waits_before_it_goes_around(dock) -> None:
    """Protects: a target that comes back is approached from where the vehicle is."""
    dock.stage(e.BACK, e.REVERSE).docking["back_to"] = 9.0
    dock.docking["fix_age"] = 1000
    dock.at(9.0).step(10)
    assert dock.now == e.BACK
    dock.step(int(dock.settings["patience"] / DT) + 1)
    assert dock.now == e.ENTRY


@pytest.mark.parametrize("why", [e.OFF_LINE, e.TARGET_LOST])
def test_after_the_last_try_it_gives_up(dock, why) -> None:
    """Protects: a stated number of tries, then the end with the last reason."""
    dock.stage(e.BACK, e.REVERSE, tried=int(dock.settings["tries"]))
    dock.docking["back_to"], dock.docking["reason"] = 9.0, why
    assert dock.at(9.0).step() == e.HOVER
    assert dock.now == e.HOLD and dock.reason == why
    dock.at(9.0).step(50)
    assert dock.now == e.HOLD


def test_a_current_that_came_up_ends_it_at_the_hold_point(dock) -> None:
    """Protects: no further try in a current that can't be held."""
    dock.stage(e.BACK, e.REVERSE).docking["back_to"] = 9.0
    dock.navigation["current"][1] = 0.08
    assert dock.at(9.0).step() == e.HOVER
    assert dock.now == e.HOLD and dock.reason == e.CURRENT
