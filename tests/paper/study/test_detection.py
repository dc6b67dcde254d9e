"""S7: in the closed loop the autopilot finds the propeller's fault by itself, and none that is not there."""

from collections.abc import Callable

import numpy as np
import pytest

from bumpless.sim.twin import Result
from bumpless_paper.study.detection import detection_of
from bumpless_paper.study.fly import Job, fly
from bumpless_paper.study.plants import draw

Flight = Callable[[str], Result]
N_P = 4


def test_s7_finds_the_propeller_and_what_is_left_of_it(flight: Flight) -> None:
    """Protects: delay, isolation and estimate of the flight that the report shows; nobody told it."""
    found = detection_of(flight("S7"))
    assert found.fault_at_s == pytest.approx(45.05)
    assert 0.0 < found.delay_s < 4.0
    assert found.isolated is True and found.false_alarms == 0
    assert found.effectiveness == pytest.approx(0.4) and found.error < 0.03


def test_s7_says_so(flight: Flight) -> None:
    """Protects: the operator hears of the fault once, by the actuator's name."""
    events = [e for e in flight("S7").events if e.code.startswith("fault")]
    assert [e.code for e in events] == ["fault_detected"]
    assert events[0].details["actuator"] == "n_p" and "n_p" in events[0].text
    assert 45.0 < events[0].time_s < 49.5


def test_s7_reconfigures_as_s6_does(flight: Flight) -> None:
    """Protects: after the alarm the demand is met far better than without fault tolerance."""
    missed = {}
    for name in ("S5", "S6", "S7"):
        log = flight(name).log
        late = log["time"] > 52.0
        missed[name] = float(np.sqrt(np.mean((log["tau_d"][late, 0] - log["tau"][late, 0]) ** 2)))
    assert missed["S7"] < 0.5 * missed["S5"]
    assert missed["S7"] < missed["S6"] + 0.1


def test_watching_changes_nothing_until_a_fault_is_found(flight: Flight) -> None:
    """Protects: without a fault S7 flies S4's flight to the bit, for no alarm is raised."""
    watched, plain = flight("S7-healthy").log, flight("S4").log
    assert not watched["faults"].any()
    for name in ("eta", "nu", "u", "tau_d", "tau_c", "slack"):
        assert np.array_equal(watched[name], plain[name]), name


def test_no_alarm_on_the_loudest_plants_without_a_fault() -> None:
    """Protects: drag, current, trim, lag and noise of drawn plants are not mistaken for a fault."""
    loudest = sorted((draw(i) for i in range(60)), key=lambda p: -p.noise)[:4]
    for plant in loudest:
        assert not fly(Job("S7-healthy", plant.number + 1, plant)).log["faults"].any(), plant.number


def test_told_faults_are_not_diagnosed(flight: Flight) -> None:
    """Protects: in S6 the log carries the told effectiveness, and no fault counts as found."""
    log = flight("S6").log
    assert not log["faults"].any()
    assert log["effectiveness_hat"][-1, N_P] == pytest.approx(0.4)
    assert detection_of(flight("S6")).isolated is None
