"""Which headings hold station, as told: by the function that the check uses, heading by heading."""

from typing import Any, cast

import numpy as np
import pytest

import bumpless
from bumpless.config.mission import parse_mission
from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.feasibility import ACCEPT, REFUSE, check_mission, station_keeping, station_of
from bumpless_server.foresight import held
from bumpless_server.foresight.told import HeldStation
from bumpless_server.live.state import State

WORDS = {"accepted": 2, "warned": 1, "refused": 0}
TEXT = """
version: 1
name: abeam
vehicle: {vehicle}
duration_s: 120
start: {{position_ned_m: [0, 0, 2], heading_deg: 0, speed_mps: 0.7}}
legs: [{{to_ned_m: [24.5, 0, 2], speed_mps: 0.7}}]
target: {{position_ned_m: [26, 0, 2], heading_deg: 0, standoff_m: 1.5}}
environment: {{current_ned_mps: [{north}, {east}, 0]}}
"""


def mission(vehicle: str, north: float, east: float) -> bumpless.Mission:
    return parse_mission(TEXT.format(vehicle=vehicle, north=north, east=east), "abeam.yaml")


def zones(told: HeldStation) -> np.ndarray:
    """By heading, 0 to 359; each is told once."""
    found = np.full(360, -1)
    for arc in told.arcs:
        first, last = round(arc.from_deg), round(arc.to_deg)
        for heading in range(first, first + (last - first) % 360 + 1):
            assert found[heading % 360] == -1
            found[heading % 360] = WORDS[arc.zone]
    return found


@pytest.mark.parametrize("vehicle", ["ts100", "twinpod", "bluerov2_heavy"])
@pytest.mark.parametrize("flow", [(0.0, 0.0), (-0.1, 0.0), (0.05, 0.05), (0.0, 0.12), (0.3, -0.2)])
def test_the_arcs_are_the_check_s_own_zones(vehicle: str, flow: tuple[float, float]) -> None:
    """Protects: what is drawn round the dock and what the check says of the plan are one thing."""
    planned = mission(vehicle, *flow)
    station = station_of(planned)
    assert station is not None
    told = held.told(station, planned.environment.current_ned_mps)
    assert (zones(told) == station.zone).all()
    codes = {finding.code for finding in check_mission(planned)}
    assert ("current_not_holdable" in codes) == (told.zone == "refused")
    assert ("current_hard_to_hold" in codes) == (told.zone == "warned")
    assert bool(told.reason) == (told.zone != "accepted")


def test_a_vehicle_that_only_passes_by_has_no_arcs() -> None:
    """Protects from a red ring about a funnel that is entered at speed."""
    assert station_of(mission("remus100", 0.0, 0.1)) is None


class Said:
    """A bus on which all was said."""

    link = pb.LINK_STATE_LIVE

    def __init__(self, **messages: Any) -> None:
        self._messages = messages

    def say(self, **messages: Any) -> None:
        self._messages |= messages

    def latest(self, topic: str) -> Any:
        return self._messages.get(topic)


def flying(north: float, east: float, heading: float, phase: int = pb.MISSION_PHASE_RUNNING) -> Said:
    navigation, target = pb.Navigation(), pb.Target(heading_deg=heading)
    navigation.current_estimate_ned_mps.x, navigation.current_estimate_ned_mps.y = north, east
    status = pb.MissionStatus(phase=cast(pb.MissionPhase, phase))
    return Said(mission=status, navigation=navigation, target=target)


def now(said: Said) -> HeldStation | None:
    return held.station_now(cast(State, said), load_vehicle("ts100"))


def test_in_flight_the_estimate_counts_and_the_heading_that_was_taken() -> None:
    """Protects: the plan's current is not the water's; the vehicle goes by what it estimates."""
    told = now(flying(-0.1, 0.0, 0.0))
    assert told is not None and (told.zone, told.heading_deg) == ("accepted", 0.0)
    turned = now(flying(-0.1, 0.0, 90.0))
    assert turned is not None and turned.zone == "refused" and "abeam" in turned.reason
    vehicle, target = load_vehicle("ts100"), mission("ts100", 0.0, 0.0).target
    alone = station_keeping(vehicle, default_parameters(vehicle), (-0.1, 0.0, 0.0), target)
    assert (zones(turned) == alone.zone).all()
    assert {int(zone) for zone in alone.zone} >= {ACCEPT, REFUSE}


def test_in_transit_the_heading_counts_that_it_would_take() -> None:
    """Protects: a mission into the current began with "can't hold", of a heading that is never flown."""
    said = flying(0.0, 0.1, 0.0)
    text = TEXT.format(vehicle="ts100", north=0.0, east=0.1).replace(
        "standoff_m", "approach: into_current, standoff_m"
    )
    said.say(plan=pb.Plan(mission_yaml=text, file_name="abeam.yaml"))
    said.say(supervisor=pb.Supervisor(docking_stage=pb.DOCKING_STAGE_TRANSIT))
    ahead = now(said)
    assert ahead is not None and (ahead.zone, round(ahead.heading_deg)) == ("accepted", 270)
    said.say(supervisor=pb.Supervisor(docking_stage=pb.DOCKING_STAGE_APPROACH))
    taken = now(said)
    assert taken is not None and (taken.zone, taken.heading_deg) == ("refused", 0.0)


def test_where_nothing_flies_nothing_is_said() -> None:
    """Protects from arcs of a flight that is over, and from numbers that are none."""
    assert now(flying(-0.1, 0.0, 0.0, pb.MISSION_PHASE_ABORTED)) is None
    assert now(flying(float("nan"), 0.0, 0.0)) is None
    lost = flying(-0.1, 0.0, 0.0)
    lost.link = pb.LINK_STATE_LOST
    assert now(lost) is None
    assert held.station_now(cast(State, lost), None) is None
