"""The target's place from camera and USBL: late sights, false ones, and which of the two counts."""

import numpy as np
import pytest

from bumpless.control.navigation import NAVIGATION_OUTPUT, NAVIGATION_SETTINGS, NAVIGATION_STATE
from bumpless.control.target import find_target
from bumpless.physics.camera import view_from
from bumpless.physics.sensors import MEASUREMENT, SENSORS

TARGET = np.array([10.0, 1.0, 2.0])
DT = 0.05


class Seeker:
    """What navigation makes of sights and replies while the vehicle's own place is known exactly."""

    def __init__(self, gate: float = 0.0, latency: int = 0, usbl: bool = False) -> None:
        kinds = (NAVIGATION_SETTINGS, SENSORS, MEASUREMENT, NAVIGATION_STATE, NAVIGATION_OUTPUT)
        self.settings, self.sensors, self.m, self.state, self.out = (np.zeros(1, k)[0] for k in kinds)
        self.settings["fix_gate"] = gate
        self.sensors["camera_period"], self.sensors["camera_latency"] = 1, latency
        self.sensors["camera_range_std"], self.sensors["camera_bearing_std"] = 0.01, 0.0035
        self.sensors["usbl_period"] = 20 if usbl else 0
        self.sensors["usbl_range_std"], self.sensors["usbl_angle_std"] = 0.2, np.radians(1.0)
        self.state["target"] = TARGET

    def sight(self, place: np.ndarray, eta: np.ndarray | None = None) -> int:
        """The camera says that the target is at `place`, seen from `eta`; whether that was believed."""
        self.m["fresh"] = self.m["detected"] = 1
        at = self.state["eta"] if eta is None else eta
        view_from(np.zeros(3), 0.0, at, place, self.m["target"])
        return self._find()

    def reply(self, place: np.ndarray) -> None:
        """USBL says that the target is at `place`."""
        self.m["usbl_fresh"] = 1
        view_from(np.zeros(3), 0.0, self.state["eta"], place, self.m["usbl"])
        self._find()

    def wait(self, seconds: float) -> None:
        """Neither says anything."""
        for _ in range(round(seconds / DT)):
            self._find()

    def _find(self) -> int:
        find_target(DT, self.settings, self.sensors, self.m, self.state, self.out)
        self.m["fresh"] = self.m["detected"] = self.m["usbl_fresh"] = 0
        return int(self.out["sighted"])

    @property
    def off(self) -> float:
        """Error of the target's place, m."""
        return float(np.linalg.norm(self.state["target"] - TARGET))


def test_a_late_sight_is_laid_out_from_where_it_was_taken() -> None:
    """Protects: half a second at 0.6 m/s while turning at 6 deg/s would be 0.5 m and more; the place is
    right to a centimetre."""
    late, blind = Seeker(latency=10), Seeker()
    for seeker in (late, blind):
        speed, turn = 0.6, np.radians(6.0)
        for k in range(40):
            now, then = k * DT, (k - 10) * DT
            eta = [np.zeros(6), np.zeros(6)]
            for pose, t in zip(eta, (now, then), strict=True):
                pose[:3] = speed / turn * np.sin(turn * t), speed / turn * (1 - np.cos(turn * t)), 2.0
                pose[5] = turn * t
            seeker.state["eta"], seeker.state["nu"] = eta[0], [speed, 0, 0, 0, 0, turn]
            seeker.sight(TARGET, eta[1])
    assert blind.off > 0.5
    assert late.off < 0.02


def test_false_sights_are_passed_over() -> None:
    """Protects: with one false fix in four, anywhere in view, the place stays within the gate's reach and
    none of them counts as a detection; ungated they throw it off by metres."""
    rng = np.random.default_rng(2)
    gated, open_ = Seeker(gate=0.5), Seeker()
    worst = {gated: 0.0, open_: 0.0}
    for _ in range(800):
        false = rng.random() < 0.25
        place = np.array([rng.uniform(1, 12), rng.uniform(-5, 5), rng.uniform(0, 5)]) if false else TARGET
        for seeker in (gated, open_):
            said = seeker.sight(place)
            worst[seeker] = max(worst[seeker], seeker.off)
            if seeker is gated and np.linalg.norm(place - TARGET) > 1.6:
                assert said == 0
            if not false:
                assert said == 1
    assert worst[gated] < 0.2 and worst[open_] > 1.0


def test_three_fixes_that_agree_are_believed_against_the_plan() -> None:
    """Protects: a target far off its planned place is found at the third sight, false ones in between or not
    only delay it."""
    seeker = Seeker(gate=0.5)
    seeker.state["target"] = TARGET + [2.0, -2.0, 0.0]
    assert [seeker.sight(TARGET) for _ in range(3)] == [0, 0, 1]
    assert seeker.off < 1e-9
    seeker.state["target"] = TARGET + [2.0, -2.0, 0.0]
    said = [
        seeker.sight(place) for place in (TARGET, TARGET, np.array([4.0, 4.0, 1.0]), TARGET, TARGET, TARGET)
    ]
    assert said == [0, 0, 0, 0, 0, 1]


@pytest.mark.parametrize("gate", [0.0, 0.5])
def test_a_fix_that_is_no_number_is_none(gate: float) -> None:
    """Protects: NaN from either sensor leaves every number of the state finite."""
    seeker = Seeker(gate, usbl=True)
    for _ in range(4):
        seeker.sight(np.full(3, np.nan))
        seeker.reply(np.full(3, np.nan))
    assert seeker.off == 0.0 and np.isfinite(seeker.state["target_variance"])


def test_usbl_leads_until_the_camera_sees() -> None:
    """Protects: replies bring a target 5 m off its planned place to within 0.3 m, better the nearer they are
    taken; once the camera has seen it they no longer move it, and later they count again."""
    rng, seeker = np.random.default_rng(5), Seeker(gate=0.5, usbl=True)
    seeker.state["target"] = TARGET + [3.0, 4.0, 0.0]
    for north in np.linspace(-40.0, 2.0, 60):
        seeker.state["eta"][:3] = north, 0.0, 2.0
        distance = TARGET[0] - north
        seeker.reply(
            TARGET + rng.standard_normal(3) * [0.2, np.radians(1) * distance, np.radians(1) * distance]
        )
        seeker.wait(0.95)
    assert seeker.off < 0.3
    for _ in range(30):
        seeker.sight(TARGET)
    seeker.reply(TARGET + [0.0, 0.4, 0.0])
    assert seeker.off < 0.02
    seeker.wait(600.0)
    before = seeker.off
    seeker.reply(TARGET + [0.0, 0.4, 0.0])
    assert seeker.off - before > 0.1


def test_a_false_reply_is_passed_over() -> None:
    """Protects: the gate of USBL as well."""
    seeker = Seeker(gate=0.5, usbl=True)
    for k in range(40):
        seeker.reply(TARGET if k % 4 else np.array([-30.0, 20.0, 8.0]))
    assert seeker.off < 1e-6
