"""What a vehicle's file declares for each failure is what the vehicle does, once, and says."""

from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.config.vehicle.failsafe import REACTIONS, WORDS, Failsafe
from bumpless.contract.enums import ABORTED, ALARM, BACK, COMPLETED, HOLD, PAUSED, RUNNING
from bumpless.node.failsafe import ClockWatch, Watch
from bumpless.node.flight import Flight
from bumpless.sim.condition import Condition
from bumpless.sim.events import TwinEvent
from bumpless.sim.log import LOG
from bumpless.sim.twin import Twin
from tests.node.light import LightTwin

MISSIONS = Path(__file__).parents[2] / "missions"
PERIOD_S = 0.05
WELL = Condition()


def row(**said: Any) -> np.void:
    """A LOG row of a healthy vehicle, but for what is said."""
    log = np.zeros(1, LOG)
    log["detected"] = 1
    for name, value in said.items():
        log[name] = value
    return log[0]


def told(declared: Failsafe, *rows: np.void, condition: Condition = WELL, phase: int = RUNNING):
    watch = Watch(declared, PERIOD_S)
    return [(code, does) for one in rows for code, _, does in watch.look(one, phase, condition)]


@pytest.mark.parametrize(
    ("declared", "bad", "cause"),
    [
        (Failsafe(depth_most_m=5.0), {"depth": 5.1}, ("depth_exceeded", "surface")),
        (Failsafe(distance_most_m=50.0), {"eta_hat": [40, 40, 2, 0, 0, 0]}, ("boundary_exceeded", "hold")),
        (Failsafe(actuator_fault="wave_off"), {"faults": 4}, ("actuator_fault", "wave_off")),
        (Failsafe(), {"eta_hat": [np.nan, 0, 2, 0, 0, 0]}, ("not_finite", "abort")),
        (Failsafe(), {"u": np.inf}, ("not_finite", "abort")),
    ],
)
def test_each_cause_is_told_once_and_again_when_it_returns(
    declared: Failsafe, bad: dict[str, Any], cause: tuple[str, str]
) -> None:
    """Protects: an operator who resumes knowingly is not stopped each cycle, nor left alone the next time."""
    assert told(declared, row(), row(**bad), row(**bad), row(), row(**bad)) == [cause, cause]


def test_what_the_body_reports_counts() -> None:
    """Protects: a leak and an empty battery are seen in every phase in which the vehicle moves."""
    low = Failsafe(battery_least=0.2)
    for phase in (RUNNING, PAUSED, COMPLETED):
        assert told(low, row(), condition=Condition(leak=True), phase=phase) == [("leak", "surface")]
        found = told(low, row(), condition=Condition(battery=0.19), phase=phase)
        assert found == [("battery_low", "surface")]
    assert told(low, row(), condition=Condition(battery=0.21)) == []
    assert told(Failsafe(), row(), condition=Condition(battery=0.0)) == []


def test_a_missing_target_is_waited_for_only_while_it_is_looked_for() -> None:
    """Protects: time in a pause is no time without the target, and a sighting begins anew."""
    declared = Failsafe(target_missing_s=1.0)
    blind = [row(detected=0)] * 19
    assert told(declared, *blind) == []
    assert told(declared, *blind, row(), *blind) == []
    assert told(declared, *blind, row(detected=0), row(detected=0)) == [("target_missing", "hold")]
    assert told(declared, *blind, *blind, phase=PAUSED) == []


def test_a_jump_of_the_clock_is_noticed_and_its_going_on_is_not() -> None:
    """Protects: a clock set by an hour or by ten years must not pass for the passing of time."""
    times = {"wall": 0, "steady": 0}
    watch = ClockWatch(2.0, lambda: times["wall"], lambda: times["steady"])

    def after(steady_s: float, wall_s: float) -> float | None:
        times["steady"] += round(steady_s * 1e9)
        times["wall"] += round(wall_s * 1e9)
        return watch.jump_s()

    assert after(3600.0, 3601.0) is None
    assert after(0.25, 3600.25) == pytest.approx(3600.0)
    assert after(0.25, 0.25) is None
    assert after(0.25, -3599.75) == pytest.approx(-3600.0)
    ten_years = 10 * 365.25 * 86400
    assert after(0.25, ten_years) == pytest.approx(ten_years - 0.25)


def flown(
    name: str, declared: Failsafe, until: Callable[[Flight], bool], more: str = "", within_s: float = 300.0
) -> tuple[Flight, list[TwinEvent]]:
    """Fly a shipped mission with a real twin in virtual time; its failsafes and its mission are amended."""
    vehicle = replace(load_vehicle("ts100"), failsafe=declared)
    mission = parse_mission((MISSIONS / name).read_text() + more, name, vehicle)
    twin = Twin(vehicle)
    flight = Flight(twin, declared, vehicle.control_period_s)
    events: list[TwinEvent] = []
    assert flight.start(mission, None, twin.parameters, "run").accepted
    for _ in range(round(within_s / vehicle.control_period_s)):
        events += flight.step()[1]
        if until(flight):
            return flight, events
    raise AssertionError(f"it did not come; {[e.code for e in events]}")


def acted(events: list[TwinEvent]) -> list[tuple[str, str]]:
    return [
        (e.details["cause"], e.details["reaction"])
        for e in events
        if e.code == "failsafe" and e.severity == ALARM
    ]


def test_a_leak_brings_the_vehicle_to_the_surface() -> None:
    """Protects: the reaction is flown, not only told: the vehicle holds station where it can be fetched."""
    _, events = flown(
        "s4_mdca_bumpless.yaml",
        Failsafe(),
        lambda f: f.place is not None and f.place[2] < 0.3 and f.twin.phase == PAUSED,
        "\nmishaps: [{at_s: 20, what: leak}]\n",
    )
    assert acted(events) == [("leak", "surface")]
    assert "surfacing" in {event.code for event in events}


def test_beyond_its_depth_and_its_boundary_it_holds_or_stops() -> None:
    """Protects: two causes at once: the harder reaction stays in force, and each is said."""
    declared = Failsafe(
        distance_most_m=8.0, boundary_exceeded="hold", depth_most_m=0.5, depth_exceeded="abort"
    )
    _, events = flown("docking.yaml", declared, lambda f: f.twin.phase == ABORTED)
    assert acted(events) == [("depth_exceeded", "abort")]
    held, events = flown(
        "docking.yaml", replace(declared, depth_most_m=0.0), lambda f: f.twin.phase == PAUSED
    )
    assert acted(events) == [("boundary_exceeded", "hold")]
    assert held.place is not None and np.hypot(*held.place[:2]) == pytest.approx(8.0, abs=0.2)


def test_a_low_battery_waves_an_approach_off() -> None:
    """Protects: near a dock the way out is back along the line, once, and no further try is begun."""
    begun: list[int] = []

    def ended(flight: Flight) -> bool:
        assert isinstance(flight.twin, Twin)
        begun.append(int(flight.twin.onboard["state"]["docking"]["stage"]))
        return begun[-1] == HOLD

    declared = Failsafe(battery_least=0.3, battery_low="wave_off")
    _, events = flown(
        "docking.yaml", declared, ended, "\nmishaps: [{at_s: 60, what: battery, battery: 0.1}]\n", 600.0
    )
    assert acted(events) == [("battery_low", "wave_off")]
    assert BACK in begun


def test_a_state_that_is_no_number_stops_the_actuators() -> None:
    """Protects: out of the box, without a word in any file."""

    class Odd(LightTwin):
        def step(self) -> Any:
            line = super().step()
            if self.steps > 5:
                line["eta_hat"][2] = np.nan
            return line

    vehicle = load_vehicle("ts100")
    flight = Flight(Odd(vehicle))
    mission = parse_mission((MISSIONS / "docking.yaml").read_text(), "docking.yaml", vehicle)
    flight.start(mission, None, flight.chosen, "run")
    events = [event for _ in range(10) for event in flight.step()[1]]
    assert flight.twin.phase == ABORTED and acted(events) == [("not_finite", "abort")]


def test_a_milder_reaction_undoes_no_harder_one() -> None:
    """Protects: a vehicle on its way up must not stop halfway because the console falls silent as well."""
    vehicle = load_vehicle("ts100")
    flight = Flight(LightTwin(vehicle))
    mission = parse_mission((MISSIONS / "docking.yaml").read_text(), "docking.yaml", vehicle)
    flight.start(mission, None, flight.chosen, "run")
    flight.react("leak", "It reports a leak", "surface")
    reply = flight.react("heartbeat_lost", "No word from the console", "hold")
    assert "holds station at the surface already" in reply.reason
    flight.react("not_finite", "No numbers", "abort")
    assert flight.twin.phase == ABORTED
    assert [e.code for e in flight.step()[1]].count("failsafe") == 3


def test_everything_declared_is_told_before_a_start() -> None:
    """Protects: "what happens when" leaves out no field of the declaration."""
    causes = {one.cause for one in Failsafe().declared()}
    named = {field.name for field in fields(Failsafe)}
    limits = {name for name in named if name.endswith(("_s", "_m", "_least"))}
    assert named - limits <= causes and causes - named == {"keep_in_left"}
    assert all(one.reaction == "none" for one in Failsafe().declared() if one.unit)
    assert set(WORDS) == set(REACTIONS)


def test_a_mission_below_the_rating_is_refused() -> None:
    """Protects: what the hull does not bear is not begun, wherever in the mission it stands."""
    text = (MISSIONS / "docking.yaml").read_text()
    deep = replace(load_vehicle("ts100"), depth_rating_m=1.0)
    with pytest.raises(MissionError, match="no deeper than 1 m, which ts100 bears"):
        parse_mission(text, "docking.yaml", deep)
    parse_mission(text, "docking.yaml", replace(deep, depth_rating_m=500.0))
