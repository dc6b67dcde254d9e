"""Scales from flights of drawn vehicles, each within its interval; silence where a flight can't know."""

from functools import cache

import numpy as np
import pytest

import bumpless
from bumpless.campaign.plant import Alteration
from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import Vehicle
from bumpless.identify import Estimate, Flight, Found, flight_of, identify
from bumpless.identify.scales import DRAG_ACROSS, DRAG_ALONG, LIFT, THRUST, scales_of
from bumpless_paper.study.fly import Job, fly
from bumpless_paper.study.plants import NOMINAL, WIDE, Plant, draw

PLANTS = (60, 61, 64, 66, 69, 72)
STEADY = """\
version: 1
name: steady
title: Straight on
summary: One speed, one heading.
vehicle: ts100
duration_s: 40
seed: 5
start: {position_ned_m: [0, 0, 2], heading_deg: 0, speed_mps: 0.7}
legs: [{to_ned_m: [200, 0, 2], speed_mps: 0.7}]
target: {position_ned_m: [201.5, 0, 2], heading_deg: 0, standoff_m: 1.5}
"""


@cache
def _flight(scenario: str, plant: Plant) -> Flight:
    return Flight.from_log(fly(Job(scenario, plant.number + 1, plant)).log, 7)


def _truth(plant: Plant, one: Estimate) -> float:
    parts = {
        THRUST: plant.thrust,
        LIFT: plant.fin_lift,
        DRAG_ALONG: plant.drag_axial,
        DRAG_ACROSS: plant.drag_cross,
    }
    return parts[one.scale.what]


def _of_screw(found: Found) -> Estimate:
    return next(one for one in found.estimates if one.scale.names == ("n_p",))


@pytest.mark.parametrize("number", PLANTS)
def test_a_flight_tells_the_scales_of_a_drawn_vehicle(ts100: Vehicle, number: int):
    """Protects: thrust and lift found to a few percent from one flight, and intervals that hold the truth."""
    plant = draw(number, WIDE)
    found = identify([_flight("S4", plant)], ts100)
    for one in found.estimates:
        low, high = one.interval
        spare = 0.25 * (high - low)  # six plants by five scales: some lie outside of a 95 % interval
        assert low - spare < _truth(plant, one) < high + spare, one.scale.title
    assert abs(_of_screw(found).value - plant.thrust) < 0.06
    told = {one.scale.what for one in found.estimates if one.told}
    assert {THRUST, LIFT} <= told
    assert all(one.steady for one in found.estimates)


def test_a_vehicle_as_its_file_is_found_so(ts100: Vehicle):
    """Protects: no scale where there is none."""
    for one in identify([_flight("S4", NOMINAL)], ts100).estimates:
        low, high = one.interval
        assert low < 1.0 < high, one.scale.title


def test_steady_flight_tells_no_thrust(ts100: Vehicle):
    """Protects: thrust and drag, which balance, are not told apart by guessing; nothing is written."""
    mission = parse_mission(STEADY, "steady.yaml", ts100)
    run = bumpless.fly(mission, ts100, alter=Alteration(thrust=0.85))
    found = identify([flight_of(run)], ts100)
    screw = _of_screw(found)
    assert not screw.told
    assert screw.interval[0] < 0.85 < screw.interval[1]
    assert screw.scale not in found.factors
    verticals = next(one for one in found.estimates if one.scale.names == ("n_v1", "n_v2"))
    assert not verticals.told


def test_two_flights_tell_more_than_one(ts100: Vehicle):
    """Protects: what is learned goes on from flight to flight."""
    plant = draw(60, WIDE)
    flights = [Flight.from_log(fly(Job("S4", seed, plant)).log, 7) for seed in (5, 6)]
    one, both = (identify(flights[:n], ts100) for n in (1, 2))
    assert both.flown_s == pytest.approx(2.0 * one.flown_s, abs=1.0)
    assert all(b.std <= a.std for a, b in zip(one.estimates, both.estimates, strict=True))


def test_a_fault_is_no_scale(ts100: Vehicle):
    """Protects: a screw that loses effect in flight is not learned as a weak screw, told of or not."""
    plant = draw(60, WIDE)
    nobody_knew = identify([_flight("S5", plant)], ts100)
    assert not _of_screw(nobody_knew).steady
    assert _of_screw(nobody_knew).scale not in nobody_knew.factors
    found_in_flight = identify([_flight("S7", plant)], ts100)
    assert found_in_flight.left_out_s > 20.0
    low, high = _of_screw(found_in_flight).interval
    assert low < plant.thrust < high


def test_gaps_and_broken_numbers_are_left_out(ts100: Vehicle):
    """Protects: a log that lost cycles, or holds a number that is none, is used as far as it goes."""
    whole = _flight("S4", draw(60, WIDE))
    rows = np.ones(len(whole), bool)
    rows[300:420] = False
    holed = whole[rows]
    holed.nu[50, 0] = np.nan
    found, all_of_it = identify([holed], ts100), identify([whole], ts100)
    assert found.flown_s < all_of_it.flown_s - 5.0
    for a, b in zip(found.estimates, all_of_it.estimates, strict=True):
        assert abs(a.value - b.value) < 2.0 * max(a.std, b.std)


def test_nothing_to_go_by_is_refused(ts100: Vehicle):
    """Protects: no estimate from no flight."""
    with pytest.raises(ValueError, match="nothing to identify from"):
        identify([_flight("S4", draw(60, WIDE))[:10]], ts100)


def test_actuators_of_one_type_share_a_scale():
    """Protects: a scale for each kind of actuator of every vehicle that ships."""
    groups = {
        name: [one.names for one in scales_of(bumpless.load_vehicle(name)) if one.names]
        for name in bumpless.vehicle_names()
    }
    assert groups["ts100"] == [("delta_1", "delta_2", "delta_3", "delta_4"), ("n_p",), ("n_v1", "n_v2")]
    assert all(groups.values())
