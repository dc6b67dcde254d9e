"""How a flight is judged."""

import numpy as np
import pytest

from bumpless.campaign.declaration import Docked
from bumpless.campaign.geometry import nose_x
from bumpless.campaign.outcome import Judge
from bumpless.campaign.tracking import cost, shaft_energy, tracking
from bumpless.config.mission import shipped_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import HOVER, REVERSE, RUNNING
from bumpless.metrics import Columns, Ending, outcome_of
from bumpless.sim.twin import new_log

MISSION = shipped_mission("docking")
RULE = Docked()
HOLD = 200  # cycles of 10 s


@pytest.fixture
def hovering(ts100):
    """Makes a log of a vehicle at rest in hover, so far before the observation point."""

    def made(rows: int, short_m: float = 0.0) -> np.ndarray:
        log = new_log(rows)
        log["mode"], log["phase"], log["kappa"] = HOVER, RUNNING, 1.0
        log["time"] = np.arange(rows) * ts100.control_period_s
        log["eta"][:, :3] = MISSION.target.observation_point_ned_m
        log["eta"][:, 0] -= short_m
        return log

    return made


def judged(log, vehicle, block):
    """Judge in blocks of so many rows."""
    judge = Judge(MISSION, vehicle, RULE)
    for end in range(block, len(log) + block, block):
        decided = judge.look(log[:end])
        if decided:
            return decided
    return judge.over(log)


@pytest.mark.parametrize("block", [1, 7, 200, 1000])
def test_docked_after_the_hold_time(hovering, ts100, block):
    """Protects: docked is decided at one row however often the flight is looked at; breaks start anew."""
    log = hovering(600)
    log["nu"][149, 0] = 0.2
    decided = judged(log, ts100, block)
    assert (decided.outcome, decided.rows) == ("docked", 150 + HOLD)


def test_range_has_a_vertical_part(hovering, ts100):
    """Protects: a vehicle over the observation point, too high, has not docked."""
    log = hovering(600)
    log["eta"][:, 2] -= 0.2
    decided = judged(log, ts100, 200)
    assert (decided.outcome, decided.reason) == ("held", "in hover, position out of tolerance")


def test_what_is_out_of_tolerance_is_said(hovering, ts100):
    """Protects: the reason names each tolerance that was missed at the end."""
    log = hovering(300, short_m=1.0)
    log["eta"][:, 5] = np.radians(-6.0)
    assert judged(log, ts100, 200).reason == "in hover, position and heading out of tolerance"


def test_held_too_late(hovering, ts100):
    """Protects: within tolerances at the end of the mission, but not for the hold time, is `held`."""
    assert judged(hovering(HOLD - 1), ts100, 50).outcome == "held"


def test_the_nose_must_not_touch_the_marker(hovering, ts100):
    """Protects: a flight through the dock is a collision even when it would have docked later."""
    log = hovering(600)
    standoff = MISSION.target.standoff_m
    log["eta"][120, 0] += standoff - nose_x(ts100)
    decided = judged(log, ts100, 200)
    assert (decided.outcome, decided.rows) == ("collided", 121)


def test_a_broken_simulation_is_no_success(hovering, ts100):
    """Protects: states that are not finite end a flight as aborted."""
    log = hovering(600)
    log["eta"][50:, 4] = np.nan
    assert judged(log, ts100, 200).reason == "the simulation broke down"


def test_tracking_is_of_the_reference_by_mode(hovering):
    """Protects: errors are taken against the reference, in their units, and of the mode they belong to."""
    log = hovering(100)
    log["reference"][:, 2] = log["eta"][:, 2] + 0.1
    log["reference"][:, 5] = np.radians(359.0)
    log["reference"][0, 2] += 0.4
    found = tracking(log)
    assert found["hover_depth_m_worst"] == pytest.approx(0.5)
    assert found["hover_depth_m_rms"] == pytest.approx(np.sqrt((99 * 0.01 + 0.25) / 100))
    assert found["hover_heading_deg_worst"] == pytest.approx(1.0)
    assert np.isnan(found["forward_depth_m_rms"])


def test_the_largest_step_is_sought_past_the_ramp(hovering, ts100):
    """Protects: a step that the ramp put off counts, one long after or before the switch does not."""
    log = hovering(1000)
    log["mode"][:100] = REVERSE
    log["kappa"][100:140] = 0.5
    screw = ts100.slots("thruster")[0]
    top = ts100.commands[screw].upper / 60.0
    for row, share in ((50, 0.5), (250, 0.2), (800, 0.9)):
        log["u"][row, screw] = share * top
    assert cost(log, ts100)["largest_step"] == pytest.approx(0.2)


def test_energy_is_shaft_work(hovering, ts100):
    """Protects: 2 pi n Q over the time, with Q = rho D^5 K_Q n^2 in still water."""
    log = hovering(200)
    screw = ts100.slots("thruster")[0]
    maker = ts100.actuators[screw]  # each has one command
    log["u_feedback"][:, screw] = 10.0
    torque = 1000.0 * maker.diameter_m**5 * maker.torque_coefficient * 100.0
    assert shaft_energy(log, ts100) == pytest.approx(2.0 * np.pi * 10.0 * torque * 10.0)


def test_the_judge_agrees_with_the_outcome_of_a_run(flight):
    """Protects: a campaign counts as docked what every run's own outcome calls so, from the same cycle on."""
    vehicle, decided = flight.vehicle, Judge(flight.mission, flight.vehicle, RULE).look(flight.log)
    assert decided is not None and decided.outcome == Ending.DOCKED
    for log in (flight.log[: decided.rows], flight.log[: decided.rows - 1], flight.log[:400]):
        judge = Judge(flight.mission, vehicle, RULE)
        ending = (judge.look(log) or judge.over(log)).outcome
        run = Columns.from_log(log, len(vehicle.commands))
        assert ending == outcome_of(run, "completed", vehicle.control_period_s).ending
        assert (ending == Ending.DOCKED) == (len(log) == decided.rows)


def test_energy_of_a_pod_counts_the_flow_along_its_thrust(hovering):
    """Protects: a pod turned by a quarter meets none of the flow from ahead, one that is not meets all."""
    pods = load_vehicle("twinpod")
    log = hovering(200)
    log["u_feedback"][:, 0] = 10.0
    still = shaft_energy(log, pods)
    log["nu_r_hat"][:, 0] = 0.5
    assert shaft_energy(log, pods) < 0.9 * still
    log["u_feedback"][:, 1] = np.pi / 2.0
    assert shaft_energy(log, pods) == pytest.approx(still)
