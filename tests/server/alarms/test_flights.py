"""Alarms over whole flights: one that goes well raises none about how it follows its references."""

import math
from pathlib import Path
from typing import Any

import pytest

import bumpless
from bumpless_server.alarms.conditions import Conditions
from bumpless_server.alarms.limits import Limits

MISSIONS = Path(__file__).parents[3] / "missions"


def alarms_of(run: bumpless.Run) -> set[str]:
    """Codes of everything that was ever alarmed at, from what the vehicle said."""
    conditions, codes = Conditions(Limits(), lambda: math.inf), set()
    for topic, message in run.messages():
        told: Any = message
        heard = conditions.hear(topic, message, told.stamp.time_ns)
        codes |= {code for code, cause in heard if cause is not None}
    return codes


@pytest.mark.parametrize("name", ["docking", "docking_into_current", "docking_current"])
def test_a_flight_that_docks_raises_no_alarm(name) -> None:
    """Protects: on a way round the offset was told from a line that was not flown yet, 19 m away, and the
    heading lagged 20 deg behind its reference in every turn: operators learn to look away."""
    run = bumpless.fly(bumpless.load_mission(MISSIONS / f"{name}.yaml"))
    assert run.outcome.ending == "docked"
    assert alarms_of(run) == set()
